// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/rounding/trianglemargin.h"

#include "core/frame/framebuffer.h"
#include "core/oracle/oracle.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

LevelRange levelsOf(const Triangle &triangle, std::size_t channel)
{
    const auto level = [&](std::size_t vertex) {
        return double(triangle.vertices[vertex].colour.channels[channel]);
    };
    const auto [least, most] = std::minmax({level(0), level(1), level(2)});
    return {least, most};
}

} // namespace

bool ColourRange::contains(const Colour &colour) const
{
    for (std::size_t channel = 0; channel < 3; ++channel) {
        if (colour.channels[channel] < least.channels[channel]
            || colour.channels[channel] > most.channels[channel])
            return false;
    }
    return true;
}

TriangleMargin::TriangleMargin(const Triangle &triangle, const Scene &scene, const Margin &margin)
    : m_triangle(triangle)
    , m_rounding(scene.settings.rounding)
    , m_hasArea(doubledArea(triangle) != 0)
{
    if (margin.isStrict() || margin.leeway == Leeway::Rule)
        m_rule = BoundaryRule(scene.settings, windowOf(scene.frame));
    if (margin.isStrict() || margin.tolerance == Arithmetic::Exact)
        return;
    const ArithmeticBound bound(triangle, margin.tolerance);
    if (std::isfinite(bound.endError(SpanAxis::Column)))
        m_bound = bound;
    else
        m_rule.reset();
}

SampleBox TriangleMargin::reachIn(const FrameSpec &frame) const
{
    return m_bound ? m_bound->reachIn(frame)
                   : intersection(boundingBoxOf(m_triangle), samplesOf(windowOf(frame)));
}

Containment TriangleMargin::containmentOf(std::int64_t x, std::int64_t y, ProgramWays ways) const
{
    if (m_bound && m_hasArea)
        return m_bound->containmentOf(x, y, m_rule, ways);
    if (m_bound)
        return mayBeOfSegment(x, y) ? Containment::Undecided : Containment::Outside;
    if (m_rule)
        return oracle::covers(m_triangle, *m_rule, x, y) ? Containment::Inside
                                                         : Containment::Outside;
    if (!oracle::covers(m_triangle, FillRule::Closed, x, y))
        return Containment::Outside;
    return oracle::covers(m_triangle, FillRule::Open, x, y) ? Containment::Inside
                                                            : Containment::Undecided;
}

bool TriangleMargin::isDrawnByFunctions(std::int64_t x, std::int64_t y) const
{
    return m_bound && m_hasArea
        && m_bound->containmentByFunctions(x, y, m_rule) == Containment::Inside;
}

ColourRange TriangleMargin::coloursAt(std::int64_t x, std::int64_t y) const
{
    if (!m_bound && m_hasArea) {
        const Colour exact = oracle::byteColourAt(m_triangle, x, y, m_rounding);
        return {exact, exact};
    }
    ColourRange range{{{0, 0, 0}}, {{255, 255, 255}}};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto levels = m_bound ? m_bound->levelsAt(x, y, channel)
                                    : std::optional(levelsOf(m_triangle, channel));
        if (!levels)
            continue;
        const auto [least, most] = levels->bytes(m_rounding);
        range.least.channels[channel] = std::uint8_t(least);
        range.most.channels[channel] = std::uint8_t(most);
    }
    return range;
}

/// A walk may draw samples on the triangle's segment, or closer to it than its error.
bool TriangleMargin::mayBeOfSegment(std::int64_t x, std::int64_t y) const
{
    const auto order = sortedByColumn(m_triangle);
    const auto pixels = [](Lattice coordinate) { return double(coordinate) / unitsPerPixel; };
    const LatticePoint &from = m_triangle.vertices[std::size_t(order[0])].position;
    const LatticePoint &to = m_triangle.vertices[std::size_t(order[2])].position;
    const double dx = pixels(to.x - from.x);
    const double dy = pixels(to.y - from.y);
    const double atX = double(x) - pixels(from.x);
    const double atY = double(y) - pixels(from.y);
    const double upward = m_bound->endError(SpanAxis::Column);
    const double along = m_bound->endError(SpanAxis::Row);
    const bool isBeside = atX < std::min(dx, 0.0) - along || atX > std::max(dx, 0.0) + along
        || atY < std::min(dy, 0.0) - upward || atY > std::max(dy, 0.0) + upward;
    const double cross = std::abs(dx * atY - dy * atX);
    return !isBeside && (cross <= upward * std::abs(dx) || cross <= along * std::abs(dy));
}

} // namespace pixelplumb
