// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/sampleview.h"

#include "core/frame/framebuffer.h"

#include <algorithm>
#include <numeric>

namespace pixelplumb {

bool SampleView::hasRuns() const
{
    for (int line = 0; line < side; ++line) {
        int columnStarts = 0;
        int rowStarts = 0;
        for (int place = 0; place < side; ++place) {
            columnStarts += covers(line, place) && !covers(line, place - 1) ? 1 : 0;
            rowStarts += covers(place, line) && !covers(place - 1, line) ? 1 : 0;
        }
        if (columnStarts > 1 || rowStarts > 1)
            return false;
    }
    return true;
}

bool SampleView::isWithinBoxOf(const Triangle &triangle) const
{
    const auto &[a, b, c] = triangle.vertices;
    const auto [left, right] = std::minmax({a.position.x, b.position.x, c.position.x});
    const auto [bottom, top] = std::minmax({a.position.y, b.position.y, c.position.y});
    return holdsEverywhere(
        [&, left = left, right = right, bottom = bottom, top = top](int x, int y) {
            const LatticePoint sample = latticePixel(x, y);
            return !covers(x, y)
                || (sample.x >= left && sample.x <= right && sample.y >= bottom && sample.y <= top);
        });
}

bool SampleView::isWithinLevelsOf(const Triangle &triangle) const
{
    const std::array<Vertex, 3> &vertices = triangle.vertices;
    return !m_picture.hasColours || holdsEverywhere([&](int x, int y) {
        for (std::size_t i = 0; i < 3 && covers(x, y); ++i) {
            const auto [least, most]
                = std::minmax({vertices[0].colour.channels[i], vertices[1].colour.channels[i],
                               vertices[2].colour.channels[i]});
            const std::uint8_t level = colourAt(x, y).channels[i];
            if (level < least || level > most)
                return false;
        }
        return true;
    });
}

bool SampleView::hasCornersOf(const Triangle &triangle) const
{
    return std::ranges::all_of(triangle.vertices, [&](const Vertex &vertex) {
        const int x = int(floorPixel(vertex.position.x));
        const int y = int(floorPixel(vertex.position.y));
        return latticePixel(x, y) != vertex.position || !covers(x, y)
            || hasColourAt(x, y, vertex.colour);
    });
}

bool SampleView::hasCountOf(const Triangle &triangle, FillRule rule) const
{
    std::int64_t boundary = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const LatticePoint &from = triangle.vertices[i].position;
        const LatticePoint &to = triangle.vertices[(i + 1) % 3].position;
        if (from.x % unitsPerPixel != 0 || from.y % unitsPerPixel != 0)
            return true;
        boundary += std::gcd(to.x - from.x, to.y - from.y) / unitsPerPixel;
    }
    const Int128 area = doubledArea(triangle);
    const auto doubled = std::int64_t((area < 0 ? -area : area) / (unitsPerPixel * unitsPerPixel));
    const std::int64_t inside = (doubled - boundary) / 2 + 1;
    std::int64_t drawn = 0;
    holdsEverywhere([&](int x, int y) {
        drawn += covers(x, y) ? 1 : 0;
        return true;
    });
    if (rule == FillRule::Closed)
        return drawn == inside + boundary;
    if (rule == FillRule::Open)
        return drawn == inside;
    return drawn > inside - 1 && drawn < inside + boundary;
}

} // namespace pixelplumb
