// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/straightbox.h"
#include "core/lab/straightloop.h"

#include <algorithm>

/// Edge equations and barycentric coordinates: every sample of the box is tested, in
/// floating point.
namespace pixelplumb {

namespace {

template <class Float>
Float pixels(Lattice units)
{
    return Float(units) / Float(unitsPerPixel);
}

/// a·x + b·y + c through the two vertices that do not face it.
template <class Float>
struct Line {
    Float a, b, c;
    Float atFacing; ///< its value at the vertex that faces it
    Float level[3]; ///< R G B of that vertex

    Line(const Triangle &triangle, std::size_t vertex)
    {
        const Vertex &p = triangle.vertices[(vertex + 1) % 3];
        const Vertex &q = triangle.vertices[(vertex + 2) % 3];
        const Vertex &r = triangle.vertices[vertex];
        const Float x0 = pixels<Float>(p.position.x), y0 = pixels<Float>(p.position.y);
        const Float x1 = pixels<Float>(q.position.x), y1 = pixels<Float>(q.position.y);
        a = y1 - y0;
        b = x0 - x1;
        c = x1 * y0 - x0 * y1;
        atFacing = at(pixels<Float>(r.position.x), pixels<Float>(r.position.y));
        for (std::size_t i = 0; i < 3; ++i)
            level[i] = Float(int(r.colour.channels[i]));
    }

    Float at(Float x, Float y) const { return a * x + b * y + c; }
    void flip()
    {
        a = Float(0) - a;
        b = Float(0) - b;
        c = Float(0) - c;
        atFacing = Float(0) - atFacing;
    }
};

template <class Float>
QRgb weighted(const Line<Float> (&line)[3], Float w0, Float w1, Float w2)
{
    int byte[3];
    for (std::size_t i = 0; i < 3; ++i)
        byte[i] = byteOf(w0 * line[0].level[i] + w1 * line[1].level[i] + w2 * line[2].level[i]);
    return qRgb(byte[0], byte[1], byte[2]);
}

template <class Float, bool isIncremental>
void drawEdges(const Triangle &triangle, RawFrame frame)
{
    Line<Float> line[3] = {{triangle, facedVertex(false, 0)},
                           {triangle, facedVertex(false, 1)},
                           {triangle, facedVertex(false, 2)}};
    for (Line<Float> &each : line) {
        if (each.atFacing < Float(0))
            each.flip();
    }
    const StraightBox box = straightBoxOf(triangle);
    const auto left = Float(box.left), low = Float(box.low);
    Float start[3] = {line[0].at(left, low), line[1].at(left, low), line[2].at(left, low)};
    for (std::int64_t y = box.low; y <= box.high; ++y) {
        QRgb *pixel = frame.at(box.left, y);
        Float e[3] = {start[0], start[1], start[2]};
        for (std::int64_t x = box.left; x <= box.right; ++x, pixel += frame.perU) {
            if constexpr (!isIncremental) {
                for (std::size_t i = 0; i < 3; ++i)
                    e[i] = line[i].at(Float(x), Float(y));
            }
            if (e[0] >= Float(0) && e[1] >= Float(0) && e[2] >= Float(0)) {
                *pixel = weighted(line, e[0] / line[0].atFacing, e[1] / line[1].atFacing,
                                  e[2] / line[2].atFacing);
            }
            if constexpr (isIncremental) {
                for (std::size_t i = 0; i < 3; ++i)
                    e[i] = e[i] + line[i].a;
            }
        }
        for (std::size_t i = 0; i < 3; ++i)
            start[i] = start[i] + line[i].b;
    }
}

template <class Float>
void drawRectangle(const Triangle &triangle, RawFrame frame)
{
    const Line<Float> line[3] = {{triangle, 0}, {triangle, 1}, {triangle, 2}};
    const StraightBox box = straightBoxOf(triangle);
    for (std::int64_t x = box.left; x <= box.right; ++x) {
        QRgb *pixel = frame.at(x, box.low);
        for (std::int64_t y = box.low; y <= box.high; ++y, pixel += frame.perV) {
            Float w[3];
            for (std::size_t i = 0; i < 3; ++i)
                w[i] = line[i].at(Float(x), Float(y)) / line[i].atFacing;
            const auto within
                = [](Float weight) { return weight >= Float(0) && weight <= Float(1); };
            if (within(w[0]) && within(w[1]) && within(w[2]))
                *pixel = weighted(line, w[0], w[1], w[2]);
        }
    }
}

template <class Float>
void drawIncremental(const Triangle &triangle, RawFrame frame)
{
    const Line<Float> line[3] = {{triangle, 0}, {triangle, 1}, {triangle, 2}};
    const StraightBox box = straightBoxOf(triangle);
    // Three weights, then three levels.
    Float perX[6], perY[6], start[6];
    for (std::size_t i = 0; i < 3; ++i) {
        perX[i] = line[i].a / line[i].atFacing;
        perY[i] = line[i].b / line[i].atFacing;
        start[i] = line[i].at(Float(box.left), Float(box.low)) / line[i].atFacing;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const auto level = [&](const Float(&w)[6]) {
            return w[0] * line[0].level[i] + w[1] * line[1].level[i] + w[2] * line[2].level[i];
        };
        perX[3 + i] = level(perX);
        perY[3 + i] = level(perY);
        start[3 + i] = level(start);
    }
    for (std::int64_t x = box.left; x <= box.right; ++x) {
        Float v[6];
        std::copy_n(start, 6, v);
        QRgb *pixel = frame.at(x, box.low);
        for (std::int64_t y = box.low; y <= box.high; ++y, pixel += frame.perV) {
            if (v[0] >= Float(0) && v[1] >= Float(0) && v[2] >= Float(0))
                *pixel = qRgb(byteOf(v[3]), byteOf(v[4]), byteOf(v[5]));
            for (std::size_t i = 0; i < 6; ++i)
                v[i] = v[i] + perY[i];
        }
        for (std::size_t i = 0; i < 6; ++i)
            start[i] = start[i] + perX[i];
    }
}

/// Each line from its first end, where the differences are exact.
template <class Float>
void drawRelative(const Triangle &triangle, RawFrame frame)
{
    Line<Float> line[3] = {{triangle, 0}, {triangle, 1}, {triangle, 2}};
    LatticePoint from[3];
    for (std::size_t i = 0; i < 3; ++i) {
        from[i] = triangle.vertices[(i + 1) % 3].position;
        const LatticePoint &to = triangle.vertices[(i + 2) % 3].position;
        const LatticePoint &facing = triangle.vertices[i].position;
        line[i].a = pixels<Float>(to.y - from[i].y);
        line[i].b = pixels<Float>(from[i].x - to.x);
        line[i].atFacing = line[i].a * pixels<Float>(facing.x - from[i].x)
            + line[i].b * pixels<Float>(facing.y - from[i].y);
    }
    const StraightBox box = straightBoxOf(triangle);
    for (std::int64_t x = box.left; x <= box.right; ++x) {
        QRgb *pixel = frame.at(x, box.low);
        for (std::int64_t y = box.low; y <= box.high; ++y, pixel += frame.perV) {
            Float w[3];
            for (std::size_t i = 0; i < 3; ++i) {
                w[i] = (line[i].a * pixels<Float>(x * unitsPerPixel - from[i].x)
                        + line[i].b * pixels<Float>(y * unitsPerPixel - from[i].y))
                    / line[i].atFacing;
            }
            if (w[0] >= Float(0) && w[1] >= Float(0) && w[2] >= Float(0))
                *pixel = weighted(line, w[0], w[1], w[2]);
        }
    }
}

constexpr StraightLoop rows[] = {
    {"edge-equations", Arithmetic::Float32, false, drawEdges<float, false>},
    {"edge-equations", Arithmetic::Float64, false, drawEdges<double, false>},
    {"edge-equations-incremental", Arithmetic::Float32, false, drawEdges<float, true>},
    {"edge-equations-incremental", Arithmetic::Float64, false, drawEdges<double, true>},
    {"barycentric-rectangle", Arithmetic::Float32, false, drawRectangle<float>},
    {"barycentric-rectangle", Arithmetic::Float64, false, drawRectangle<double>},
    {"barycentric-incremental", Arithmetic::Float32, false, drawIncremental<float>},
    {"barycentric-incremental", Arithmetic::Float64, false, drawIncremental<double>},
    {"barycentric-relative", Arithmetic::Float32, false, drawRelative<float>},
    {"barycentric-relative", Arithmetic::Float64, false, drawRelative<double>},
};

} // namespace

std::span<const StraightLoop> straightSamples() { return rows; }

} // namespace pixelplumb
