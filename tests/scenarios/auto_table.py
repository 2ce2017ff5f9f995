#!/usr/bin/env python3
"""Judges what model = "auto" chooses on scenes from ripples to bores: prints a table, exit 1 where too many are wrong.

usage: auto_table.py PROGRAM [CASE]...

Each scene is run as auto has it, and with every model that can carry it on a ladder of grids. The error of each run is
measured against water that no rung of the ladder knows: potential flow with all nonlinearity and dispersion, or an exact
solution (wave_truths.py). A choice is right where its measured error is within the tolerance and it costs at most twice
the cheapest run that is; or where auto says that no model meets the tolerance, and none does.
"""
import json
import math
import os
import subprocess
import sys
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

import wave_truths as truth

MODELS = ("linear", "airy", "shallow-water")
LADDER = (0.35, 0.5, 0.71, 1.0, 1.41)  # cells along a side, over what auto would take for that model
REPEATS = 3  # of which the quickest counts: others use the machine
HOPELESS = 5  # tolerances: a model that wrong on the grid that should do is not tried on others
POINTS = 400  # along a wave at which the surface is compared
G = truth.GRAVITY


class Scene:
    """waves: lines of TOML; elevation(x, y): the true water at the end on a lattice, at times as a mask of what counts."""

    def __init__(self, name, size, depth, duration, waves, elevation, *, sides="periodic", tolerance=0.02, frames=1,
                 numbers="", weight=None, patch=None):
        self.name, self.size, self.depth, self.duration = name, size, depth, duration
        self.waves, self.elevation, self.sides = waves, elevation, sides
        self.tolerance, self.frames, self.numbers = tolerance, frames, numbers
        self.patch = patch or size  # a part that repeats

    def toml(self):
        return f"""title = "{self.name}"
[domain]
size_m = [{self.size[0]!r}, {self.size[1]!r}]
depth_m = {self.depth!r}
[water]
surface_tension_n_m = 0.0
[accuracy]
tolerance = {self.tolerance}
[waves]
model = "auto"
boundary = {{ x = "{self.sides}", y = "{self.sides}" }}
duration_s = {self.duration!r}
{self.waves}
[output]
every_s = {self.duration / self.frames!r}
formats = ["vti"]
fields = ["elevation"]
"""


def sine_toml(a, k, phase=0):
    return f"[[waves.sine]]\namplitude_m = {a!r}\nwavelength_m = {2 * math.pi / k!r}\nphase_deg = {math.degrees(phase)!r}\n"


def columns_for(steepness):
    """As many as show a wave of that k a without lifting the shortest by more than its own length: the truth is a series
    in the steepness of every wave on the lattice."""
    return 2 * int(min(256, 3 / steepness))


def sines(name, kh, waves, n, columns=None, **rest):
    """waves: (a, multiple of kh, phase), depth 1 m; n: wavelengths that the longest travels. A patch of 8 x 4 waves."""
    columns = columns or columns_for(kh * max(a for a, _, _ in waves))
    length = 2 * math.pi / kh
    duration = n * 2 * math.pi / truth.omega(kh, 1)
    trains = [(a, m * kh, phase) for a, m, phase in waves]

    def elevation(x, y):
        flow = truth.travelling(length, 1, trains, columns)
        flow.advance(duration)
        return numpy.tile(truth.sampled(flow, (length, 1), x, numpy.array([0.5])), (len(y), 1))

    return Scene(name, (8 * length, 4 * length), 1.0, duration, "".join(sine_toml(*t) for t in trains), elevation,
                 numbers=(kh, sum(a for a, _, _ in waves), sum(a * m * kh for a, m, _ in waves)), patch=(length, length),
                 **rest)


def standing(name, kh, a, n, **rest):
    columns = columns_for(kh * a)
    length = 2 * math.pi / kh
    duration = n * 2 * math.pi / truth.omega(kh, 1)

    def elevation(x, y):
        at = (numpy.arange(columns) + 0.5) * length / columns
        flow = truth.still((length, 1), 1, a * numpy.cos(kh * at)[None, :])
        flow.advance(duration)
        return numpy.tile(truth.sampled(flow, (length, 1), x, numpy.array([0.5])), (len(y), 1))

    waves = f"[[waves.standing]]\namplitude_m = {a!r}\nhalf_waves_x = 16\n"
    return Scene(name, (8 * length, 4 * length), 1.0, duration, waves, elevation, sides="wall", numbers=(kh, a, kh * a),
                 patch=(length, length), **rest)


def drop(name, radius, height, depth, duration, size, columns=160, order=4, **rest):
    """One drop in the middle of a square that repeats."""
    def elevation(x, y):
        at = (numpy.arange(columns) + 0.5) * size / columns - size / 2
        q = (at[None, :] ** 2 + at[:, None] ** 2) / radius**2
        flow = truth.still((size, size), depth, height * (1 - q) * numpy.exp(-q), order)
        flow.advance(duration)
        return truth.sampled(flow, (size, size), x, y)

    waves = (f'[[waves.source]]\ntype = "drop"\nat_m = [{size / 2!r}, {size / 2!r}]\nradius_m = {radius!r}\n'
             f"height_m = {height!r}\n")
    return Scene(name, (size, size), depth, duration, waves, elevation,
                 numbers=(2 / radius * depth, height / depth, 2 * height / radius), **rest)


def solitary(name, ratio, way, length, columns=512, **rest):
    duration = way / math.sqrt(G * (1 + ratio))

    def elevation(x, y):
        flow = truth.solitary(length, 1, ratio, 0.3 * length, columns)
        flow.advance(duration)
        return numpy.tile(truth.sampled(flow, (2 * length, 1), x, numpy.array([0.5])), (len(y), 1))

    waves = f'[[waves.initial]]\ntype = "solitary"\ncrest_m = [{0.3 * length!r}, 0.0]\nheight_m = {ratio!r}\n'
    kappa = math.sqrt(0.75 * ratio)
    return Scene(name, (length, length / 4), 1.0, duration, waves, elevation, sides="wall",
                 numbers=(0.9 * kappa, ratio, 0.9 * kappa * ratio), **rest)


def dam(name, left, right, duration, **rest):
    def elevation(x, y):
        depth = truth.stoker(x - 5, duration, left, right) if right > 0 else truth.ritter(x - 5, duration, left)
        return numpy.tile(depth - left, (len(y), 1))

    waves = ('[[waves.initial]]\ntype = "riemann"\nat_m = [5.0, 0.0]\n'
             f"left_depth_m = {left!r}\nright_depth_m = {right!r}\n")
    return Scene(name, (10.0, 2.5), left, duration, waves, elevation, sides="wall",
                 numbers=(0, (left - right) / left, 0), **rest)


def bowl(name, duration, **rest):
    def elevation(x, y):
        return truth.thacker((x - 2)[None, :], (y - 2)[:, None], duration, 1.0, 0.1, 0.5)[0]

    waves = '[[waves.initial]]\ntype = "thacker"\ncentre_m = [2.0, 2.0]\na_m = 1.0\neta_m = 0.5\n'
    return Scene(name, (4.0, 4.0), 0.1, duration, waves, elevation, sides="wall", numbers=(0, 0.5, 0), **rest)


def scenes():
    return [
        sines("long and low", 0.05, [(1e-3, 1, 0)], 2),
        sines("long and low, watched closely", 0.05, [(1e-3, 1, 0)], 2, frames=120),
        sines("long surge", 0.05, [(0.1, 1, 0)], 0.6),
        sines("long swell that steepens", 0.1, [(0.05, 1, 0)], 1.0),
        sines("swell over a shoal", 0.3, [(0.004, 1, 0)], 5),
        sines("high swell over a shoal", 0.5, [(0.1, 1, 0)], 3),
        sines("intermediate, low", 1, [(0.02, 1, 0)], 5),
        sines("intermediate, high", 1, [(0.15, 1, 0)], 5),
        sines("deep swell", 3, [(0.05 / 3, 1, 0)], 10),
        sines("deep ripples", 20, [(0.02 / 20, 1, 0)], 20),
        sines("deep and steep", 20, [(0.2 / 20, 1, 0)], 10),
        sines("deep and fairly steep, briefly", 20, [(0.1 / 20, 1, 0)], 2),
        sines("sea of six waves", 2, [(0.02 / m**1.5, m, 2.4 * m * m % (2 * math.pi)) for m in (1, 2, 3, 4, 6, 8)], 4),
        standing("seiche of a harbour", 0.06, 0.1, 1.0),
        standing("small seiche", 0.1, 0.002, 3),
        standing("deep standing wave", 18, 0.11 / 18, 10),
        drop("small drop on a pool", 0.16, 0.01, 2.0, 2.0, 4.0),
        drop("high drop on a pool", 0.16, 0.06, 2.0, 2.0, 4.0),
        drop("wide drop in shallow water", 2.0, 0.002, 0.1, 6.0, 24.0, frames=60),
        solitary("low solitary wave, short way", 0.03, 10.0, 80.0),
        solitary("solitary wave, long way", 0.3, 40.0, 100.0),
        dam("dam breaks over water", 0.005, 0.001, 6.0),
        dam("dam breaks over dry ground", 0.005, 0.0, 6.0),
        bowl("water goes round in a bowl", 4.4857),
    ]


def surface(path):
    reader = vtkXMLImageDataReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    columns, rows = (n - 1 for n in image.GetDimensions()[:2])
    return vtk_to_numpy(image.GetCellData().GetArray("elevation")).reshape(rows, columns).astype(float)


def drawn(cells, size, x, y, periodic):
    """The surface between the cells' centres: straight lines, mirrored at walls."""
    padded = numpy.pad(cells, 1, mode="wrap" if periodic else "edge")
    rows, columns = cells.shape
    u, v = x * columns / size[0] + 0.5, y * rows / size[1] + 0.5
    i, j = numpy.floor(u).astype(int), numpy.floor(v).astype(int)
    s, t = (u - i)[None, :], (v - j)[:, None]
    at = lambda dj, di: padded[numpy.ix_(j + dj, i + di)]
    return (1 - t) * ((1 - s) * at(0, 0) + s * at(0, 1)) + t * ((1 - s) * at(1, 0) + s * at(1, 1))


class Judge:
    def __init__(self, program, scene, folder):
        self.program, self.scene, self.folder = program, scene, folder
        self.file = os.path.join(folder, "scene.toml")
        with open(self.file, "w") as file:
            file.write(scene.toml())
        patch = scene.patch
        self.x = (numpy.arange(POINTS) + 0.31) * patch[0] / POINTS
        across = 1 if patch != scene.size else POINTS // 4
        self.y = (numpy.arange(across) + 0.31) * patch[1] / across
        try:
            self.true = scene.elevation(self.x, self.y)
        except ArithmeticError:
            self.true = None

    def error(self, cells):
        """RMS(difference) / (2 pi RMS(wave)), both about the means."""
        if self.true is None or not numpy.isfinite(cells).all():
            return math.inf
        s = self.scene
        model = drawn(cells, s.size, self.x, self.y, s.sides == "periodic")
        wave = self.true - self.true.mean()
        return math.sqrt(numpy.mean((model - self.true) ** 2) / numpy.mean(wave**2)) / (2 * math.pi)

    def run(self, *settings, limit_s=None):
        """Error, seconds of the waves and the report; None where the program refuses or takes longer."""
        command = [self.program, "run", self.file, "--out", self.folder, "--quiet", "--backend", "cpu", "--threads", "1"]
        for setting in settings:
            command += ["--set", setting]
        quickest = error = math.inf
        for repeat in range(REPEATS):
            try:
                done = subprocess.run(command, stderr=subprocess.PIPE, text=True, timeout=limit_s)
            except subprocess.TimeoutExpired:
                return None
            if done.returncode != 0:
                return None
            with open(os.path.join(self.folder, "report.json")) as file:
                report = json.load(file)
            quickest = min(quickest, report["wall_s"]["waves"])
            if repeat == 0:
                frames = os.path.join(self.folder, "surface")
                cells = surface(os.path.join(frames, max(name for name in os.listdir(frames) if name.endswith(".vti"))))
                error = self.error(cells)
            # The time of a run counts only where its error is within the tolerance.
            if error > self.scene.tolerance:
                break
        return error, quickest, report, cells.shape[::-1]


def judge(program, scene):
    with tempfile.TemporaryDirectory() as folder:
        judge_of = Judge(program, scene, folder)
        own = judge_of.run()
        if own is None:
            raise RuntimeError(f"{scene.name}: the program refuses it")
        runs = []
        for model in MODELS:
            # Where auto meets the tolerance, a run that takes that much longer cannot have been cheaper.
            meets = own[0] <= scene.tolerance and "warning" not in own[2]["model"]
            limit_s = max(4, 20 * own[1]) if meets else None
            chosen = judge_of.run(f"waves.model={model}", limit_s=limit_s)
            if chosen is None:
                continue
            # No grid saves a model that far off.
            for share in LADDER if chosen[0] <= HOPELESS * scene.tolerance else (1.0,):
                cells = [max(4, round(share * n / 2) * 2) for n in chosen[3]]
                outcome = chosen if share == 1.0 else judge_of.run(f"waves.model={model}", f"domain.cells={cells}",
                                                                         limit_s=limit_s)
                if outcome:
                    runs.append((model, *outcome))
        return own, runs


def verdict(scene, own, runs):
    error, seconds, report, _ = own
    says_none = "warning" in report["model"]
    within = [run for run in runs if run[1] <= scene.tolerance]
    best = min((run[1] for run in runs), default=math.inf)
    if says_none:
        return ("right" if not within else "WRONG: a model meets it"), best, None
    if error > scene.tolerance:
        return "WRONG: beyond the tolerance", best, None
    cheapest = min([run[2] for run in within] + [seconds])
    return ("right" if seconds <= 2 * cheapest else "DEAR"), best, seconds / cheapest


def main():
    program, wanted = sys.argv[1], sys.argv[2:]
    rows, right, within, dear = [], 0, 0, 0
    confusion = {}
    print("| scene | kh | a/h | ka | n | auto | cells | error | allowed | best of all runs | its model | cost over the cheapest |"
          " verdict |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|---|")
    chosen = [s for s in scenes() if not wanted or any(w in s.name for w in wanted)]
    for scene in chosen:
        own, runs = judge(program, scene)
        word, _, ratio = verdict(scene, own, runs)
        error, seconds, report, cells = own
        name = report["model"]["name"]
        warned = "warning" in report["model"]
        ok = [run for run in runs if run[1] <= scene.tolerance]
        truth_name = min(ok, key=lambda run: run[2])[0] if ok else "none"
        best = min(runs, key=lambda run: run[1])
        said = "none" if warned else name
        confusion[(said, truth_name)] = confusion.get((said, truth_name), 0) + 1
        right += word == "right"
        within += word in ("right", "DEAR")
        kh, ah, ka = scene.numbers
        n = scene.duration * (truth.omega(kh, scene.depth) / (2 * math.pi) if kh else 0)
        print(f"| {scene.name} | {kh:.3g} | {ah:.2g} | {ka:.2g} | {n:.2g} | {'none; ' if warned else ''}{name} |"
              f" {cells[0]} x {cells[1]} | {100 * error:.2f} % | {100 * scene.tolerance:.3g} % | {100 * best[1]:.2f} % |"
              f" {best[0]} | {f'{ratio:.2f}' if ratio else ''} | {word} |", flush=True)
    print(f"\n{within} of {len(chosen)} meet the tolerance, or rightly say that none does; {right} of them at no more than"
          " twice the cheapest cost.\n")
    columns = (*MODELS, "none")
    print("| auto says, cheapest in truth | " + " | ".join(columns) + " |")
    print("|---|" + "---|" * len(columns))
    for said in columns:
        print(f"| {said} | " + " | ".join(str(confusion.get((said, true), "")) for true in columns) + " |")
    return right < math.ceil(0.95 * len(chosen))


if __name__ == "__main__":
    sys.exit(main())
