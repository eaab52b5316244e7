# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills triangles by testing the samples of a box against three edges, in doubles, as a student writes it from the slides.

edgetests.py BOX SCENE... draws each scene, a JSON file, into a PPM file beside it. BOX is inward or outward: how it is rounded.
edgetests.txt lists mistakes, as lines replaced."""
import json
import sys
from fractions import Fraction
from math import ceil, floor, trunc

first, last = (ceil, floor) if sys.argv[1] == "inward" else (floor, ceil)


def edge(a, b, x, y):
    one = (b[0] - a[0]) * (y - a[1])
    other = (b[1] - a[1]) * (x - a[0])
    return one - other


def kept(e): return e


def is_inside(e, area):
    e0, e1, e2 = [-v if area < 0 else v for v in e]
    return e0 >= 0 and e1 >= 0 and e2 >= 0


def weights(e, area):
    divisor = area
    w0, w1 = e[1] / divisor, e[2] / divisor
    w2 = e[0] / divisor
    return w0, w1, w2


def draw(points, colours):
    area = kept(edge(*points[:2], *points[2]))
    boxed = points
    xs, ys = [p[0] for p in boxed], [p[1] for p in boxed]
    left, right = first(min(xs)), last(max(xs))
    bottom, top = first(min(ys)), last(max(ys))
    for y in range(bottom, top + 1):
        for x in range(left, right + 1):
            at = float(x), float(y)
            e = [kept(edge(points[i], points[(i + 1) % 3], *at)) for i in range(3)]
            if not is_inside(e, area):
                continue
            w = weights(e, area)
            levels = [sum((w[i] * colours[i][channel] for i in range(3)), 0.0) for channel in range(3)]
            if 0 <= x < width and 0 <= y < height:
                pixels[(height - 1 - y) * width + x] = [min(max(floor(level + 0.5), 0), 255) for level in levels]


def channels(text): return [int(text[i:i + 2], 16) for i in (1, 3, 5)]


for path in sys.argv[2:]:
    with open(path, encoding="utf-8") as file:
        scene = json.load(file)
    width, height = scene["frame"]["width"], scene["frame"]["height"]
    pixels = [channels(scene["frame"]["background"])] * (width * height)
    for primitive in scene["primitives"]:
        draw([[float(Fraction(str(c))) for c in point] for point in primitive["triangle"]], [channels(c) for c in primitive["colors"]])
    with open(path + ".ppm", "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (width, height))
        file.write(bytes(level for pixel in pixels for level in pixel))
