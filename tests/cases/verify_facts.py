#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""verify_facts.py CASES.json...

Derives every expected fact of files of hard cases again and compares. Nothing is shared with the
program: coverage by dividing each column in rational numbers (rows instead of columns for the
top-left rule, which is the column rule with x and y exchanged), colour by Cramer's rule about the
first vertex. Lines and invalid input have no such facts. Exit code 1 if any fact differs.
"""

import hashlib
import json
import sys
from collections import Counter
from fractions import Fraction

RULES = ("closed", "half_open_column", "top_left")
DEFAULT_COLOURS = [[255, 0, 0], [0, 255, 0], [0, 0, 255]]


def ceil_divide(numerator, denominator):
    return -(-numerator // denominator)


def doubled_area(v):
    (x0, y0), (x1, y1), (x2, y2) = v
    return (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)


def ordinate(a, b, at):
    """y of the edge a b above the abscissa `at`, in the vertices' units."""
    return a[1] + Fraction((at - a[0]) * (b[1] - a[1]), b[0] - a[0])


def closed_span(v, scale, x):
    """The first and last row of a column of the closed triangle, or None."""
    at = x * scale
    ordinates = []
    for a, b in ((v[0], v[1]), (v[1], v[2]), (v[2], v[0])):
        if a[0] > b[0]:
            a, b = b, a
        if not a[0] <= at <= b[0]:
            continue
        ordinates += [a[1], b[1]] if a[0] == b[0] else [ordinate(a, b, at)]
    if not ordinates:
        return None
    low, high = min(ordinates), max(ordinates)
    return ceil_divide(Fraction(low), scale), Fraction(high) // scale


def half_open_span(v, scale, x):
    """The same for samples displaced by (+e^2, +e): only edges that go on to the right count."""
    at = x * scale
    ordinates = []
    for a, b in ((v[0], v[1]), (v[1], v[2]), (v[2], v[0])):
        if a[0] > b[0]:
            a, b = b, a
        if a[0] <= at < b[0]:
            ordinates.append(ordinate(a, b, at))
    if len(ordinates) != 2 or doubled_area(v) == 0:
        return None
    low, high = min(ordinates), max(ordinates)
    return ceil_divide(low, scale), ceil_divide(high, scale) - 1


def spans(v, scale, window, rule):
    """Yields x, first and last y of each column of the window [x0, x1) x [y0, y1) with samples."""
    x0, y0, x1, y1 = window
    span = closed_span if rule == "closed" else half_open_span
    first = max(x0, ceil_divide(min(p[0] for p in v), scale))
    end = min(x1, max(p[0] for p in v) // scale + 1)
    for x in range(first, end):
        rows = span(v, scale, x)
        if rows is None:
            continue
        low, high = max(rows[0], y0), min(rows[1], y1 - 1)
        if low <= high:
            yield x, low, high


def runs(v, scale, window, rule):
    """Yields the window's samples that the triangle covers, a column or a row at a time: the first
    sample, the step to the next one, and how many there are."""
    if rule != "top_left":
        for x, low, high in spans(v, scale, window, rule):
            yield (x, low), (0, 1), high - low + 1
        return
    x0, y0, x1, y1 = window
    swapped = [(y, x) for x, y in v]
    for y, left, right in spans(swapped, scale, (y0, x0, y1, x1), "half_open_column"):
        yield (left, y), (1, 0), right - left + 1


def samples_of(run):
    (x, y), (right, up), count = run
    return ((x + k * right, y + k * up) for k in range(count))


def covered(v, scale, window, rule):
    return {sample for run in runs(v, scale, window, rule) for sample in samples_of(run)}


class Plane:
    """The colour at a sample as numerators over one denominator."""

    def __init__(self, v, colours, scale):
        self.v, self.scale = v, scale
        self.area = doubled_area(v)
        if self.area == 0:
            order = sorted(range(3), key=lambda i: (v[i], i))
            self.first, self.last = order[0], order[2]
        self.colours = colours

    def numerators(self, x, y):
        (xa, ya), (xb, yb), (xc, yc) = self.v
        dx, dy = x * self.scale - xa, y * self.scale - ya
        if self.area != 0:
            weight_b = dx * (yc - ya) - dy * (xc - xa)  # Cramer: d = s (b - a) + t (c - a)
            weight_c = (xb - xa) * dy - (yb - ya) * dx
            sign = 1 if self.area > 0 else -1
            return [sign * (a * self.area + (b - a) * weight_b + (c - a) * weight_c)
                    for a, b, c in zip(*self.colours)], sign * self.area
        p, q = self.v[self.first], self.v[self.last]
        axis = 0 if p[0] != q[0] else 1
        length = q[axis] - p[axis]
        if length == 0:
            return list(self.colours[self.first]), 1
        along = (x, y)[axis] * self.scale - p[axis]
        return [a * length + (b - a) * along
                for a, b in zip(self.colours[self.first], self.colours[self.last])], length

    def levels(self, x, y):
        numerators, denominator = self.numerators(x, y)
        return [Fraction(n, denominator) for n in numerators]

    def bytes(self, x, y):
        numerators, denominator = self.numerators(x, y)
        return [(2 * n + denominator) // (2 * denominator) for n in numerators]

    def sums(self, run):
        """The bytes of a run added up, channel by channel. Along a run the numerators grow by the
        same number at every step: the plane is linear."""
        (x, y), (right, up), count = run
        first, denominator = self.numerators(x, y)
        second, _ = self.numerators(x + right, y + up)
        doubled = 2 * denominator
        totals = []
        for a, b in zip(first, second):
            start, step = 2 * a + denominator, 2 * (b - a)
            totals.append(start // doubled * count if step == 0 else
                          sum(n // doubled for n in range(start, start + step * count, step)))
        return totals


def span_hash(found):
    columns = {}
    for run in found:
        (x, y), (right, up), count = run
        # A column's samples all lie between the first and the last.
        for x, y in samples_of(run) if right else ((x, y), (x, y + count - 1)):
            low, high = columns.get(x, (y, y))
            columns[x] = (min(low, y), max(high, y))
    text = "".join(f"{x} {low} {high}\n" for x, (low, high) in sorted(columns.items()))
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def points_of(vertices):
    return [tuple(vertex) for vertex in vertices]


def window_of(case, offset=(0, 0)):
    x, y = (o + d for o, d in zip(case["origin"], offset))
    width, height = case["canvas"]
    return x, y, x + width, y + height


def triangle_facts(case, rule):
    v, scale = points_of(case["vertices"]), case["scale"]
    found = list(runs(v, scale, window_of(case), rule))
    plane = Plane(v, case.get("colours", DEFAULT_COLOURS), scale)
    sums = [0, 0, 0]
    for run in found:
        sums = [total + more for total, more in zip(sums, plane.sums(run))]
    return {"count": sum(count for _, _, count in found), "span_sha": span_hash(found),
            "sum8": sums}


def mesh_facts(case, rule):
    times = Counter()
    for corners in case["triangles"]:
        v = points_of(case["vertices"][corner] for corner in corners)
        times.update(covered(v, case["scale"], window_of(case), rule))
    histogram = Counter(times.values())
    return {"covered": len(times), "histogram": {str(k): n for k, n in histogram.items()}}


def sequence_facts(case, rule):
    frames = [covered(points_of(frame), case["scale"], window_of(case), rule)
              for frame in case["frames"]]
    return {"counts": [len(frame) for frame in frames],
            "toggles": sum(len(a ^ b) for a, b in zip(frames, frames[1:]))}


def translation_facts(case, rule):
    scale = case["scale"]
    pictures, counts = set(), set()
    for right, up in case["offsets_px"]:
        v = [(x + right * scale, y + up * scale) for x, y in points_of(case["vertices"])]
        samples = covered(v, scale, window_of(case, (right, up)), rule)
        plane = Plane(v, case.get("colours", DEFAULT_COLOURS), scale)
        counts.add(len(samples))
        pictures.add(frozenset((x - right, y - up, *plane.bytes(x, y)) for x, y in samples))
    return {"count": counts.pop() if len(counts) == 1 else sorted(counts),
            "distinct_pictures": len(pictures)}


FACTS = {"triangle": triangle_facts, "mesh": mesh_facts, "sequence": sequence_facts,
         "translation": translation_facts}


def point_differences(case):
    v, scale = points_of(case["vertices"]), case["scale"]
    plane = Plane(v, case.get("colours", DEFAULT_COLOURS), scale)
    for point in case.get("points", []):
        x, y = point["x"], point["y"]
        for rule, expected in point["in"].items():
            found = bool(covered(v, scale, (x, y, x + 1, y + 1), rule))
            if found != expected:
                yield f"sample ({x}, {y}) {rule}: {found} instead of {expected}"
        if [Fraction(text) for text in point["rgb"]] != plane.levels(x, y):
            yield f"sample ({x}, {y}): levels {plane.levels(x, y)} instead of {point['rgb']}"
        if point["rgb8"] != plane.bytes(x, y):
            yield f"sample ({x}, {y}): bytes {plane.bytes(x, y)} instead of {point['rgb8']}"


def differences(case):
    for rule in RULES:
        expected = case["expected"].get(rule)
        if expected is None:
            continue
        found = FACTS[case["kind"]](case, rule)
        for key, value in expected.items():
            if key in found and found[key] != value:
                yield f"{rule} {key}: {found[key]} instead of {value}"
            elif key not in found:
                yield f"{rule} {key}: not known here"
    if case["kind"] == "triangle":
        yield from point_differences(case)


def main(paths):
    wrong = 0
    for path in paths:
        with open(path, encoding="utf-8") as file:
            cases = json.load(file)["cases"]
        derived = [case for case in cases if case["kind"] in FACTS]
        for case in derived:
            for difference in differences(case):
                wrong += 1
                print(f"{path}: {case['id']}: {difference}")
        print(f"{path}: {len(derived)} of {len(cases)} cases derived again, {wrong} facts differ")
    return 1 if wrong or not paths else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
