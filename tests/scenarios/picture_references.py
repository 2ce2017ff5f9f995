#!/usr/bin/env python3
"""Pictures of the scene compared with kept ones by what an eye sees.

Usage: picture_references.py PROGRAM ROOT [--update] [NAME...]

The measure is the distance in CIELAB (CIE 1976, D65) that 5 % of the pixels exceed, after a blur of one pixel's standard
deviation in linear light, as from some distance; 1 is about what can just be seen side by side. The mean would hide what
changes in a few places only. A picture passes below TOLERANCE, which leaves room for another device's rounding and none
for another picture: each is drawn once more with the sun 5 degrees lower and, where there are tiles, with tiles of half
the size, and both must fail. --update keeps the pictures as they are now. Exit 77 where there is no Vulkan device.
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

TOLERANCE = 0.7

COMMON = ["check=[]", "output.formats=[]", "output.image=true", "camera.pixels=[320,180]"]
# Name, scenario, time (s), what is set, the other picture's settings.
PICTURES = [
    ("pool", "pool", 3.0, ["domain.cells=[256,192]", "caustics.floor.pixels=[512,384]", "camera.fov_deg=30"],
     {"sun": ["light.elevation_deg=55"], "tiles": ["picture.floor.tile_m=0.125", "picture.walls.tile_m=0.125"]}),
    ("pool_side", "pool_side", 2.0,
     ["domain.cells=[192,128]", "camera.reduction=2", "caustics.beams.volume_cells=[8,8,4]",
      "caustics.floor={pixels=[384,256]}", "caustics.walls={pixel_m=0.02}", "water.scattering_per_m=0.2"],
     {"sun": ["light.elevation_deg=55"], "tiles": ["picture.floor.tile_m=0.125", "picture.walls.tile_m=0.125"]}),
    ("surf_zone", "surf_zone", 6.0, ["domain.cells=[360,40]", "caustics.floor.pixels=[256,128]"],
     {"sun": ["light.elevation_deg=70"]}),
    ("sea_below", "gerstner_sea", 1.0,
     ["domain.cells=[128,128]", "water.scattering_per_m=0.05", "caustics.beams={grid=[128,128]}",
      "camera={position_m=[3.0,3.0,-1.5], target_m=[4.5,4.0,-0.2], fov_deg=80, reduction=2}"],
     {"sun": ["light.elevation_deg=55"]}),
]


def image(path):
    """Rows from the top, red, green and blue from 0 to 1."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    output = reader.GetOutput()
    width, height, _ = output.GetDimensions()
    values = vtk_to_numpy(output.GetPointData().GetScalars())
    return values.reshape(height, width, -1)[::-1, :, :3] / 255.0


def blurred(linear):
    kernel = np.exp(-0.5 * np.arange(-3, 4) ** 2.0)
    kernel /= kernel.sum()
    for axis in (0, 1):
        margins = [(3, 3) if a == axis else (0, 0) for a in range(3)]
        padded = np.pad(linear, margins, mode="edge")
        length = linear.shape[axis]
        linear = sum(k * np.take(padded, range(i, i + length), axis) for i, k in enumerate(kernel))
    return linear


def lab(srgb):
    """IEC 61966-2-1 to CIELAB, blurred in between."""
    linear = blurred(np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4))
    to_xyz = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    xyz = linear @ to_xyz.T / to_xyz.sum(axis=1)
    f = np.where(xyz > (6 / 29) ** 3, np.cbrt(xyz), xyz / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.stack([116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])], axis=-1)


def difference(a, b):
    return float(np.percentile(np.linalg.norm(lab(a) - lab(b), axis=-1), 95))


def draw(program, root, picture, more, out):
    name, scenario, time_s, sets, _ = picture
    arguments = [program, "run", str(root / "scenarios" / f"{scenario}.toml"), "--out", str(out), "--quiet"]
    for setting in sets + COMMON + [f"waves.duration_s={time_s}", f"output.every_s={time_s}"] + more:
        arguments += ["--set", setting]
    run = subprocess.run(arguments, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{name}: {run.stderr.strip()}")
    return out / "images" / "scene_000001.png"


def judge(program, root, picture, folder):
    """Whether the picture is that which is kept, and the other ones are not."""
    name = picture[0]
    kept = image(root / "tests" / "references" / f"{name}.png")
    found = difference(image(draw(program, root, picture, [], folder / name)), kept)
    good = found < TOLERANCE
    print(f"{name}: {found:.3f}, allowed < {TOLERANCE}: {'passed' if good else 'FAILED'}")
    for what, sets in picture[4].items():
        other = difference(image(draw(program, root, picture, sets, folder / f"{name}_{what}")), kept)
        told = other > TOLERANCE
        good = good and told
        print(f"{name}, other {what}: {other:.3f}, to be told > {TOLERANCE}: {'passed' if told else 'FAILED'}")
    return good


def main():
    program, root = sys.argv[1], pathlib.Path(sys.argv[2])
    names = [a for a in sys.argv[3:] if a != "--update"]
    chosen = [p for p in PICTURES if not names or p[0] in names]
    devices = subprocess.run([program, "devices"], capture_output=True, text=True).stdout
    if "vulkan " not in devices:
        print("skipped: there is no Vulkan device")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        if "--update" in sys.argv:
            for picture in chosen:
                kept = root / "tests" / "references" / f"{picture[0]}.png"
                kept.write_bytes(draw(program, root, picture, [], folder / picture[0]).read_bytes())
            return
        results = [judge(program, root, picture, folder) for picture in chosen]
        sys.exit(0 if all(results) else 1)


if __name__ == "__main__":
    main()
