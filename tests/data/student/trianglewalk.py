# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills triangles between their edges, as a student writes it from the text of the assignment.

trianglewalk.py NUMBERS LINES SCENE... draws each scene, a JSON file, into a PPM file beside it. NUMBERS is fraction or double;
LINES is columns, rows (the greatest y first) or rows-from-below. trianglewalk.txt lists mistakes, as lines replaced."""
import json
import sys
from fractions import Fraction
from math import ceil, floor

Number = {"fraction": Fraction, "double": float}[sys.argv[1]]
by_rows = sys.argv[2] != "columns"
onward = -1 if sys.argv[2] == "rows" else 1  # spans are counted in the direction of the walk
FIRST, SECOND, LONG = range(3)


def cut(v): return Number(int(min(max(v, -10**9), 10**9)))  # whole numbers of 32 bits
def down(v): return Number(floor(v))
def nearest(v): return Number(floor(v + Number(1) / 2))
def whole(x): return onward * floor(onward * x)
def near(x): return onward * floor(onward * x + Number(1) / 2)
def ratio(a, b): return a / b if b else Number(0)
def slope(a, b): return ratio(b.y - a.y, b.x - a.x)


def compared(vertices, i, j):
    v = list(vertices)
    if v[j].x < v[i].x:
        v[i], v[j] = v[j], v[i]
    return v


class Vertex:
    def __init__(self, x, y, colour):
        self.x, self.y, self.colour = x, y, colour


class Bound:
    """Where an edge meets the current span, its increments, and the vertex where it begins."""
    begin = None

    def __init__(self, y, m, colour, step):
        self.y, self.m, self.colour, self.step = y, m, colour, step

    def step_place(self):
        self.y = place(self.y + self.m)

    def step_colour(self):
        self.colour = [edge_level(c + s) for c, s in zip(self.colour, self.step)]


def place(y): return y
def edge_level(c): return c
def span_level(c): return c


def added(e, keep_y, keep_c):
    """The bound with what is kept of what it adds to its vertex."""
    if e.begin is None:
        return e
    colour = [c + keep_c(v - c) for c, v in zip(e.begin.colour, e.colour)]
    return Bound(e.begin.y + keep_y(e.y - e.begin.y), e.m, colour, e.step)


def edge(side, a, b, x):
    if a.x == b.x:
        return Bound(place(a.y), Number(0), list(a.colour), [Number(0)] * 3)
    run = b.x - a.x
    rise = b.y - a.y
    slope_run = run
    colour_run = run
    c0, c1 = a.colour, b.colour
    change = [q - p for p, q in zip(c0, c1)]
    way = x - a.x
    ways = [way, way, way]
    m = ratio(rise, slope_run)
    steps = [ratio(c, colour_run) for c in change]
    y = place(a.y + way * m)
    colour = [edge_level(c + w * s) for c, w, s in zip(a.colour, ways, steps)]
    r, g, b = steps
    bound = Bound(y, m, colour, [r, g, b])
    bound.begin = a
    return bound


def draw_span(x, short, long):
    """Whether the span has a sample."""
    global gone_on
    short_below = short.y < long.y if short.y != long.y else middle_below
    lower, upper = (short, long) if short_below else (long, short)
    low, high = lower.colour, upper.colour
    first = ceil(lower.y)
    last = floor(upper.y)
    height = upper.y - lower.y
    pre_step = first - lower.y
    start = low
    rates = [ratio(h - l, height) for l, h in zip(low, high)]
    r, g, b = rates
    pre = [pre_step * rate for rate in (r, g, b)]
    level = [l + p for l, p in zip(start, pre)]
    step = [r, g, b]
    level = [span_level(l) for l in level]
    for y in range(first, last + 1):
        paint(x, y, [min(max(floor(l + Number(1) / 2), 0), 255) for l in level])
        level = [span_level(l + s) for l, s in zip(level, step)]
    gone_on = level
    return first <= last


def step_edges(short, long):
    for bound in (short, long):
        bound.step_place()
        bound.step_colour()


def walk(x, short, long):
    draw_span(x, short, long)
    step_edges(short, long)


def draw_triangle(given):
    global P, middle_below, gone_on
    P = sorted(given, key=lambda v: (v.x, v.y))
    a, b, c = P
    gone_on = None
    middle_below = (b.y - a.y) * (c.x - a.x) <= (c.y - a.y) * (b.x - a.x)
    in_order = a.x <= b.x <= c.x
    begin = ceil(a.x)
    end_first = ceil(b.x)
    begin_second = ceil(b.x)
    end = floor(c.x) + 1
    if in_order:
        begin_second = max(begin, begin_second)
        end_first = min(end_first, end)
    short = edge(FIRST, a, b, begin)
    long = edge(LONG, a, c, begin)
    for x in range(begin, end_first):
        walk(x, short, long)
    x = begin_second
    second = edge(SECOND, b, c, x)
    way = x - b.x
    pass  # the long edge goes on
    short = second
    for x in range(begin_second, end):
        walk(x, short, long)


def paint(span, sample, colour):
    x, y = (sample, onward * span) if by_rows else (span, sample)
    if 0 <= x < width and 0 <= y < height_of_frame:
        pixels[(height_of_frame - 1 - y) * width + x] = colour


def channels(text): return [int(text[i:i + 2], 16) for i in (1, 3, 5)]


for path in sys.argv[3:]:
    with open(path, encoding="utf-8") as file:
        scene = json.load(file)
    width, height_of_frame = scene["frame"]["width"], scene["frame"]["height"]
    pixels = [channels(scene["frame"]["background"])] * (width * height_of_frame)
    for primitive in scene["primitives"]:
        vertices = []
        for point, colour in zip(primitive["triangle"], primitive["colors"]):
            x, y = (Number(Fraction(str(coordinate))) for coordinate in point)
            x, y = (onward * y, x) if by_rows else (x, y)
            vertices.append(Vertex(x, y, [Number(c) for c in channels(colour)]))
        draw_triangle(vertices)
    with open(path + ".ppm", "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (width, height_of_frame))
        file.write(bytes(level for pixel in pixels for level in pixel))
