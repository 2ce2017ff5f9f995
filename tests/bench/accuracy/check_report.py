#!/usr/bin/env python3
"""Runs `waterlight_accuracy --quick` and judges what it prints: check_report.py PROGRAM

Every table parses, every number is finite, errors are not negative, what should converge does, and each part is there.
"""
import math
import re
import subprocess
import sys

PARTS = ["The floor map", "Steepness", "The truth itself", "The sun's disc", "Colour", "Plane irradiance on slices",
         "Pictures of flat water", "`linear` and `airy`", "`shallow-water`", "Which to choose"]
# Columns of methods whose error must fall with the resolution, in rows "order". The pixel footprint's does not. Few coarse
# resolutions show the order poorly: what is asked is that there is one.
LEAST_ORDER = 0.3
CONVERGE = ["adaptive", "adaptive, 2 x 2", "RMSE", "linear"]
NUMBER = re.compile(r"^~?([-+]?\d[\d.]*(?:e[-+]?\d+)?)(?: %)?$")


def tables(text):
    """(title of the section, heads, rows) of every table."""
    title, block = "", []
    for line in text.splitlines() + [""]:
        if line.startswith("|"):
            block.append([cell.strip() for cell in line.strip().strip("|").split("|")])
            continue
        if block:
            yield title, block[0], block[2:]
            block = []
        if line.startswith("#"):
            title = line.lstrip("# ")


def faults(title, heads, rows):
    if not rows:
        yield "has no rows"
    orders = 0
    for row in rows:
        if len(row) != len(heads):
            yield f"has {len(heads)} heads and a row of {len(row)}: {row}"
            continue
        for head, cell in zip(heads, row):
            number = NUMBER.match(cell)
            if re.search(r"\b(nan|inf)\b", cell):
                yield f"has {cell} for {head} in {row}"
            if cell.endswith("%") and not (number and 0 <= float(number[1]) and math.isfinite(float(number[1]))):
                yield f"has the error {cell} for {head} in {row}"
        if "order" in row[:2]:
            for head, cell in zip(heads, row):
                if head in CONVERGE:
                    orders += 1
                    if not float(cell) > LEAST_ORDER:
                        yield f"converges with order {cell} for {head} in {row}"
    if any("order" in row[:2] for row in rows) and orders == 0:
        yield "has orders of nothing that is known to converge"


def main(program):
    text = subprocess.run([program, "--quick"], check=True, stdout=subprocess.PIPE, text=True).stdout
    found = list(tables(text))
    said = [f"{title}: {fault}" for title, heads, rows in found for fault in faults(title, heads, rows)]
    said += [f"no part \"{part}\"" for part in PARTS if f"# {part}\n" not in text]
    said += ["no table of choices"] if not any(title == "Which to choose" for title, _, _ in found) else []
    print(text, *said, sep="\n")
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
