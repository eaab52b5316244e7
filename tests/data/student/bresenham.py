# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws lines between whole coordinates by Bresenham's steps, as a student writes it from the slides.

bresenham.py START TIE SCENE... draws each scene, a JSON file, into a PPM file beside it. START is given, or left: "store left
line endpoint in (x0, y0)". TIE says what p = 0 does: crosses, or stays. bresenham.txt lists mistakes, as lines replaced."""
import json
import sys
from math import floor

left_first = sys.argv[1] == "left"
least_across = 0 if sys.argv[2] == "crosses" else 1


def draw(x0, y0, x1, y1, c0, c1):
    steep = abs(y1 - y0) >= abs(x1 - x0)
    if steep:
        x0, y0, x1, y1 = y0, x0, y1, x1
    swapped = left_first and x1 < x0
    if swapped:
        x0, y0, c0, x1, y1, c1 = x1, y1, c1, x0, y0, c0
    dx, dy = abs(x1 - x0), abs(y1 - y0)
    across = -1 if y1 < y0 else 1
    first = 2 * dy - dx
    stay = 2 * dy
    cross = 2 * dy - 2 * dx
    divisor = dx
    p, y = first, y0
    for k in range(dx + 1):
        x = x0 - k if x1 < x0 else x0 + k
        level = [a + (b - a) * k / divisor if dx else float(a) for a, b in zip(c0, c1)]
        paint(x, y, steep, [min(max(floor(l + 0.5), 0), 255) for l in level])
        crosses = p >= least_across
        if crosses:
            y += across
        p += cross if crosses else stay


def paint(x, y, steep, colour):
    if steep:
        x, y = y, x
    if 0 <= x < width and 0 <= y < height:
        pixels[(height - 1 - y) * width + x] = colour


def channels(text): return [int(text[i:i + 2], 16) for i in (1, 3, 5)]


for path in sys.argv[3:]:
    with open(path, encoding="utf-8") as file:
        scene = json.load(file)
    width, height = scene["frame"]["width"], scene["frame"]["height"]
    pixels = [channels(scene["frame"]["background"])] * (width * height)
    for primitive in scene["primitives"]:
        draw(*primitive["line"][0], *primitive["line"][1], *map(channels, primitive["colors"]))
    with open(path + ".ppm", "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (width, height))
        file.write(bytes(level for pixel in pixels for level in pixel))
