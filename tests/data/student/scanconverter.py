# SPDX-License-Identifier: GPL-3.0-or-later
# A right column scan (rule closed), for the adapter to be tried with.
import math


def draw_triangle(frame, vertices):
    height, width = len(frame), len(frame[0])
    a, b, c = sorted(vertices, key=lambda v: v[:2])

    def at(first, last, x):  # y, r, g, b where an edge meets a column
        t = (x - first[0]) / (last[0] - first[0]) if last[0] != first[0] else 0
        return [p + t * (q - p) for p, q in zip(first[1:], last[1:])]

    for x in range(max(0, math.ceil(a[0])), min(width - 1, math.floor(c[0])) + 1):
        ends = [at(a, c, x), at(a, b, x) if x < b[0] else at(b, c, x)]
        low, high = sorted(ends, key=lambda end: end[0])
        for y in range(max(0, math.ceil(low[0])), min(height - 1, math.floor(high[0])) + 1):
            t = (y - low[0]) / (high[0] - low[0]) if high[0] != low[0] else 0
            levels = [p + t * (q - p) for p, q in zip(low[1:], high[1:])]
            frame[y][x] = [math.floor(level + 0.5) for level in levels]
