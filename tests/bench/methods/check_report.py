#!/usr/bin/env python3
"""Runs `waterlight_methods --quick` and judges what it prints: check_report.py PROGRAM SCENARIOS

Every table parses, numbers are finite, methods that should converge do, and each keeps the light it should.
"""
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "accuracy"))
import check_report as accuracy  # noqa: E402

PARTS = ["What each can do", "Waves over a flat floor", "A pool", "Glass: five cups and a ring"]
# Three coarse resolutions show an order poorly: what is asked is that there is one.
LEAST_ORDER = 0.25
CONVERGE = ["two-pass, adaptive", "quads", "splat, jacobian", "beams"]
# Light on the map over what the truth lets through, less one.
MOST_LIGHT = {"photons": 1e-2, "photons, blurred": 1e-2}
MOST_LIGHT_ELSE = 1e-3


def faults(title, heads, rows):
    for row in rows:
        if len(row) != len(heads):
            yield f"has {len(heads)} heads and a row of {len(row)}: {row}"
            continue
        of = dict(zip(heads, row))
        if any("nan" in cell or "inf" == cell for cell in row):
            yield f"has no number in {row}"
        if row[0] == "order":
            yield from (f"converges with order {of[m]} for {m}" for m in CONVERGE if not float(of[m]) > LEAST_ORDER)
        if row[0].startswith("light - 1"):
            for method in heads[1:]:
                if not float(of[method]) <= MOST_LIGHT.get(method, MOST_LIGHT_ELSE):
                    yield f"has {of[method]} more or less light for {method}"
        if "light - 1" in of and "method" in of:
            if not abs(float(of["light - 1"])) <= MOST_LIGHT.get(of["method"], 2 * MOST_LIGHT_ELSE):
                yield f"has {of['light - 1']} more or less light in {row}"


def main(program, scenarios):
    text = subprocess.run([program, "--quick", scenarios], check=True, stdout=subprocess.PIPE, text=True).stdout
    found = list(accuracy.tables(text))
    said = [f"{title}: {fault}" for title, heads, rows in found for fault in faults(title, heads, rows)]
    said += [f"no part \"{part}\"" for part in PARTS if f"# {part}\n" not in text]
    said += ["no orders"] if not any(row[0] == "order" for _, _, rows in found for row in rows) else []
    print(text, *said, sep="\n")
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
