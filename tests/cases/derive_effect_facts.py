#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""derive_effect_facts.py [--check] CASES.json

Derives the facts of the hard cases of effects pixel by pixel from the definitions below, in
fractions, and writes them into the file; with --check it compares them with those in the file and
exits with 1 if any differ. Nothing is shared with the program.

Triangles are drawn in order on black. Attributes are linear over w in the frame, but for z, which
is linear. A colour is rounded to bytes, multiplied by the texel's (floor(c*t/255 + 1/2)) and blended
by its alpha's byte over what stands (floor((s*a + d*(255 - a))/255 + 1/2)). What is not farther than
the nearest so far is drawn, and becomes the nearest. With 4 or 16 samples the pixels whose square
an edge meets have the mean of the pictures that are seen from the samples; with the area, alpha is
multiplied by the part of the pixel's square that the triangle covers, with the attributes of the
triangle's plane at the pixel's centre, and nothing where 1/w is not above 0 there. A triangle
without area is the segment between its outermost vertices: the closed rule draws the pixels whose
centres lie on it, whole, with the attributes between those two; other rules draw nothing. Under
top_left y points down, but up in the patterns of the samples.
"""

import sys
from fractions import Fraction
from math import floor

import derive_shape_facts as shapes

RULES = dict(shapes.RULES, open="none")
PATTERNS = {
    4: [(-32, -96), (96, -32), (-96, 32), (32, 96)],
    16: [(16 * x, 16 * y) for x, y in (
        (1, 1), (-1, -3), (-3, 2), (4, -1), (-5, -2), (2, 5), (5, 3), (3, -5),
        (-2, 6), (0, -7), (-4, -6), (-6, 4), (-8, 0), (7, -4), (6, 7), (-7, -8))]}


def byte(value):
    return min(max(floor(value + Fraction(1, 2)), 0), 255)


def area_of(v):
    (xa, ya), (xb, yb), (xc, yc) = v
    return (xb - xa) * (yc - ya) - (xc - xa) * (yb - ya)


def covers(v, p, rule):
    """Whether the triangle has the sample p; both in px."""
    turn = shapes.sign(area_of(v))
    for a, b in ((v[0], v[1]), (v[1], v[2]), (v[2], v[0])):
        if RULES[rule] == "none":
            if turn * area_of((a, b, p)) <= 0:
                return False
        elif not shapes.accepts(a, b, p, turn, RULES[rule]):
            return False
    return True


def weights(v, p):
    whole = area_of(v)
    return [Fraction(area_of((p, v[1], v[2])), whole), Fraction(area_of((v[0], p, v[2])), whole),
            Fraction(area_of((v[0], v[1], p)), whole)]


def segment_weights(v, p):
    """The weights of the outermost vertices at p, none where p is not on the segment."""
    start, end = min(range(3), key=lambda i: v[i]), max(range(3), key=lambda i: v[i])
    (xa, ya), (xb, yb) = v[start], v[end]
    way = max(abs(xb - xa), abs(yb - ya))
    if area_of((v[start], v[end], p)) != 0 or not (min(xa, xb) <= p[0] <= max(xa, xb)
                                                   and min(ya, yb) <= p[1] <= max(ya, yb)):
        return None
    parts = [Fraction(0)] * 3
    along = max(abs(p[0] - xa), abs(p[1] - ya)) / way if way else Fraction(0)
    parts[start] += 1 - along
    parts[end] += along
    return parts


def mean(parts, values):
    return sum(part * value for part, value in zip(parts, values))


def below(a, b, side):
    """The integral over x, from a to b, of y clamped to 0 ... side, where x is in 0 ... side."""
    (xa, ya), (xb, yb) = a, b
    if xa == xb:
        return 0
    slope = Fraction(yb - ya) / (xb - xa)
    cuts = {Fraction(min(max(x, 0), side)) for x in (xa, xb)}
    low, high = min(cuts), max(cuts)
    if slope != 0:
        cuts |= {x for x in (xa - ya / slope, xa + (side - ya) / slope) if low < x < high}
    cuts = sorted(cuts)
    heights = [min(max(ya + slope * (x - xa), 0), side) for x in cuts]
    integral = sum((right - left) * (one + other) / 2 for left, right, one, other
                   in zip(cuts, cuts[1:], heights, heights[1:]))
    return integral if xa < xb else -integral


def share(v, p):
    """The part of the unit square around p that the triangle covers."""
    corner = (p[0] - Fraction(1, 2), p[1] - Fraction(1, 2))
    moved = [(x - corner[0], y - corner[1]) for x, y in v]
    return abs(sum(below(moved[i - 1], moved[i], 1) for i in range(3)))


def meets(a, b, p):
    """Whether the segment has a point whose distance to p is at most 1/2 along each axis: what is
    left of it between the four sides (Liang and Barsky)."""
    first, last = Fraction(0), Fraction(1)
    for axis in (0, 1):
        start, way = Fraction(a[axis] - p[axis]), Fraction(b[axis] - a[axis])
        if way == 0:
            if abs(start) > Fraction(1, 2):
                return False
            continue
        ends = sorted(((-Fraction(1, 2) - start) / way, (Fraction(1, 2) - start) / way))
        first, last = max(first, ends[0]), min(last, ends[1])
    return first <= last


def texel(material, i, j):
    """Of the checker, 8 by 8."""
    if material["wrap"] == "repeat":
        i, j = i % 8, j % 8
    else:
        i, j = min(max(i, 0), 7), min(max(j, 0), 7)
    return [255 * (1 - (i + j) % 2)] * 3


def texture_bytes(material, uv):
    place = [8 * t for t in uv]
    if material["filter"] == "nearest":
        return texel(material, floor(place[0]), floor(place[1]))
    place = [t - Fraction(1, 2) for t in place]
    i, j = floor(place[0]), floor(place[1])
    x, y = place[0] - i, place[1] - j
    levels = [0, 0, 0]
    for weight, read in (((1 - x) * (1 - y), texel(material, i, j)),
                         (x * (1 - y), texel(material, i + 1, j)),
                         ((1 - x) * y, texel(material, i, j + 1)),
                         (x * y, texel(material, i + 1, j + 1))):
        levels = [level + weight * t for level, t in zip(levels, read)]
    return [byte(level) for level in levels]


class Triangle:
    def __init__(self, case, member):
        self.v = [(Fraction(x, case["scale"]), Fraction(y, case["scale"]))
                  for x, y in member["vertices"]]
        self.colours = member.get("colours", [[255] * 3] * 3)
        self.alpha = member.get("alpha", [255] * 3)
        self.z, self.w = ([Fraction(n) for n in member.get(key, default)]
                          for key, default in (("z", [0] * 3), ("w", [1] * 3)))
        self.uv = [[Fraction(n) for n in pair] for pair in member.get("uv", [[0, 0]] * 3)]
        material = member.get("material")
        self.material = None if material is None else case["materials"][material]

    def moved(self, dx, dy):
        return [(x - dx, y - dy) for x, y in self.v]


def drawn(case, triangles, p, offset, rule):
    """The bytes of a sample, none where nothing is drawn."""
    colour, nearest, is_drawn = [0, 0, 0], None, False
    bits = case.get("depthBits", "exact")
    for triangle in triangles:
        v = triangle.moved(*offset)
        part = 1
        if area_of(v) == 0:
            parts = segment_weights(triangle.v, p) if rule == "closed" else None
        elif case.get("antialiasing") == "area":
            part = share(v, p)
            parts = weights(v, p) if part > 0 else None
        else:
            parts = weights(v, p) if covers(v, p, rule) else None
        if parts is None:
            continue
        seen = [part_of / w for part_of, w in zip(parts, triangle.w)]
        if sum(seen) <= 0:
            continue
        seen = [each / sum(seen) for each in seen]
        if case.get("depth") != "off":
            z = mean(parts, triangle.z)
            if bits != "exact":
                z = floor(min(max(z, 0), 1) * (2 ** bits - 1) + Fraction(1, 2))
            if nearest is not None and z > nearest:
                continue
            nearest = z
        source = [byte(mean(seen, levels)) for levels in zip(*triangle.colours)]
        if triangle.material:
            read = texture_bytes(triangle.material, [mean(seen, t) for t in zip(*triangle.uv)])
            source = [byte(Fraction(c * t, 255)) for c, t in zip(source, read)]
        alpha = byte(part * byte(mean(seen, triangle.alpha)))
        colour = [byte(Fraction(s * alpha + d * (255 - alpha), 255))
                  for s, d in zip(source, colour)]
        is_drawn = True
    return colour if is_drawn else None


def pixel_bytes(case, triangles, p, rule):
    pattern = PATTERNS.get(case.get("antialiasing"))
    edges = [(triangle.v[i - 1], triangle.v[i]) for triangle in triangles for i in range(3)
             if area_of(triangle.v) != 0]
    if not pattern or not any(meets(a, b, p) for a, b in edges):
        return drawn(case, triangles, p, (0, 0), rule)
    up = -1 if rule == "top_left" else 1
    samples = [drawn(case, triangles, p, (Fraction(dx, 256), up * Fraction(dy, 256)), rule)
               for dx, dy in pattern]
    if not any(samples):
        return None
    sums = [sum(column) for column in zip(*(sample or [0, 0, 0] for sample in samples))]
    return [byte(Fraction(total, len(pattern))) for total in sums]


def facts_of(case):
    facts = {}
    triangles = [Triangle(case, member) for member in case["triangles"]]
    for rule in RULES:
        found = {p: pixel_bytes(case, triangles, p, rule) for p in shapes.window_of(case)}
        pixels = {p: colour for p, colour in sorted(found.items()) if colour is not None}
        facts[rule] = {
            "count": len(pixels),
            "sum8": [sum(column) for column in zip(*pixels.values())] or [0, 0, 0],
            "rgb_sha": shapes.sha(f"{x} {y} {r} {g} {b}\n"
                                  for (x, y), (r, g, b) in pixels.items())}
    return facts


shapes.FACTS["effects"] = facts_of

if __name__ == "__main__":
    sys.exit(shapes.main(sys.argv[1:]))
