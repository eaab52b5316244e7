// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A correct column scan (rule closed), used to try the adapter.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

struct Pixel {
    int r = 0, g = 0, b = 0;
};
using Frame = std::vector<std::vector<Pixel>>;
struct Vertex {
    double x = 0, y = 0, r = 0, g = 0, b = 0;
};
using Values = std::array<double, 4>; // y, r, g, b

inline Values between(const Values &first, const Values &last, double t)
{
    Values values;
    for (int i = 0; i < 4; ++i)
        values[i] = first[i] + t * (last[i] - first[i]);
    return values;
}

inline Values meet(const Vertex &first, const Vertex &last, double x)
{
    return between({first.y, first.r, first.g, first.b}, {last.y, last.r, last.g, last.b},
                   last.x == first.x ? 0 : (x - first.x) / (last.x - first.x));
}

inline void drawTriangle(Frame &frame, Vertex a, Vertex b, Vertex c)
{
    std::array<Vertex, 3> v = {a, b, c};
    std::sort(v.begin(), v.end(), [](const Vertex &one, const Vertex &other) {
        return one.x != other.x ? one.x < other.x : one.y < other.y;
    });
    const int width = int(frame[0].size()), height = int(frame.size());
    for (int x = std::max(0, int(std::ceil(v[0].x))); x <= v[2].x && x < width; ++x) {
        Values low = meet(v[0], v[2], x);
        Values high = x < v[1].x ? meet(v[0], v[1], x) : meet(v[1], v[2], x);
        if (high[0] < low[0])
            std::swap(low, high);
        for (int y = std::max(0, int(std::ceil(low[0]))); y <= high[0] && y < height; ++y) {
            const Values at
                = between(low, high, high[0] == low[0] ? 0 : (y - low[0]) / (high[0] - low[0]));
            const auto byte = [](double level) { return int(std::floor(level + 0.5)); };
            frame[y][x] = {byte(at[1]), byte(at[2]), byte(at[3])};
        }
    }
}
