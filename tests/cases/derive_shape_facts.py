#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""derive_shape_facts.py [--check] CASES.json

Derives the facts of a file of hard cases pixel by pixel from the definitions below, in integers and
fractions, and writes them into the file; with --check it compares them with those in the file and
exits with 1 if any differ. Nothing is shared with the program.

A triangle, a polygon: a sample is inside the displaced shape or not, see RULES. A line: on each
column (each row where it is at least as long along y) between its ends the nearest pixel, the upper
or right one of two. A filled circle: samples at most a radius away from the centre. An outlined
one: on each column with |dx| - 1/2 <= r/sqrt(2) the pixels nearest to its two halves, of two
equally near the one farther from the centre, and the same by rows.
"""

import hashlib
import json
import sys
from collections import Counter
from fractions import Fraction
from math import isqrt

# The displacement of the sample as the order in which x and y break a tie; none: edges count.
RULES = {"closed": None, "half_open_column": "yx", "top_left": "xy"}
SHAPE_COLOUR = (200, 100, 50)
CHANNELS = ("R", "G", "B", "z", "u", "v", "N_x", "N_y", "N_z")


def sign(value):
    return (value > 0) - (value < 0)


def accepts(a, b, p, turn, order):
    """Whether the edge a b of a triangle that turns by `turn` has p on its inner side."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    function = turn * (dx * (p[1] - a[1]) - dy * (p[0] - a[0]))
    if function != 0 or order is None:
        return function >= 0
    gain = {"x": -turn * dy, "y": turn * dx}  # of the function along x, along y
    return (gain[order[0]] or gain[order[1]]) > 0


def triangle_samples(v, scale, window, rule):
    (xa, ya), (xb, yb), (xc, yc) = v
    turn = sign((xb - xa) * (yc - ya) - (xc - xa) * (yb - ya))
    if turn == 0:
        raise ValueError("a triangle without area")
    return {(x, y) for x, y in window
            if all(accepts(v[i], v[i - 2], (x * scale, y * scale), turn, RULES[rule])
                   for i in range(3))}


def winding(contour, p):
    """Edges above p (greater y) to the right, less those to the left, and how many; p displaced
    by (+e, +e^2)."""
    turns = []
    for a, b in zip(contour, contour[1:] + contour[:1]):
        turn = 1 if a[0] < b[0] else -1
        if turn < 0:
            a, b = b, a
        if not a[0] <= p[0] < b[0]:
            continue
        # (height of the edge at p - y of p) * (b.x - a.x)
        above = (a[1] - p[1]) * (b[0] - a[0]) + (b[1] - a[1]) * (p[0] - a[0])
        if above > 0 or (above == 0 and b[1] > a[1]):
            turns.append(turn)
    return sum(turns), len(turns)


def polygon_samples(contours, scale, window, fill):
    samples = set()
    for x, y in window:
        found = [winding(contour, (x * scale, y * scale)) for contour in contours]
        turns, crossings = (sum(column) for column in zip(*found))
        if turns != 0 if fill == "non-zero" else crossings % 2 == 1:
            samples.add((x, y))
    return samples


def arc_pixels(centre, radius, scale, firsts):
    """(along, across) of the arcs with |slope| <= 1; centre and radius in units of 1/scale."""
    for along in firsts:
        distance = abs(along * scale - centre[0])
        beyond = 2 * distance - scale
        if distance > radius or (beyond > 0 and beyond * beyond > 2 * radius * radius):
            continue
        # The floor of (centre + height + 1/2) needs no more of the root than its own floor.
        root = isqrt(4 * (radius * radius - distance * distance))
        yield along, (2 * centre[1] + scale + root) // (2 * scale)
        yield along, -((-2 * centre[1] + scale + root) // (2 * scale))


def circle_samples(case, window):
    (x, y), r, scale = case["centre"], case["radius"], case["scale"]
    if case["fill"] != "outline":
        return {(i, j) for i, j in window
                if (i * scale - x) ** 2 + (j * scale - y) ** 2 <= r * r}
    pixels = set(arc_pixels((x, y), r, scale, sorted({i for i, j in window})))
    pixels |= {(i, j) for j, i in arc_pixels((y, x), r, scale, sorted({j for i, j in window}))}
    return pixels & set(window)


def line_pixels(ends, scale):
    (xa, ya), (xb, yb) = ends
    steep = abs(yb - ya) >= abs(xb - xa)
    if steep:
        xa, ya, xb, yb = ya, xa, yb, xb
    if xb < xa:
        xa, ya, xb, yb = xb, yb, xa, ya
    pixels = []
    for along in range(-(-xa // scale), xb // scale + 1):
        slope = Fraction(yb - ya, xb - xa) if xb != xa else 0
        across = (ya + slope * (along * scale - xa)) / scale
        nearest = (across + Fraction(1, 2)).__floor__()
        pixels.append((nearest, along) if steep else (along, nearest))
    listed_by_y = abs(ends[1][1] - ends[0][1]) > abs(ends[1][0] - ends[0][0])
    return sorted(pixels, key=lambda p: (p[1], p[0]) if listed_by_y else p)


def plane_value(v, values, scale, x, y):
    (xa, ya), (xb, yb), (xc, yc) = v
    area = (xb - xa) * (yc - ya) - (xc - xa) * (yb - ya)
    dx, dy = x * scale - xa, y * scale - ya
    beta = Fraction(dx * (yc - ya) - dy * (xc - xa), area)
    gamma = Fraction((xb - xa) * dy - (yb - ya) * dx, area)
    return values[0] + (values[1] - values[0]) * beta + (values[2] - values[0]) * gamma


def rounded(value):
    return (value + Fraction(1, 2)).__floor__()


def sha(lines):
    return hashlib.sha256("".join(lines).encode()).hexdigest()[:16]


def pixel_hash(pixels):
    return sha(f"{x} {y}\n" for x, y in pixels)


def span_hash(samples):
    columns = {}
    for x, y in samples:
        low, high = columns.get(x, (y, y))
        columns[x] = (min(low, y), max(high, y))
    return sha(f"{x} {low} {high}\n" for x, (low, high) in sorted(columns.items()))


def window_of(case):
    (x, y), (width, height) = case["origin"], case["canvas"]
    return [(i, j) for i in range(x, x + width) for j in range(y, y + height)]


def histogram_of(coverings):
    times = Counter()
    for samples in coverings:
        times.update(samples)
    return {str(n): count for n, count in sorted(Counter(times.values()).items())}


def shape_facts(samples):
    return {"count": len(samples), "span_sha": span_hash(samples),
            "sha": pixel_hash(sorted(samples)),
            "sum8": [len(samples) * channel for channel in SHAPE_COLOUR]}


def circle_facts(case):
    return {"closed": shape_facts(circle_samples(case, window_of(case)))}


def polygon_facts(case):
    window = window_of(case)
    each = [polygon_samples(contours, case["scale"], window, case["fill"])
            for contours in case["polygons"]]
    facts = shape_facts(set().union(*each))
    if len(each) > 1:
        facts["histogram"] = histogram_of(each)
    return {"top_left": facts}


def line_facts(case):
    pixels = line_pixels(case["endpoints"], case.get("scale", 1))
    return {"count": len(pixels), "sha": pixel_hash(pixels)}


def mesh_facts(case):
    facts = {}
    for rule in RULES:
        each = [triangle_samples([case["vertices"][i] for i in corners], case["scale"],
                                 window_of(case), rule) for corners in case["triangles"]]
        facts[rule] = {"covered": len(set().union(*each)), "histogram": histogram_of(each)}
    return facts


def sequence_facts(case):
    facts = {}
    for rule in RULES:
        frames = [triangle_samples(frame, case["scale"], window_of(case), rule)
                  for frame in case["frames"]]
        facts[rule] = {"counts": [len(frame) for frame in frames],
                       "toggles": sum(len(a ^ b) for a, b in zip(frames, frames[1:]))}
    return facts


def channels_of(case):
    """The values at the three vertices, by channel."""
    corners = [[*colour, Fraction(a["z"], 256), *(Fraction(t, 256) for t in a["uv"]),
                *(Fraction(n, 256) for n in a["normal"])]
               for colour, a in zip(case["colours"], case["attributes"])]
    return dict(zip(CHANNELS, zip(*corners)))


def attribute_facts(case):
    v, scale, channels = case["vertices"], case["scale"], channels_of(case)
    facts, samples = {}, {}
    for rule in RULES:
        samples[rule] = triangle_samples(v, scale, window_of(case), rule)
        levels = [[rounded(plane_value(v, channels[c], scale, x, y)) for c in "RGB"]
                  for x, y in samples[rule]]
        facts[rule] = {"count": len(levels), "span_sha": span_hash(samples[rule]),
                       "sum8": [sum(column) for column in zip(*levels)]}
    for point in case["points"]:
        x, y = point["x"], point["y"]
        values = {c: plane_value(v, channels[c], scale, x, y) for c in CHANNELS}
        point["in"] = {rule: (x, y) in samples[rule] for rule in RULES}
        point["rgb"] = [str(values[c]) for c in "RGB"]
        point["rgb8"] = [rounded(values[c]) for c in "RGB"]
        point["values"] = {c: str(value) for c, value in values.items()}
    return facts


FACTS = {"line": line_facts, "circle": circle_facts, "polygon": polygon_facts,
         "mesh": mesh_facts, "sequence": sequence_facts, "attributes": attribute_facts}


def one_line(value):
    return json.dumps(value, ensure_ascii=False)


def text_of(file):
    """One line for each member of a case, for each rule's facts and for each point."""
    def member(key, value):
        if key == "expected" and any(rule in value for rule in RULES):
            rows = [f"    {one_line(rule)}: {one_line(facts)}" for rule, facts in value.items()]
            return f"   {one_line(key)}: {{\n" + ",\n".join(rows) + "}"
        if key in ("points", "frames") or (key == "triangles" and isinstance(value[0], dict)):
            return f"   {one_line(key)}: [\n" + ",\n".join(
                f"    {one_line(each)}" for each in value) + "]"
        return f"   {one_line(key)}: {one_line(value)}"
    cases = ["  {\n" + ",\n".join(member(*item) for item in case.items()) + "\n  }"
             for case in file["cases"]]
    head = [f" {one_line(key)}: {json.dumps(value, indent=2, ensure_ascii=False)}"
            for key, value in file.items() if key != "cases"]
    return "{\n" + ",\n".join(head) + ",\n \"cases\": [\n" + ",\n".join(cases) + "\n ]\n}\n"


def main(arguments):
    is_check = arguments[:1] == ["--check"]
    path = arguments[-1]
    with open(path, encoding="utf-8") as source:
        text = source.read()
    file = json.loads(text)
    file["families"] = dict(sorted(Counter(case["family"] for case in file["cases"]).items()))
    wrong = []
    for case in file["cases"]:
        before = one_line(case)
        case["expected"] = FACTS[case["kind"]](case)
        if one_line(case) != before:
            wrong.append(case["id"])
    print(f"{path}: {len(file['cases'])} cases derived, {len(wrong)} with other facts")
    if is_check:
        for name in wrong:
            print(f"{path}: {name}: the facts differ")
        return 1 if wrong else 0
    with open(path, "w", encoding="utf-8") as target:
        target.write(text_of(file))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
