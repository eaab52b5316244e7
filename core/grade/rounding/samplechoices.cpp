// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/rounding/samplechoices.h"

#include "core/frame/framebuffer.h"
#include "core/grade/rounding/trianglemargin.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace pixelplumb {

namespace {

using Direction = LatticePoint;
using Set = std::vector<std::size_t>;

Int128 cross(const Direction &a, const Direction &b) { return doubledArea(Direction(), a, b); }

Int128 dot(const Direction &a, const Direction &b) { return Int128(a.x) * b.x + Int128(a.y) * b.y; }

bool areAlike(const Direction &a, const Direction &b) { return cross(a, b) == 0 && dot(a, b) > 0; }

/// Orders by the angle from the x axis, 0 to 360 degrees.
bool isBefore(const Direction &a, const Direction &b)
{
    const auto isLower
        = [](const Direction &each) { return each.y < 0 || (each.y == 0 && each.x < 0); };
    return isLower(a) != isLower(b) ? isLower(b) : cross(a, b) > 0;
}

/// The directions in which a triangle lies, seen from a sample on its edge: from one to the other,
/// counter-clockwise.
struct Sector {
    std::size_t triangle = 0;
    Direction from, to;
    bool isAtVertex = false;

    bool contains(const Direction &direction) const
    {
        const bool isHalf = cross(from, to) == 0;
        return cross(from, direction) > 0 && (isHalf || cross(direction, to) > 0);
    }
    bool isBeside(const Sector &other) const
    {
        return areAlike(from, other.to) || areAlike(to, other.from);
    }
};

/// None where the sample does not lie on an edge of the triangle, or that has no area.
std::optional<Sector> sectorOf(const Triangle &triangle, std::size_t index, const LatticePoint &at)
{
    std::array<LatticePoint, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = triangle.vertices[i].position;
    const Int128 area = doubledArea(triangle);
    if (area == 0)
        return std::nullopt;
    if (area < 0)
        std::swap(corners[1], corners[2]);
    const auto towards = [&](std::size_t i) {
        const LatticePoint &corner = corners[i % 3];
        return Direction{corner.x - at.x, corner.y - at.y};
    };
    for (std::size_t i = 0; i < 3; ++i) {
        if (corners[i] == at)
            return Sector{index, towards(i + 1), towards(i + 2), true};
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const bool isBetween
            = cross(towards(i), towards(i + 1)) == 0 && dot(towards(i), towards(i + 1)) < 0;
        if (isBetween)
            return Sector{index, towards(i + 1), towards(i), false};
    }
    return std::nullopt;
}

/// One direction between each two neighbouring bounds of the sectors.
std::vector<Direction> directionsBetween(const std::vector<Sector> &sectors)
{
    std::vector<Direction> bounds;
    for (const Sector &sector : sectors)
        bounds.insert(bounds.end(), {sector.from, sector.to});
    std::ranges::sort(bounds, isBefore);
    bounds.erase(std::unique(bounds.begin(), bounds.end(), areAlike), bounds.end());
    std::vector<Direction> between;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const Direction &from = bounds[i];
        const Direction &to = bounds[(i + 1) % bounds.size()];
        const Int128 turn = cross(from, to);
        const Direction middle{from.x + to.x, from.y + to.y};
        between.push_back(turn > 0       ? middle
                              : turn < 0 ? Direction{-middle.x, -middle.y}
                                         : Direction{-from.y, from.x});
    }
    return between;
}

Set drawnTowards(const Direction &direction, const std::vector<Sector> &sectors)
{
    Set drawn;
    for (const Sector &sector : sectors) {
        if (sector.contains(direction))
            drawn.push_back(sector.triangle);
    }
    return drawn;
}

/// The sectors by groups that lie side by side.
std::vector<std::vector<Sector>> groupsOf(const std::vector<Sector> &sectors)
{
    std::vector<std::vector<Sector>> groups;
    for (const Sector &sector : sectors) {
        std::vector<Sector> group = {sector};
        for (std::vector<Sector> &other : groups) {
            const auto isBeside = [&](const Sector &each) { return each.isBeside(sector); };
            if (std::ranges::any_of(other, isBeside)) {
                group.insert(group.end(), other.begin(), other.end());
                other.clear();
            }
        }
        std::erase_if(groups, [](const auto &other) { return other.empty(); });
        groups.push_back(std::move(group));
    }
    return groups;
}

/// What may be drawn of triangles that depend on each other.
using Alternatives = std::set<Set>;

std::set<Set> combined(const std::vector<Alternatives> &parts, const Set &drawn)
{
    constexpr std::size_t most = 4096;
    std::set<Set> all = {drawn};
    for (const Alternatives &part : parts) {
        std::set<Set> longer;
        for (const Set &one : all) {
            for (const Set &other : part) {
                if (longer.size() == most)
                    break;
                Set both = one;
                both.insert(both.end(), other.begin(), other.end());
                std::ranges::sort(both);
                longer.insert(std::move(both));
            }
        }
        all = std::move(longer);
    }
    return all;
}

std::size_t placeOf(const FrameSpec &frame, std::int64_t x, std::int64_t y)
{
    return std::size_t(pictureLine(frame, y)) * std::size_t(frame.width)
        + std::size_t(x - frame.firstColumn);
}

} // namespace

std::size_t SampleChoice::placeIn(const FrameSpec &frame) const { return placeOf(frame, m_x, m_y); }

std::vector<std::vector<std::size_t>> SampleChoice::sets(Leeway leeway) const
{
    std::vector<Sector> sectors;
    std::vector<Alternatives> parts;
    for (const std::size_t open : m_open) {
        const auto sector = sectorOf((*m_triangles)[open], open, latticePixel(m_x, m_y));
        if (sector && leeway == Leeway::Once)
            sectors.push_back(*sector);
        else
            parts.push_back({{}, {open}});
    }
    for (const std::vector<Sector> &group : groupsOf(sectors)) {
        Alternatives part;
        if (group.size() == 1)
            part = {{}, {group.front().triangle}};
        for (const Direction &direction : directionsBetween(group))
            part.insert(drawnTowards(direction, group));
        parts.push_back(std::move(part));
    }
    const std::set<Set> all = combined(parts, m_drawn);
    return {all.begin(), all.end()};
}

bool SampleChoice::isSurrounded() const
{
    std::vector<Sector> sectors;
    for (const std::size_t open : m_open) {
        if (const auto sector = sectorOf((*m_triangles)[open], open, latticePixel(m_x, m_y)))
            sectors.push_back(*sector);
    }
    return !sectors.empty()
        && std::ranges::none_of(directionsBetween(sectors), [&](const Direction &direction) {
               return drawnTowards(direction, sectors).empty();
           });
}

bool SampleChoice::isVertex() const
{
    return std::ranges::any_of(m_open, [this](std::size_t open) {
        return std::ranges::any_of((*m_triangles)[open].vertices, [this](const Vertex &vertex) {
            return vertex.position == latticePixel(m_x, m_y);
        });
    });
}

std::vector<SampleChoice> sampleChoicesOf(const std::vector<Triangle> &triangles,
                                          const Scene &scene, const Margin &margin,
                                          const std::vector<std::uint8_t> &wanted)
{
    const FrameSpec &frame = scene.frame;
    std::map<std::size_t, SampleChoice> choices;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const TriangleMargin own(triangles[i], scene, margin);
        const SampleBox box = own.reachIn(frame);
        for (std::int64_t y = box.firstY; y < box.endY; ++y) {
            for (std::int64_t x = box.firstX; x < box.endX; ++x) {
                const std::size_t place = placeOf(frame, x, y);
                const Containment where
                    = wanted[place] != 0 ? own.containmentOf(x, y) : Containment::Outside;
                if (where == Containment::Outside)
                    continue;
                SampleChoice &choice = choices.try_emplace(place, triangles, x, y).first->second;
                where == Containment::Inside ? choice.addDrawn(i) : choice.addOpen(i);
            }
        }
    }
    std::vector<SampleChoice> found;
    for (auto &[place, choice] : choices)
        found.push_back(std::move(choice));
    return found;
}

std::vector<std::uint8_t> holesAmong(const std::vector<std::uint8_t> &bare, const Scene &scene,
                                     const Margin &margin)
{
    std::vector<std::uint8_t> holes(bare.size(), 0);
    if (margin.leeway == Leeway::Edges || std::ranges::count(bare, 1) == 0)
        return holes;
    const std::vector<Triangle> triangles = primitivesOnSamples(scene).triangles;
    const Margin onEdges{Leeway::Edges, margin.tolerance};
    for (const SampleChoice &choice : sampleChoicesOf(triangles, scene, onEdges, bare)) {
        const auto isDrawnByFunctions = [&](std::size_t triangle) {
            return TriangleMargin(triangles[triangle], scene, margin)
                .isDrawnByFunctions(choice.x(), choice.y());
        };
        const bool isHole = choice.isSurrounded()
            && (margin.leeway == Leeway::Once
                || (!choice.isVertex() && std::ranges::any_of(choice.open(), isDrawnByFunctions)));
        holes[choice.placeIn(scene.frame)] = isHole ? 1 : 0;
    }
    return holes;
}

} // namespace pixelplumb
