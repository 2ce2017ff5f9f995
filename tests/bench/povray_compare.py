#!/usr/bin/env python3
"""Photon map against floor map: light through a frozen sine (a = 0.01 m, wavelength 0.5 m) on a floor 1 m below, 256 pixels
a metre, sun overhead. Where povray is installed, prints for several spacings of its photons the relative RMSE against
the exact pixel averages and the time that it took; then the same of `waterlight run`'s floor stage.

    tests/bench/povray_compare.py path/to/waterlight
"""
import json
import math
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

AMPLITUDE, WAVE, DEPTH, INDEX, PER_M = 0.01, 0.5, 1.0, 4 / 3, 256
COLUMNS = 128  # one wave
SCALE = 0.2    # of the light in povray, so that its picture is not clipped

SCENE = """#version 3.7;
global_settings {{ assumed_gamma 1 ambient_light 0 photons {{ spacing {spacing} autostop 0 jitter 0.4 gather {low}, {high} }} }}
camera {{ orthographic location <0, -0.5, 0> look_at <0, -1, 0> right x * {width} up z * {width} sky z }}
light_source {{ <0, 10, 0> rgb {light} parallel point_at <0, 0, 0> photons {{ refraction on reflection off }} }}
plane {{ y, -1 texture {{ pigment {{ rgb 1 }} finish {{ diffuse 1 ambient 0 }} }} photons {{ collect on }} }}
isosurface {{
  function {{ y - {a} * cos({k} * x) }}
  contained_by {{ box {{ <-1, -0.9, -1>, <1, 0.02, 1> }} }} max_gradient 1.1 accuracy 1e-7
  texture {{ pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 }} }} interior {{ ior {index} }}
  photons {{ target refraction on reflection off collect off }} hollow
}}
"""


def exact_averages():
    """Relative irradiance of each column, without Fresnel: thin strips of water over the width on which they land."""
    k, strips = 2 * math.pi / WAVE, 400 * COLUMNS

    def land(x):
        slope = -AMPLITUDE * k * math.sin(k * x)
        nz = 1 / math.sqrt(1 + slope * slope)
        along = nz * (nz / INDEX - math.sqrt(1 - (1 - nz * nz) / INDEX**2))
        tz = 1 / INDEX - along
        # t = s/n + (cos/n - cos_t) N with s = (0, -1), N = nz (-slope, 1)
        return x + (DEPTH + AMPLITUDE * math.cos(k * x)) * (-along * slope) / tz

    columns = [0.0] * COLUMNS
    pixel = WAVE / COLUMNS
    for i in range(strips):
        x0, x1 = i * WAVE / strips, (i + 1) * WAVE / strips
        a, b = sorted((land(x0) / pixel, land(x1) / pixel))
        for column in range(math.floor(a), math.floor(b) + 1):
            part = (min(b, column + 1) - max(a, column)) / (b - a)
            columns[column % COLUMNS] += part * (x1 - x0) / pixel
    return columns


def relative_rmse(found, truth):
    scale = sum(truth) / sum(found)
    return math.sqrt(sum((scale * f - t) ** 2 for f, t in zip(found, truth)) / sum(t * t for t in truth))


def photon_map(spacing, gather, folder):
    width = WAVE
    scene = SCENE.format(spacing=spacing, low=gather, high=gather, width=width, light=SCALE, a=AMPLITUDE,
                         k=2 * math.pi / WAVE, index=INDEX)
    (folder / "sine.pov").write_text(scene)
    begin = time.perf_counter()
    subprocess.run(["povray", "+Isine.pov", "+Osine.ppm", "+FP16", f"+W{COLUMNS}", f"+H{COLUMNS}", "-D", "-A",
                    "File_Gamma=1"], cwd=folder, check=True, capture_output=True)
    seconds = time.perf_counter() - begin
    data = (folder / "sine.ppm").read_bytes()
    pixels = data[-6 * COLUMNS * COLUMNS:]
    row = lambda j: [int.from_bytes(pixels[6 * (j * COLUMNS + i):][:2], "big") for i in range(COLUMNS)]
    rows = [row(j) for j in range(COLUMNS)]
    return rows, seconds


def floor_map_seconds(program, folder):
    """Of one map of as many pixels; what error it has, tests/laws/floor_footprint_test.cpp says."""
    (folder / "sine.toml").write_text(f"""title = "Sine"
[domain]
size_m = [{WAVE}, {WAVE}]
cells = [{COLUMNS}, {COLUMNS}]
depth_m = {DEPTH}
[waves]
model = "prescribed"
boundary = {{ x = "periodic", y = "periodic" }}
duration_s = 1.0
[[waves.sine]]
amplitude_m = {AMPLITUDE}
wavelength_m = {WAVE}
[light]
elevation_deg = 90.0
[caustics.floor]
pixels = [{COLUMNS}, {COLUMNS}]
[output]
every_s = 0.01
formats = []
""")
    subprocess.run([program, "run", "sine.toml", "--out", "out", "--quiet", "--backend", "cpu"], cwd=folder, check=True)
    report = json.loads((folder / "out" / "report.json").read_text())
    return report["wall_s"]["caustics.floor"] / 101


if __name__ == "__main__":
    if not shutil.which("povray"):
        sys.exit("povray is not installed")
    truth = exact_averages()
    truth = truth[COLUMNS // 2:] + truth[:COLUMNS // 2]
    with tempfile.TemporaryDirectory() as name:
        for spacing, gather in ((0.004, 100), (0.004, 400), (0.002, 400)):
            rows, seconds = photon_map(spacing, gather, Path(name))
            means = [sum(column) for column in zip(*rows)]
            flat = [v for r in rows for v in r]
            print(f"photons every {spacing} m, {gather} gathered: {100 * relative_rmse(flat, truth * COLUMNS):.2f} % a "
                  f"pixel, {100 * relative_rmse(means, truth):.2f} % a column, {seconds:.2f} s", flush=True)
        if len(sys.argv) > 1:
            print(f"floor map: {1e3 * floor_map_seconds(sys.argv[1], Path(name)):.3f} ms")
