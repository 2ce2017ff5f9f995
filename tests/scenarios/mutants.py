#!/usr/bin/env python3
"""Breaks one formula of the program after another and prints, as a Markdown table, which checks of the scenarios notice.

    mutants.py SOURCE [--only NAME]... [--skip GLOB]... [--minutes N]
    mutants.py SOURCE --list      names the mutations, and says where one no longer fits the source

Each mutation is made in a copy of the tree below SOURCE/build/mutants, built, and judged by `check` of its scenarios
against the program as it is. What is built and judged is kept there: a second call goes on where the first ended.
--only: mutations whose name holds this. --skip: scenarios, by name, that are not run; the counts are of the others then.
--minutes: for one build or one run; what takes longer is stopped.
Exit 0 where each mutation fails three checks or more; 1 where one fails fewer; 2 where one cannot be made, built or run.
"""

import argparse
import fnmatch
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
from pathlib import Path
from typing import NamedTuple

ENOUGH = 3  # checks that must fail
NAMED = 4  # checks that the table names


class Mutation(NamedTuple):
    name: str
    file: str
    text: str  # occurs once
    instead: str


MUTATIONS = [
    # Waves
    Mutation("surface tension halved", "sim/kernels/dispersion.glsl", "return (g + s * k * k) * k * tanh(k * h);",
             "return (g + real(0.5) * s * k * k) * k * tanh(k * h);"),
    Mutation("tanh of nine tenths of k h", "sim/kernels/dispersion.glsl", "tanh(k * h)", "tanh(real(0.9) * k * h)"),
    Mutation("sign in the group velocity", "sim/kernels/dispersion.glsl", "* t + (g", "* t - (g"),
    Mutation("long waves 1.5 % slower", "sim/kernels/linear.glsl", "return sqrt(g * h);", "return sqrt(real(0.97) * g * h);"),
    Mutation("sign of the central slope", "sim/kernels/linear.glsl", "(after - before)", "(before - after)"),
    Mutation("drops of airy a tenth higher", "sim/kernels/sources.glsl", "return q * exp(-q);", "return real(1.1) * q * exp(-q);"),
    Mutation("rim of a drop halved", "sim/kernels/sources.glsl", "return (real(1) - q) * exp(-q);",
             "return (real(1) - real(0.5) * q) * exp(-q);"),
    Mutation("wavemaker sends half", "sim/sources.cpp", "2 * group_velocity * maker", "group_velocity * maker"),
    Mutation("sign in the direction of sines", "sim/sines.cpp", "k * std::sin(direction)}", "-k * std::sin(direction)}"),
    Mutation("prescribed sines run backwards", "sim/sines.cpp", "- w * time_s +", "+ w * time_s +"),
    Mutation("sign of Gerstner's pinch", "sim/kernels/gerstner.glsl", "sum.xx -= d.x * k.x * a_cos;",
             "sum.xx += d.x * k.x * a_cos;"),
    Mutation("sign of Gerstner's mean level", "sim/kernels/gerstner.glsl", "return real(0.5) * k * a * a;",
             "return real(-0.5) * k * a * a;"),
    Mutation("exponent of Pierson and Moskowitz", "sim/kernels/spectra.glsl", "exp(real(-1.25) / u4)", "exp(real(-1) / u4)"),
    Mutation("width of JONSWAP's peak", "sim/kernels/spectra.glsl", "exp(real(-0.5) * x * x)", "exp(real(-1) * x * x)"),
    Mutation("spreading of cos^s, not cos^2s", "sim/spectrum.cpp", "(theta - mean))), 2 * s)", "(theta - mean))), s)"),
    Mutation("Hs of 2 sqrt(2 m0)", "sim/spectrum.cpp", "settings.significant_height_m / 16;", "settings.significant_height_m / 8;"),
    # Shallow water
    Mutation("pressure a tenth less", "sim/kernels/shallow_water.glsl", "real pressure_step = real(0.5) * g",
             "real pressure_step = real(0.45) * g"),
    Mutation("HLL's slow wave at half its speed", "sim/kernels/shallow_water.glsl", "speeds.slow = min(slow, real(0));",
             "speeds.slow = min(real(0.5) * slow, real(0));"),
    Mutation("friction by h^2, not h^(7/3)", "sim/kernels/shallow_water.glsl", "max(m * m * cbrt(m), ", "max(m * m, "),
    Mutation("no limit on rising slopes", "sim/kernels/shallow_water.glsl", "freedom * max(min(a, b), real(0))",
             "freedom * max(max(a, b), real(0))"),
    Mutation("force within a cell a tenth less", "sim/kernels/shallow_water.glsl",
             "return real(0.5) * g * (h_low + h_high) * (e_high - e_low);",
             "return real(0.45) * g * (h_low + h_high) * (e_high - e_low);"),
    Mutation("wave through a side a quarter lower", "sim/kernels/shallow_sides.glsl",
             "inside.u : real(2) * coming +", "inside.u : real(1.5) * coming +"),
    Mutation("width of a solitary wave", "sim/kernels/shallow_exact.glsl", "sqrt(real(0.75) * a / (d * d * d))",
             "sqrt(real(0.5) * a / (d * d * d))"),
    Mutation("shock of Stoker's solution", "sim/kernels/shallow_exact.glsl",
             "real q = sqrt(real(0.5) * g * (h + hk) / (h * hk));", "real q = sqrt(real(0.45) * g * (h + hk) / (h * hk));"),
    Mutation("frequency of Thacker's plane surface", "sim/kernels/shallow_exact.glsl", "return sqrt(real(2) * g * h0) / a;",
             "return sqrt(real(1.8) * g * h0) / a;"),
    # Light
    Mutation("Snell with one n for two", "caustics/kernels/optics.glsl", "(real(1) - cos_i * cos_i) * inv_n * inv_n",
             "(real(1) - cos_i * cos_i) * inv_n"),
    Mutation("both polarisations as one", "caustics/kernels/optics.glsl", "max(real(1e-15), n * cos_i + cos_t)",
             "max(real(1e-15), cos_i + n * cos_t)"),
    Mutation("sign of the slope in refraction", "caustics/kernels/optics.glsl",
             "s.y * inv_n - along * slope.y", "s.y * inv_n + along * slope.y"),
    Mutation("sign of the slope in incidence", "caustics/kernels/optics.glsl", "s.x * slope.x + s.y * slope.y - s.z",
             "s.x * slope.x - s.y * slope.y - s.z"),
    Mutation("extinction over the depth, not the path", "caustics/kernels/floor.glsl", "landed.path = descent * r.path;",
             "landed.path = descent;"),
    Mutation("light lands from the mean plane", "caustics/kernels/floor.glsl", "max(real(0), elevation + light.depth)",
             "max(real(0), real(0) * elevation + light.depth)"),
    Mutation("sign in the footprint's determinant", "caustics/kernels/footprint.glsl", "f.width = d.x - f.slant * f.slide;",
             "f.width = d.x + f.slant * f.slide;"),
    Mutation("weight of a channel", "caustics/kernels/footprint.glsl", "share.two = p.part * part_below(p, real(2));",
             "share.two = p.part * part_below(p, real(1.5));"),
    Mutation("section of a beam as the paper prints it", "caustics/kernels/beams.glsl",
             "return real3(l1.y * l2.x - l1.x * l2.y,", "return real3(l1.y * l1.x - l1.x * l2.y,"),
    Mutation("no cosine across a beam", "caustics/kernels/beams.glsl", "real(2) * flux / (twice_area * cosine)",
             "real(2) * flux * max(real(1), cosine) / twice_area"),
    Mutation("way to the eye halved", "caustics/kernels/beams.glsl", "(t - near) * length", "real(0.5) * (t - near) * length"),
    Mutation("extinction scatters, half of it", "caustics/beam_blocks.hpp", "v.power[0] * scattering", "v.power[0] * extinction"),
    Mutation("phase function over half the sphere", "caustics/kernels/phase.glsl", "real(12.566370614359172)",
             "real(6.283185307179586)"),
    Mutation("ledger swaps absorbed and scattered", "caustics/light_ledger.cpp", "optics.scattering_per_m / extinction",
             "optics.absorption_per_m / extinction"),
    Mutation("sign in the index of seawater", "caustics/kernels/water_colour.glsl", "first - real(4382)", "first + real(4382)"),
    Mutation("absorption of the next wavelength", "caustics/water_colour.cpp", "(wavelength_nm - shortest_nm) / step_nm",
             "(wavelength_nm - shortest_nm) / step_nm + 1"),
    Mutation("power in the sun's disc", "caustics/kernels/sun_disc.glsl", "n * cos_t * cos_t * cos_t", "n * cos_t"),
    # Constants and the sun: half of the program is compiled anew.
    Mutation("gravity 9.5", "sim/water.hpp", "gravity_m_s2 = 9.81;", "gravity_m_s2 = 9.5;"),
    Mutation("refractive index 1.36", "caustics/light.hpp", "refractive_index = 4.0 / 3.0;", "refractive_index = 1.36;"),
    Mutation("sign of the sun's azimuth", "caustics/light.hpp", "-std::cos(el) * std::sin(az)", "std::cos(el) * std::sin(az)"),
    Mutation("sine for the cosine of the sun's elevation", "caustics/light.hpp", "-std::cos(el) * std::cos(az)",
             "-std::sin(el) * std::cos(az)"),
]


class Failure(Exception):
    """What cannot be made, built or run, and why."""


def run(arguments, minutes, **rest):
    """Returns the exit code and what was said; whatever the program started ends with it."""
    child = subprocess.Popen([str(a) for a in arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             start_new_session=True, **rest)
    try:
        said, _ = child.communicate(timeout=60 * minutes)
    except BaseException as stop:
        os.killpg(child.pid, signal.SIGKILL)
        child.wait()
        if isinstance(stop, subprocess.TimeoutExpired):
            raise Failure(f"{Path(arguments[0]).name} took more than {minutes:g} minutes") from stop
        raise
    return child.returncode, said


def digest(*parts):
    whole = hashlib.sha256()
    for part in parts:
        whole.update(part if isinstance(part, bytes) else str(part).encode())
        whole.update(b"\0")
    return whole.hexdigest()


def replace(path, data):
    """Writes only what differs, so that only that is built anew."""
    if not path.is_file() or path.read_bytes() != data:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def mutated(source, mutation):
    """The file's text with the mutation in it."""
    text = (source / mutation.file).read_text()
    if text.count(mutation.text) != 1:
        raise Failure(f'{mutation.file} holds "{mutation.text}" {text.count(mutation.text)} times, not once')
    return text.replace(mutation.text, mutation.instead)


class Workshop:
    """The copy of the tree, its build, and what has come of it."""

    def __init__(self, source, minutes):
        self.source, self.minutes = source, minutes
        self.folder = source / "build" / "mutants"
        self.tree, self.build = self.folder / "tree", self.folder / "build"
        _, listed = run(["git", "-C", source, "ls-files", "--cached", "--others", "--exclude-standard"], minutes)
        kept = re.compile(r"(app|caustics|cmake|export|gpu|render|scenarios|sim|test_kit)/|CMake")
        names = [name for name in listed.splitlines() if kept.match(name) and (source / name).is_file()]
        self.files = {name: (source / name).read_bytes() for name in names}
        self.code = {name: data for name, data in self.files.items() if not name.endswith(".toml")}
        self.scenarios = {name: data for name, data in self.files.items()
                          if name.startswith("scenarios/") and name.endswith(".toml")}

    def program(self, mutation):
        """The program with the mutation, or as it is: built, unless it has been."""
        code = dict(self.code)
        if mutation:
            code[mutation.file] = mutated(self.source, mutation).encode()
        key = digest(*(part for item in sorted(code.items()) for part in item))
        kept = self.folder / "programs" / key
        if not kept.is_file():
            self.lay_out(code)
            if not (self.build / "build.ninja").is_file():
                self.command("configuring", ["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja",
                                             "-DCMAKE_BUILD_TYPE=Release", "-DWATERLIGHT_TESTS=OFF", *compiler_cache()])
            self.command("building", ["ninja", "-C", self.build, "app/waterlight"])
            kept.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(self.build / "app" / "waterlight", kept.with_suffix(".part"))
            kept.with_suffix(".part").rename(kept)
        return kept

    def lay_out(self, code):
        for path in self.tree.rglob("*"):
            if path.is_file() and str(path.relative_to(self.tree)) not in code:
                path.unlink()
        for name, data in code.items():
            replace(self.tree / name, data)

    def command(self, what, arguments):
        code, said = run(arguments, self.minutes)
        if code != 0:
            raise Failure(f"{what} failed:\n{said[-3000:]}")

    def chosen(self, skip):
        """The scenarios that judge themselves, but for those to be skipped."""
        return [name for name, data in self.scenarios.items()
                if b"[[check]]" in data and not any(fnmatch.fnmatch(Path(name).stem, glob) for glob in skip)]

    def stamp(self, name):
        """Changes with the scenario and those that it is compared with."""
        data = self.scenarios[name]
        others = re.findall(rb'^reference = "(.*\.toml)"', data, re.M)
        return digest(data, *(self.scenarios[str(Path(name).parent / other.decode())] for other in others))

    def judged(self, program, names):
        """Of each scenario its checks, (name, whether it failed or could not be judged); what is known is not run."""
        kept = self.folder / "judged" / (program.name + ".json")
        known = json.loads(kept.read_text()) if kept.is_file() else {}
        missing = [name for name in names if self.stamp(name) not in known]
        if missing:
            for name, checks in self.check(program, missing).items():
                known[self.stamp(name)] = checks
            kept.parent.mkdir(parents=True, exist_ok=True)
            kept.with_suffix(".part").write_text(json.dumps(known))
            kept.with_suffix(".part").rename(kept)
        return {name: known[self.stamp(name)] for name in names}

    def check(self, program, names):
        with tempfile.TemporaryDirectory() as folder:
            report = Path(folder) / "report.xml"
            code, said = run([program, "check", *names, "--quiet", "--jobs", "2", "--junit", report], self.minutes,
                             cwd=self.source)
            if not report.is_file():
                raise Failure(f"check ended with {code} and no report:\n{said[-3000:]}")
            suites = list(xml.etree.ElementTree.parse(report).iter("testsuite"))
        return {suite.get("file"): [(case.get("name"), any(case.find(bad) is not None for bad in ("failure", "error")))
                                    for case in suite.iter("testcase")] for suite in suites}

    def failed(self, program, skip):
        """Names of the checks that fail, in the order of the scenarios, and the number of all."""
        judged = self.judged(program, self.chosen(skip))
        failed = [f"{Path(name).stem}: {check}" for name, checks in judged.items() for check, bad in checks if bad]
        return failed, sum(len(checks) for checks in judged.values())


def compiler_cache():
    return [f"-DCMAKE_{language}_COMPILER_LAUNCHER=ccache" for language in ("C", "CXX")] if shutil.which("ccache") else []


def row(mutation, caught):
    """A line of the table; of the checks the quantities, each named once."""
    names = list(dict.fromkeys(f"`{re.match(r'[^:]*: [^ ]*', check).group(0)}`" for check in caught))
    more = f" and {len(names) - NAMED} more" if len(names) > NAMED else ""
    change = f"`{mutation.text}` → `{mutation.instead}`".replace("|", "\\|")
    count = str(len(caught)) if len(caught) >= ENOUGH else f"**{len(caught)}**"
    return f"| {mutation.name} | `{mutation.file}`: {change} | {count} | {', '.join(names[:NAMED]) + more} |"


def list_all(source):
    worst = 0
    for mutation in MUTATIONS:
        try:
            mutated(source, mutation)
            print(f"{mutation.name}: {mutation.file}")
        except Failure as failure:
            print(f"mutants: {mutation.name}: {failure}", file=sys.stderr)
            worst = 2
    return worst


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source", type=Path)
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--skip", action="append", default=[])
    parser.add_argument("--minutes", type=float, default=20)
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()
    if arguments.list:
        return list_all(arguments.source)
    chosen = [m for m in MUTATIONS if not arguments.only or any(part in m.name for part in arguments.only)]
    if not chosen:
        parser.error("no mutation has such a name")
    worst = 0
    try:
        shop = Workshop(arguments.source.resolve(), arguments.minutes)
        sound, checks = shop.failed(shop.program(None), arguments.skip)
        for check in sound:
            print(f"fails without a mutation, and is not counted: {check}", file=sys.stderr)
        print("| mutation | where | checks that fail | which |\n|---|---|---|---|", flush=True)
    except Failure as failure:
        print(f"mutants: without a mutation: {failure}", file=sys.stderr)
        return 2
    caught_all = 0
    for mutation in chosen:
        try:
            failed, _ = shop.failed(shop.program(mutation), arguments.skip)
        except Failure as failure:
            print(f"mutants: {mutation.name}: {failure}", file=sys.stderr)
            worst = 2
            continue
        caught = [check for check in failed if check not in sound]
        print(row(mutation, caught), flush=True)
        caught_all += len(caught) >= ENOUGH
        if len(caught) < ENOUGH:
            worst = max(worst, 1)
    skipped = f"; not run: {', '.join(arguments.skip)}" if arguments.skip else ""
    print(f"\n{caught_all} of {len(chosen)} mutations fail {ENOUGH} checks or more, of {checks} checks{skipped}.")
    return worst


if __name__ == "__main__":
    sys.exit(main())
