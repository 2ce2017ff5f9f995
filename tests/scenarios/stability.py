"""Runs the extremes and prints them as a Markdown table: the extreme, its promise, where it is tested, what came out,
and the time that it took. Exit 0 where every promise is held, 1 where one is not.

    stability.py PROGRAM SCENARIOS BUILD     all, as in docs/stability.md
    stability.py PROGRAM SCENARIOS           what scenarios/extremes says: no laws
    stability.py PROGRAM SCENARIOS --refused what scenarios/extremes/refused says alone, a line for each that is not held

A scenario of scenarios/extremes is run by `check`; its promise is its line "Judged by:". One of the folder refused has a
line `# Expect: COMMAND, exit CODE, "TEXT"`: the command run on it must end so, and say the text in a line of its own.
A law is a GoogleTest case, run by its program below BUILD.
"""

import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

# Extreme, promise, program, cases, source: what no scenario can say.
LAWS = [
    ("CFL 0.1 to 1, shallow water", "depth >= 0, volume to rounding, no speed beyond what falls", "shallow_tests",
     "ShallowVolume*.DamBreaksOnDryGround:ShallowVolume*.BowlsWithMovingShores", "shallow_volume.cpp"),
    ("CFL beyond 1, any solver", "refused by name, found and allowed", "shallow_tests", "ShallowRefusals.NumbersOutOfRange",
     "shallow_refusals.cpp"),
    ("CFL 1 and beyond, linear", "bounded at 1, refused beyond", "waves_linear_tests",
     "LinearStability.HoldsAtACourantNumberOfOne:LinearStability.RefusesMoreThanOne", "linear_stability.cpp"),
    ("depth 1e-12 to 1e4 m, Froude 0 to 100, cliffs, 1 x 1 to 19 x 1 cells, at random",
     "depth >= 0, volume to rounding, no speed beyond what falls, in 300 waters", "shallow_tests",
     "ShallowVolume*.RandomWaterOverRandomGround", "shallow_volume.cpp"),
    ("cliffs of a million depths", "a lake stays at rest", "shallow_tests", "ShallowRest*.CliffsUpToAMillionDepths",
     "shallow_rest.cpp"),
    ("drops of 5 m into dry and nearly dry cells", "depth >= 0, volume to rounding", "shallow_tests",
     "ShallowVolume*.DropsIntoDryAndNearlyDryCells", "shallow_volume.cpp"),
    ("walls round a single cell, depth 1e-12 to 1e4 m", "its depth stays to the last bit", "shallow_tests",
     "ShallowVolume*.NothingPassesWalls", "shallow_volume.cpp"),
    ("numbers that are not finite", "the run stops and names the cell", "shallow_tests",
     "ShallowRefusals.NumbersThatAreNotFiniteStopTheRun:ShallowRefusals.CollapsingTimeStepNamesTheCell",
     "shallow_refusals.cpp"),
    ("a million steps, moving shore", "depth >= 0, volume to rounding", "shallow_long_test", "*", "shallow_long.cpp"),
    ("light that is not finite", "the run stops and names the pixel", "app_record_test",
     "Readings.LightThat*:Readings.ALedgerThat*:Readings.ASurfaceThat*", "../unit/app_record_test.cpp"),
    ("sun on and below the horizon", "no light, no NaN", "floor_map_test", "FloorMap.NoSunNoLightAndNoNaN",
     "floor_map_test.cpp"),
    ("sun within half a degree of the horizon", "floats know the transmittance to 1e-6", "floor_map_test",
     "FloorMap.FresnelOfGrazingLight*", "floor_map_test.cpp"),
    ("n = 1", "E = E0 sin(el) for any waves; shaded water is dark, not NaN", "floor_map_test",
     "FloorMap.WithoutRefraction*", "floor_map_test.cpp"),
    ("n < 1, from below", "total reflection past the critical angle", "floor_map_test",
     "FloorMap.FresnelFromBelowVanishesAtTheCriticalAngle", "floor_map_test.cpp"),
    ("depth and light beyond floats", "refused", "floor_map_test", "FloorMap.RefusesWhatFloatsCannotHold",
     "floor_map_test.cpp"),
    ("footprints folded to lines", "no light is lost", "floor_map_test", "AdaptiveFootprint.NoLightIsLost*",
     "floor_footprint_test.cpp"),
    ("narrow windows", "what is lost is reported", "floor_map_test", "AdaptiveFootprint.ANarrowWindow*",
     "floor_footprint_test.cpp"),
]


class Row:
    def __init__(self, extreme, promise, where, held, outcome, seconds):
        self.cells = [extreme, promise, where, ("held: " if held else "**NOT HELD**: ") + outcome, f"{seconds:.1f}"]
        self.held = held

    def text(self):
        return "| " + " | ".join(cell.replace("|", "\\|").replace("\n", " ") for cell in self.cells) + " |"


def run(arguments):
    start = time.time()
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True)
    return done, time.time() - start


def header_of(scenario):
    """The comment before the first line of TOML, as sentences."""
    lines = []
    for line in scenario.read_text().splitlines():
        if not line.startswith("#"):
            break
        lines.append(line[1:].strip())
    return " ".join(lines)


def title_of(scenario):
    return re.search(r'^title = "(.*)"', scenario.read_text(), re.M).group(1)


def short(value):
    return "none" if value is None else f"{value:.3g}"


def checked(program, scenario):
    """The row of a scenario that judges itself."""
    with tempfile.TemporaryDirectory() as folder:
        done, seconds = run([program, "check", scenario, "--quiet", "--out", folder, "--set", "output.formats=[]"])
        promise = header_of(scenario).split("Judged by: ", 1)[1].split(" Expected error:")[0]
        held = done.returncode == 0
        # Of the table, a line for each check: name, value, expected, verdict.
        lines = [re.split(r"\s{2,}", line.strip()) for line in done.stdout.split("\n\n")[0].splitlines()[1:]]
        said = "; ".join(f"{name} {value} ({expected})" for _, name, value, expected, *_ in lines if value)
        if not said:
            said = (done.stderr or done.stdout).strip().splitlines()[-1]
    return Row(title_of(scenario), promise, f"`{scenario.stem}.toml`", held, said, seconds)


def refused(program, scenario):
    """The row of a scenario that must be refused, or warned of."""
    promise, expected = header_of(scenario).split(" Expect: ")
    command, code, text = re.fullmatch(r'(\w+), exit (\d), "(.*)"', expected).groups()
    with tempfile.TemporaryDirectory() as folder:
        more = ["--quiet", "--out", Path(folder) / "out", "--set", "output.formats=[]"] if command == "run" else []
        done, seconds = run([program, command, scenario, *more])
        wrote = (Path(folder) / "out").exists()
    lines = [line for line in (done.stderr + done.stdout).splitlines() if text in line]
    held = done.returncode == int(code) and len(lines) == 1 and not (code == "2" and wrote)
    said = f"exit {done.returncode}: " + (lines or (done.stderr or done.stdout).strip().splitlines() or ["nothing"])[0]
    said = said.replace(str(scenario), scenario.name).replace("waterlight: ", "")
    return Row(title_of(scenario), promise, f"`refused/{scenario.stem}.toml`", held, f"`{said}`", seconds)


def law(build, extreme, promise, program, cases, source):
    """The row of a law, by its GoogleTest program."""
    with tempfile.NamedTemporaryFile(suffix=".json") as report:
        done, seconds = run([build / "tests" / program, f"--gtest_filter={cases}", f"--gtest_output=json:{report.name}"])
        outcome = json.loads(Path(report.name).read_text() or "{}")
    count, failed = outcome.get("tests", 0), outcome.get("failures", 0)
    where = "`" + str(Path("tests/laws") / source).replace("laws/../", "") + "`"
    held = done.returncode == 0 and count > 0
    return Row(extreme, promise, where, held, f"{count - failed} of {count} cases", seconds)


def main():
    program, scenarios = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    only_refused = sys.argv[3:] == ["--refused"]
    folder = scenarios / "extremes"
    refusals = [refused(program, file) for file in sorted((folder / "refused").glob("*.toml"))]
    if only_refused:
        print("\n".join(row.text() for row in refusals if not row.held) or f"all {len(refusals)} held")
        return 0 if refusals and all(row.held for row in refusals) else 1
    build = Path(sys.argv[3]).resolve() if sys.argv[3:] else None
    parts = [("Scenarios", "Of `scenarios/extremes`, by `./waterlight check`.",
              [checked(program, file) for file in sorted(folder.glob("*.toml"))]),
             ("Refused, stopped or warned of", "Of `scenarios/extremes/refused`, with what the program says.", refusals),
             ("Laws", "What no scenario can say.", [law(build, *entry) for entry in LAWS] if build else [])]
    rows = [row for _, _, part in parts for row in part]
    held = sum(row.held for row in rows)
    print("# What holds at the extremes\n")
    print("Printed by `./waterlight stability > docs/stability.md`. Each row states what it promises, where that is tested, "
          f"and what came out here, in seconds of one machine. {held} of {len(rows)} rows are held.\n")
    for name, what, part in parts:
        if part:
            print(f"## {name}\n\n{what}\n\n| extreme | promise | where | outcome | s |\n|---|---|---|---|---|")
            print("\n".join(row.text() for row in part) + "\n")
    return 0 if held == len(rows) else 1


if __name__ == "__main__":
    sys.exit(main())
