// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/overdraw.h"

#include "core/compare/exactbounds.h"
#include "core/frame/writtenframe.h"
#include "core/oracle/oracle.h"

#include <algorithm>
#include <limits>

namespace pixelplumb {

namespace {

/// Half a turn around the origin: a rule's displacement to the right and up becomes one to the left
/// and down in the original triangle.
Triangle turnedAround(Triangle triangle)
{
    for (Vertex &vertex : triangle.vertices) {
        vertex.position.x = -vertex.position.x;
        vertex.position.y = -vertex.position.y;
    }
    return triangle;
}

void countWrites(OverdrawMap &map, const ScanTrace &trace)
{
    // A primitive that visits a pixel twice counts as one write.
    FrameMap<std::size_t> lastWriter(map.spec(), std::numeric_limits<std::size_t>::max());
    std::size_t span = 0;
    for (std::size_t sample = 0; sample < trace.sampleCount(); ++sample) {
        while (sample >= trace.endSampleOf(span))
            ++span;
        const PixelChange &change = trace.changes()[sample];
        if (!change.isWritten())
            continue;
        std::size_t &writer = lastWriter.at(change.x, change.y);
        if (writer != trace.primitiveOf(span))
            map.addWrite(change.x, change.y);
        writer = trace.primitiveOf(span);
    }
}

} // namespace

void OverdrawMap::addWrite(std::int64_t x, std::int64_t y)
{
    std::uint16_t &writes = m_pixels.at(x, y).writes;
    if (writes == std::numeric_limits<std::uint16_t>::max())
        return;
    ++writes;
    m_written += writes == 1 ? 1 : 0;
    m_overdrawn += writes == 2 ? 1 : 0;
    m_mostWrites = std::max(m_mostWrites, int(writes));
}

void OverdrawMap::setGap(std::int64_t x, std::int64_t y)
{
    bool &isGap = m_pixels.at(x, y).isGap;
    m_gaps += isGap ? 0 : 1;
    isGap = true;
}

bool isSurrounded(const std::vector<Triangle> &triangles, std::int64_t x, std::int64_t y)
{
    std::array<bool, 4> stays = {};
    for (const Triangle &triangle : triangles) {
        if (!isInBox(triangle, x, y) || !oracle::covers(triangle, FillRule::Closed, x, y))
            continue;
        const Triangle turned = turnedAround(triangle);
        stays[0] |= oracle::covers(triangle, FillRule::HalfOpenColumn, x, y);
        stays[1] |= oracle::covers(triangle, FillRule::TopLeft, x, y);
        stays[2] |= oracle::covers(turned, FillRule::HalfOpenColumn, -x, -y);
        stays[3] |= oracle::covers(turned, FillRule::TopLeft, -x, -y);
    }
    return std::ranges::all_of(stays, std::identity{});
}

OverdrawMap overdrawOf(const TracedScene &traced)
{
    OverdrawMap map(traced.scene.frame);
    const ScanTrace &trace = *traced.trace;
    countWrites(map, trace);
    if (trace.isCut() || !traced.method->draws(PrimitiveKind::Triangle))
        return map;

    const std::vector<Triangle> &triangles = traced.primitives.triangles;
    const ScanSettings &settings = trace.settings();
    const WrittenFrame owned(traced.scene.frame);
    const WrittenFrame touched(traced.scene.frame);
    for (const Triangle &triangle : triangles) {
        oracle::draw(triangle, boundaryRuleOf(traced.scene), settings.rounding, owned.view());
        oracle::draw(triangle, FillRule::Closed, settings.rounding, touched.view());
    }
    const FrameView window = owned.view();
    for (std::int64_t y = window.firstRow; y < window.endRow(); ++y) {
        for (std::int64_t x = window.firstColumn; x < window.endColumn(); ++x) {
            if (map.writesAt(x, y) > 0 || !touched.isWritten(x, y))
                continue;
            if (owned.isWritten(x, y) || isSurrounded(triangles, x, y))
                map.setGap(x, y);
        }
    }
    return map;
}

} // namespace pixelplumb
