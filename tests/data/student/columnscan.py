# SPDX-License-Identifier: GPL-3.0-or-later
"""A column scan that is not ours, in exact fractions: right, or with one mistake of those that are named below.

columnscan.py [floor | ceil | plus | late] < SCENE.json > PICTURE.ppm
"""
import json
import sys
from fractions import Fraction
from math import ceil, floor


def edge_at(start, end, x, late):
    """y and the levels where an edge meets a column; late: levels without their pre-step."""
    (x0, y0), levels = start
    (x1, y1), others = end
    way = (x - x0) / (x1 - x0)
    colour_way = (x - ceil(x0)) / (x1 - x0) if late else way
    return y0 + way * (y1 - y0), [a + colour_way * (b - a) for a, b in zip(levels, others)]


def bounds(vertices, x, late):
    first, middle, last = vertices
    if middle[0][0] == last[0][0] == x:  # an edge along the column
        return sorted([(middle[0][1], middle[1]), (last[0][1], last[1])])
    half = (first, middle) if x < middle[0][0] else (middle, last)
    return sorted([edge_at(first, last, x, late), edge_at(*half, x, late)])


def draw(vertices, mistake, paint):
    for x in range(ceil(vertices[0][0][0]), floor(vertices[2][0][0]) + 1):
        (bottom, lower), (top, upper) = bounds(vertices, x, mistake == "late")
        divisor = top - bottom + (1 if mistake == "plus" else 0)
        rates = [(b - a) / divisor if divisor else 0 for a, b in zip(lower, upper)]
        begin = floor(bottom) if mistake == "floor" else ceil(bottom)
        end = ceil(top) if mistake == "ceil" else floor(top)
        for y in range(begin, end + 1):
            levels = [a + (y - bottom) * rate for a, rate in zip(lower, rates)]
            paint(x, y, [min(255, max(0, floor(level + Fraction(1, 2)))) for level in levels])


scene = json.load(sys.stdin)
width, height = scene["frame"]["width"], scene["frame"]["height"]
pixels = [[[0, 0, 0]] * width for _ in range(height)]


def paint(x, y, colour):
    if 0 <= x < width and 0 <= y < height:
        pixels[y][x] = colour


for primitive in scene["primitives"]:
    points = [[Fraction(str(c)) for c in point] for point in primitive["triangle"]]
    colours = [[int(text[i:i + 2], 16) for i in (1, 3, 5)] for text in primitive["colors"]]
    draw(sorted(zip(points, colours)), "".join(sys.argv[1:]), paint)
print(f"P3\n{width} {height}\n255")
for line in reversed(pixels):
    print(" ".join(str(level) for pixel in line for level in pixel))
