#!/usr/bin/env bash
# Draws the pictures of docs/gallery.md: ./waterlight gallery [NAME...], all of them where none is named. Each is a shipped
# scenario at one moment, with what --set changes here for the picture's sake.
set -euo pipefail

program=$1
shift
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$root/docs/gallery"
wanted=" $* "

# pack FROM TO: the same .png in fewer bytes.
pack() {
    /usr/bin/python3 - "$@" <<'PYTHON'
import sys
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

reader = vtkPNGReader()
reader.SetFileName(sys.argv[1])
writer = vtkPNGWriter()
writer.SetInputConnection(reader.GetOutputPort())
writer.SetCompressionLevel(9)
writer.SetFileName(sys.argv[2])
writer.Write()
PYTHON
}

# draw NAME SCENARIO TIME [--set KEY=VALUE]...: the frame of that time (s), 1120 x 630.
draw() {
    local name=$1 scenario=$2 time=$3
    shift 3
    [ "$wanted" = "  " ] || [[ $wanted == *" $name "* ]] || return 0
    echo "waterlight: gallery: $name" >&2
    "$program" run "$root/scenarios/$scenario.toml" --out "$scratch/$name" --quiet --set check=[] --set output.formats=[] \
        --set output.image=true --set camera.pixels=[1120,630] --set "waves.duration_s=$time" --set "output.every_s=$time" "$@"
    pack "$scratch/$name/images/scene_000001.png" "$root/docs/gallery/$name.png"
}

draw pool pool 6.5 --set 'caustics.walls={}'
draw pool_irradiance pool 6.5 --set picture.overlay=irradiance --set camera.pixels=[900,506]
draw pool_side pool_side 3.6 --set light.azimuth_deg=80 --set light.elevation_deg=50 --set water.scattering_per_m=0.2 \
    --set 'caustics.floor={ pixels = [1024, 683] }' --set 'caustics.walls={}' --set camera.fov_deg=36 \
    --set camera.reduction=2 --set picture.exposure_w_m2_sr=70 --set picture.sky.irradiance_w_m2=15 \
    --set picture.floor.albedo=[0.25,0.3,0.33] --set picture.walls.albedo=[0.15,0.2,0.23]
draw open_sea_below open_sea_below 1.0 --set camera.reduction=2
draw rain rain 2.0 --set light.elevation_deg=60
draw surf_zone surf_zone 9.0 --set light.elevation_deg=35 --set light.azimuth_deg=150 \
    --set picture.exposure_w_m2_sr=330
draw harbour harbour 0.5 --set camera.reduction=2 --set camera.position_m=[3.0,0.5,-0.6] \
    --set camera.target_m=[3.3,2.0,0.9] --set camera.fov_deg=75 --set picture.exposure_w_m2_sr=90
