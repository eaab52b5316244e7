// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shade/strokes/strokepixels.h"

#include <algorithm>
#include <limits>

namespace pixelplumb {

namespace {

/// The pixels, along one axis, whose squares lie at least partly between two coordinates.
struct PixelRun {
    PixelRun(StrokeUnit low, StrokeUnit high, std::int64_t first, std::int64_t end)
        : first(
            std::max(floorDivide<StrokeUnit>(low + strokeHalfPixel, strokeUnitsPerPixel), first))
        , end(std::min(ceilDivide<StrokeUnit>(high + strokeHalfPixel, strokeUnitsPerPixel), end))
    {
    }

    std::int64_t first, end;
};

/// The vertical extent of a quadrilateral between two vertical lines, rounded outward to units.
struct Reach {
    StrokeUnit low = std::numeric_limits<StrokeUnit>::max();
    StrokeUnit high = std::numeric_limits<StrokeUnit>::min();

    void addEdge(StrokePoint a, StrokePoint b, StrokeUnit left, StrokeUnit right)
    {
        if (b.x < a.x)
            std::swap(a, b);
        if (b.x < left || a.x > right)
            return;
        if (a.x == b.x) {
            add(std::min(a.y, b.y), std::max(a.y, b.y));
            return;
        }
        const Int128 width = b.x - a.x;
        for (const StrokeUnit x : {std::max(a.x, left), std::min(b.x, right)}) {
            const Int128 y = a.y * width + Int128(x - a.x) * (b.y - a.y);
            add(StrokeUnit(floorDivide<Int128>(y, width)),
                StrokeUnit(ceilDivide<Int128>(y, width)));
        }
    }

private:
    void add(StrokeUnit from, StrokeUnit to)
    {
        low = std::min(low, from);
        high = std::max(high, to);
    }
};

} // namespace

std::vector<StrokePixel> strokePixels(std::span<const StrokeQuad> quads, const FrameView &frame)
{
    std::vector<StrokePixel> pixels;
    for (std::size_t index = 0; index < quads.size(); ++index) {
        const StrokeQuad &quad = quads[index];
        const auto [low, high] = std::ranges::minmax_element(quad, {}, &StrokePoint::x);
        const PixelRun columns(low->x, high->x, frame.firstColumn, frame.endColumn());
        for (std::int64_t x = columns.first; x < columns.end; ++x) {
            const StrokeUnit left = x * strokeUnitsPerPixel - strokeHalfPixel;
            Reach reach;
            for (std::size_t i = 0; i < quad.size(); ++i)
                reach.addEdge(quad[i], quad[(i + 1) % quad.size()], left,
                              left + strokeUnitsPerPixel);
            const PixelRun rows(reach.low, reach.high, frame.firstRow, frame.endRow());
            for (std::int64_t y = rows.first; y < rows.end; ++y)
                pixels.push_back({std::int32_t(x), std::int32_t(y), std::uint32_t(index)});
        }
    }
    std::ranges::sort(pixels);
    return pixels;
}

} // namespace pixelplumb
