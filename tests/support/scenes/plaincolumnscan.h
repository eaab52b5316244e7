// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

/// The assignment (Borst) and nothing else: floats and increments, for vertices on whole pixels and
/// a frame that holds them all. Start here to learn how a triangle is scanned; a test compares the
/// column scan in float32 with its picture.
namespace pixelplumb::plain {

using Values = std::array<float, 4>; ///< y, R, G, B: all are stepped along an edge

struct Vertex {
    float x = 0; ///< whole pixels
    Values values = {};
};

/// The increment of each of `steps` steps from one value to the other.
inline Values increments(const Values &from, const Values &to, float steps)
{
    if (steps == 0)
        return {};
    Values each;
    for (std::size_t i = 0; i < 4; ++i)
        each[i] = (to[i] - from[i]) / steps;
    return each;
}

inline void add(Values &values, const Values &each)
{
    for (std::size_t i = 0; i < 4; ++i)
        values[i] += each[i];
}

inline int byteOf(float level) { return std::clamp(int(std::floor(level + 0.5f)), 0, 255); }

/// The pixels ⌈y_B⌉ … ⌊y_T⌋ of column x between two edges.
inline void drawColumn(int x, const Values &one, const Values &other, FrameView frame)
{
    const auto &[bottom, top]
        = std::minmax(one, other, [](auto &a, auto &b) { return a[0] < b[0]; });
    const Values each = increments(bottom, top, top[0] - bottom[0]);
    const float first = std::ceil(bottom[0]);
    Values pixel;
    for (std::size_t i = 0; i < 4; ++i)
        pixel[i] = bottom[i] + (first - bottom[0]) * each[i];
    for (int y = int(first); y <= int(std::floor(top[0])); ++y) {
        *frame.at(x, y) = qRgb(byteOf(pixel[1]), byteOf(pixel[2]), byteOf(pixel[3]));
        add(pixel, each);
    }
}

/// All columns from x₀ to x₂; the frame holds the whole triangle.
inline void drawTriangle(std::array<Vertex, 3> v, FrameView frame)
{
    std::sort(v.begin(), v.end(), [](const Vertex &a, const Vertex &b) {
        return std::pair(a.x, a.values[0]) < std::pair(b.x, b.values[0]); // by x, then by y
    });
    Values longEdge = v[0].values; // L₀₂
    const Values longStep = increments(v[0].values, v[2].values, v[2].x - v[0].x);
    for (std::size_t half = 0; half < 2; ++half) { // L₀₁ up to x₁ − 1, then L₁₂ from x₁ to x₂
        Values shortEdge = v[half].values;
        const Values shortStep
            = increments(v[half].values, v[half + 1].values, v[half + 1].x - v[half].x);
        const int end = int(v[half + 1].x) + int(half);
        for (int x = int(v[half].x); x < end; ++x) {
            drawColumn(x, shortEdge, longEdge, frame);
            add(shortEdge, shortStep);
            add(longEdge, longStep);
        }
    }
}

} // namespace pixelplumb::plain
