#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads every .csv and .json of a folder as strictly as its format allows; prints how many there
are. A fault is said on stderr and ends the reading with 1."""
import csv
import fractions
import json
import math
import pathlib
import sys


def members_once(pairs):
    names = [name for name, _ in pairs]
    repeated = {name for name in names if names.count(name) > 1}
    if repeated:
        raise ValueError(f"repeated members: {sorted(repeated)}")
    return dict(pairs)


def refuse_constant(name):
    raise ValueError(f"{name} is not JSON")


def read_json(path):
    json.loads(path.read_text("utf-8"), object_pairs_hook=members_once,
               parse_constant=refuse_constant)


def compare(name, cells):
    """A program that reads doubles finds the error that stands beside what was used."""
    used, error = float(cells[name]), float(cells[name + "_error"])
    if not math.isfinite(used):
        return
    exact = fractions.Fraction(cells[name + "_exact"])
    if error == 0 and used != float(exact):
        raise ValueError(f"{name} is {cells[name]}, not the double nearest to {exact}")
    rounding = max(abs(used), abs(error)) * 2**-50
    if abs(fractions.Fraction(used) - exact - fractions.Fraction(error)) > rounding:
        raise ValueError(f"{name} is {cells[name]} for {exact} with an error of {error}")


def read_csv(path):
    with path.open(encoding="utf-8", newline="") as file:
        rows = csv.reader(file, strict=True)
        names = next(rows)
        if len(set(names)) != len(names):
            raise ValueError(f"repeated names: {names}")
        for row in rows:
            if len(row) != len(names):
                raise ValueError(f"line {rows.line_num}: {len(row)} cells, {len(names)} names")
            cells = dict(zip(names, row))
            for name, cell in cells.items():
                if name.endswith("_error") and cell:
                    compare(name.removesuffix("_error"), cells)


def main(folder):
    count = 0
    for path in sorted(pathlib.Path(folder).iterdir()):
        try:
            (read_json if path.suffix == ".json" else read_csv)(path)
        except ValueError as fault:
            sys.exit(f"{path.name}: {fault}")
        count += 1
    print(count)


main(sys.argv[1])
