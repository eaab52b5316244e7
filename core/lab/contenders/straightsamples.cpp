// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/straightbox.h"
#include "core/scan/tests/edgetestform.h"

#include <algorithm>

/// Edge equations and barycentric coordinates: every sample of the box is tested, in floating
/// point.
namespace pixelplumb {

namespace {

template <class Float>
Float pixels(Lattice units)
{
    return Float(units) / Float(unitsPerPixel);
}

/// a·x + b·y + c through the two vertices that the line does not face.
template <class Float>
struct Line {
    Float a, b, c;
    Float atFacing; ///< its value at the vertex that faces it
    bool ownsTie = true;
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
    /// Call before the first sample.
    void decideTie(StraightRule rule)
    {
        ownsTie = atFacing > Float(0) ? straightOwnsTie(rule, a, b) : straightOwnsTie(rule, -a, -b);
    }
    /// Tests the line's value at a sample, or that value over the one at the vertex.
    template <StraightRule rule>
    bool accepts(Float value) const
    {
        return rule == StraightRule::Closed || ownsTie ? value >= Float(0) : value > Float(0);
    }
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

template <StraightRule rule, class Float>
bool areInside(const Line<Float> (&line)[3], Float v0, Float v1, Float v2)
{
    return line[0].template accepts<rule>(v0) && line[1].template accepts<rule>(v1)
        && line[2].template accepts<rule>(v2);
}

template <class Float, Evaluation evaluation, StraightRule rule>
void drawEdges(const Triangle &triangle, RawFrame frame)
{
    constexpr bool isIncremental = evaluation == Evaluation::Increments;
    Line<Float> line[3] = {{triangle, facedVertex(StraightLines::OfEdges, 0)},
                           {triangle, facedVertex(StraightLines::OfEdges, 1)},
                           {triangle, facedVertex(StraightLines::OfEdges, 2)}};
    for (Line<Float> &each : line) {
        if (each.atFacing < Float(0))
            each.flip();
        each.decideTie(rule);
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
            if (areInside<rule>(line, e[0], e[1], e[2])) {
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

template <class Float, StraightRule rule>
void drawRectangle(const Triangle &triangle, RawFrame frame)
{
    Line<Float> line[3] = {{triangle, 0}, {triangle, 1}, {triangle, 2}};
    for (Line<Float> &each : line)
        each.decideTie(rule);
    const StraightBox box = straightBoxOf(triangle);
    for (std::int64_t x = box.left; x <= box.right; ++x) {
        QRgb *pixel = frame.at(x, box.low);
        for (std::int64_t y = box.low; y <= box.high; ++y, pixel += frame.perV) {
            Float w[3];
            for (std::size_t i = 0; i < 3; ++i)
                w[i] = line[i].at(Float(x), Float(y)) / line[i].atFacing;
            const auto within = [&](std::size_t i) {
                return line[i].template accepts<rule>(w[i]) && w[i] <= Float(1);
            };
            if (within(0) && within(1) && within(2))
                *pixel = weighted(line, w[0], w[1], w[2]);
        }
    }
}

template <class Float, StraightRule rule>
void drawIncremental(const Triangle &triangle, RawFrame frame)
{
    Line<Float> line[3] = {{triangle, 0}, {triangle, 1}, {triangle, 2}};
    for (Line<Float> &each : line)
        each.decideTie(rule);
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
            if (areInside<rule>(line, v[0], v[1], v[2]))
                *pixel = qRgb(byteOf(v[3]), byteOf(v[4]), byteOf(v[5]));
            for (std::size_t i = 0; i < 6; ++i)
                v[i] = v[i] + perY[i];
        }
        for (std::size_t i = 0; i < 6; ++i)
            start[i] = start[i] + perX[i];
    }
}

/// Each line relative to its first end, where differences are exact.
template <class Float, StraightRule rule>
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
        line[i].decideTie(rule);
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
            if (areInside<rule>(line, w[0], w[1], w[2]))
                *pixel = weighted(line, w[0], w[1], w[2]);
        }
    }
}

using enum StraightRule;

constexpr StraightLoop rows[] = {
    {"edge-equations", Arithmetic::Float32, SpanAxis::Column,
     drawEdges<float, Evaluation::EverySample, Closed>,
     drawEdges<float, Evaluation::EverySample, HalfOpen>},
    {"edge-equations", Arithmetic::Float64, SpanAxis::Column,
     drawEdges<double, Evaluation::EverySample, Closed>,
     drawEdges<double, Evaluation::EverySample, HalfOpen>},
    {"edge-equations-incremental", Arithmetic::Float32, SpanAxis::Column,
     drawEdges<float, Evaluation::Increments, Closed>,
     drawEdges<float, Evaluation::Increments, HalfOpen>},
    {"edge-equations-incremental", Arithmetic::Float64, SpanAxis::Column,
     drawEdges<double, Evaluation::Increments, Closed>,
     drawEdges<double, Evaluation::Increments, HalfOpen>},
    {"barycentric-rectangle", Arithmetic::Float32, SpanAxis::Column, drawRectangle<float, Closed>,
     drawRectangle<float, HalfOpen>},
    {"barycentric-rectangle", Arithmetic::Float64, SpanAxis::Column, drawRectangle<double, Closed>,
     drawRectangle<double, HalfOpen>},
    {"barycentric-incremental", Arithmetic::Float32, SpanAxis::Column,
     drawIncremental<float, Closed>, drawIncremental<float, HalfOpen>},
    {"barycentric-incremental", Arithmetic::Float64, SpanAxis::Column,
     drawIncremental<double, Closed>, drawIncremental<double, HalfOpen>},
    {"barycentric-relative", Arithmetic::Float32, SpanAxis::Column, drawRelative<float, Closed>,
     drawRelative<float, HalfOpen>},
    {"barycentric-relative", Arithmetic::Float64, SpanAxis::Column, drawRelative<double, Closed>,
     drawRelative<double, HalfOpen>},
};

} // namespace

std::span<const StraightLoop> straightSamples() { return rows; }

} // namespace pixelplumb
