// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/sharedsamples.h"

#include "core/frame/framebuffer.h"
#include "core/oracle/oracle.h"
#include "core/runs/scenerun.h"
#include "core/scan/edgeteststate.h"

#include <algorithm>
#include <map>

namespace pixelplumb {

namespace {

/// How many triangles have an edge, on its left and on its right.
class EdgeOwners {
public:
    explicit EdgeOwners(const std::vector<Triangle> &triangles)
    {
        for (const Triangle &triangle : triangles) {
            const Int128 area = doubledArea(triangle);
            for (std::size_t i = 0; i < 3 && area != 0; ++i) {
                const auto &[from, to] = endsOf(triangle, i, (i + 1) % 3);
                const bool isForward
                    = triangle.vertices[i].position == from; // else it runs the other way
                ++(isForward == (area > 0) ? m_sides[{from, to}].first
                                           : m_sides[{from, to}].second);
            }
        }
    }
    bool isShared(const Triangle &triangle, int from, int to) const
    {
        const auto found = m_sides.find(endsOf(triangle, std::size_t(from), std::size_t(to)));
        return found != m_sides.end() && found->second == std::pair(1, 1);
    }

private:
    using Ends = std::pair<LatticePoint, LatticePoint>;

    static Ends endsOf(const Triangle &triangle, std::size_t from, std::size_t to)
    {
        const auto &[least, most]
            = std::minmax(triangle.vertices[from].position, triangle.vertices[to].position);
        return {least, most};
    }

    std::map<Ends, std::pair<int, int>> m_sides;
};

} // namespace

std::vector<std::uint8_t> sharedSamples(const Scene &scene)
{
    enum class Place : std::uint8_t { OnNoEdge, Shared, OnAnother };
    const FrameSpec &frame = scene.frame;
    std::vector<Place> places(std::size_t(frame.width) * std::size_t(frame.height),
                              Place::OnNoEdge);
    const std::vector<Triangle> triangles = primitivesOnSamples(scene).triangles;
    const EdgeOwners owners(triangles);
    for (const Triangle &triangle : triangles) {
        const SampleBox box = intersection(boundingBoxOf(triangle), samplesOf(windowOf(frame)));
        for (std::int64_t y = box.firstY; y < box.endY && doubledArea(triangle) != 0; ++y) {
            for (std::int64_t x = box.firstX; x < box.endX; ++x) {
                const auto verdict = oracle::judge(triangle, FillRule::Closed, x, y);
                Place &place = places[std::size_t(pictureLine(frame, y)) * std::size_t(frame.width)
                                      + std::size_t(x - frame.firstColumn)];
                for (const oracle::EdgeVerdict &edge : verdict.edges) {
                    if (!verdict.covered || edge.edgeFunction != 0)
                        continue;
                    if (!owners.isShared(triangle, edge.from, edge.to))
                        place = Place::OnAnother;
                    else if (place == Place::OnNoEdge)
                        place = Place::Shared;
                }
            }
        }
    }
    std::vector<std::uint8_t> shared(places.size(), 0);
    std::ranges::transform(places, shared.begin(),
                           [](Place place) { return std::uint8_t(place == Place::Shared); });
    return shared;
}

} // namespace pixelplumb
