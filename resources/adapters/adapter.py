# SPDX-License-Identifier: GPL-3.0-or-later
# pixelplumb-cli try --input lines --scene SCENE -- python3 adapter.py
# Reads the scene, draws with drawTriangle of scanconverter.py, prints the picture (PPM).
import sys
from scanconverter import draw_triangle  # (frame, vertices): frame[y][x] = [r, g, b]; y grows upward

scene = [line.split() for line in sys.stdin]
width, height = next([int(n) for n in words[1:]] for words in scene if words[0] == "frame")
background = next([int(n) for n in words[1:]] for words in scene if words[0] == "background")
frame = [[background for x in range(width)] for y in range(height)]
for numbers in ([float(n) for n in words[1:]] for words in scene if words[0] == "triangle"):
    draw_triangle(frame, [numbers[0:5], numbers[5:10], numbers[10:15]])  # x y r g b each
print("P3", width, height, 255)
for row in reversed(frame):  # the top row first
    print(*(level for pixel in row for level in pixel))
