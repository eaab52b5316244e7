// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/effectoracle.h"

#include "core/oracle/exactsample.h"
#include "core/oracle/oracle.h"
#include "core/oracle/squarearea.h"

#include <algorithm>

namespace pixelplumb::oracle {

namespace {

/// The bounding box of a triangle, in lattice units.
struct TriangleBox {
    explicit TriangleBox(const Triangle &triangle)
    {
        const auto &v = triangle.vertices;
        const auto [left, right] = std::minmax({v[0].position.x, v[1].position.x, v[2].position.x});
        const auto [low, high] = std::minmax({v[0].position.y, v[1].position.y, v[2].position.y});
        least = {left, low};
        greatest = {right, high};
    }

    // Whether a pixel of the row or column may show the triangle: its square meets the triangle as
    // seen by one of the pixel's samples, up to half a pixel away.
    bool isNearRow(std::int64_t y) const { return isNear(y * unitsPerPixel, least.y, greatest.y); }
    bool isNearColumn(std::int64_t x) const
    {
        return isNear(x * unitsPerPixel, least.x, greatest.x);
    }

    LatticePoint least, greatest;

private:
    static bool isNear(Lattice at, Lattice first, Lattice last)
    {
        return at >= first - unitsPerPixel && at <= last + unitsPerPixel;
    }
};

Triangle movedBy(const Triangle &original, const LatticePoint &offset)
{
    Triangle triangle = original;
    for (Vertex &vertex : triangle.vertices)
        vertex.position = {vertex.position.x - offset.x, vertex.position.y - offset.y};
    return triangle;
}

/// What a sample of the frame holds.
struct Surface {
    Colour colour;
    std::optional<WideFraction> depth; ///< none: farther than everything
    bool isWritten = false;
    bool isUndecided = false;
};

/// Draws all triangles, sample by sample, row by row.
class Painter {
public:
    Painter(const Primitives &primitives, const ScanSettings &settings, const EffectTruth &what,
            const FrameView &frame)
        : m_primitives(primitives)
        , m_settings(settings)
        , m_what(what)
        , m_rule(settings, frame)
        , m_offsets(sampleOffsets(what.antialiasing))
        , m_boxes(primitives.triangles.begin(), primitives.triangles.end())
    {
    }

    void enterRow(std::int64_t y)
    {
        m_row = y;
        m_near.clear();
        for (std::size_t i = 0; i < m_boxes.size(); ++i) {
            if (m_boxes[i].isNearRow(y))
                m_near.push_back(i);
        }
    }

    /// The final content of a pixel of the row.
    Surface pixel(std::int64_t x, const Colour &before) const
    {
        if (m_offsets.size() == 1 || !isOnEdge(x))
            return sample({0, 0}, x, before);
        Surface mean;
        std::array<int, 3> sums = {};
        for (const LatticePoint &offset : m_offsets) {
            const Surface one = sample(offset, x, before);
            for (std::size_t channel = 0; channel < 3; ++channel)
                sums[channel] += one.colour.channels[channel];
            mean.isWritten = mean.isWritten || one.isWritten;
            mean.isUndecided = mean.isUndecided || one.isUndecided;
        }
        const int count = int(m_offsets.size());
        for (std::size_t channel = 0; channel < 3; ++channel)
            mean.colour.channels[channel] = std::uint8_t((2 * sums[channel] + count) / (2 * count));
        return mean;
    }

private:
    bool isOnEdge(std::int64_t x) const
    {
        return std::ranges::any_of(m_near, [&](std::size_t index) {
            const Triangle &triangle = m_primitives.triangles[index];
            return m_boxes[index].isNearColumn(x) && doubledArea(triangle) != 0
                && edgeMeetsSquare(triangle, x, m_row);
        });
    }

    Surface sample(const LatticePoint &offset, std::int64_t x, const Colour &before) const
    {
        Surface surface;
        surface.colour = before;
        for (const std::size_t index : m_near) {
            const Triangle &triangle = m_primitives.triangles[index];
            if (!m_boxes[index].isNearColumn(x))
                continue;
            // A segment paints all samples of a pixel whose own sample lies on it.
            const bool isSegment = doubledArea(triangle) == 0;
            paint(surface, index, isSegment ? triangle : movedBy(triangle, offset), x, m_row);
        }
        return surface;
    }

    /// Draws one triangle over the sample's content.
    void paint(Surface &surface, std::size_t index, const Triangle &triangle, std::int64_t x,
               std::int64_t y) const
    {
        BigRational share = 1;
        if (m_what.antialiasing == Antialiasing::Area && doubledArea(triangle) != 0)
            share = areaInSquare(triangle, x, y);
        else if (!covers(triangle, m_rule, x, y))
            return;
        if (share == 0)
            return;
        const std::optional<ExactSample> source
            = exactSampleAt(m_primitives, index, triangle, m_settings.rounding, m_what, x, y);
        if (!source)
            return;
        if (m_what.depth) {
            const WideFraction depth = keptDepth(source->z, m_primitives.appearance.depthFormat);
            if (surface.depth && !isNoFarther(depth, *surface.depth))
                return;
            surface.depth = depth;
        }
        surface.colour = blended(source->colour, sharedAlpha(source->alpha, share), surface.colour);
        surface.isWritten = true;
        surface.isUndecided = surface.isUndecided || (source->lit && source->lit->undecided);
    }

    const Primitives &m_primitives;
    ScanSettings m_settings;
    EffectTruth m_what;
    BoundaryRule m_rule;
    std::vector<LatticePoint> m_offsets;
    std::vector<TriangleBox> m_boxes; ///< of all triangles
    std::int64_t m_row = 0;
    std::vector<std::size_t> m_near; ///< the triangles that the row may show, in drawing order
};

} // namespace

bool coversPart(const Triangle &triangle, const BoundaryRule &rule, Antialiasing antialiasing,
                std::int64_t x, std::int64_t y)
{
    if (doubledArea(triangle) == 0)
        return covers(triangle, rule, x, y);
    if (antialiasing == Antialiasing::Area)
        return areaInSquare(triangle, x, y) != 0;
    return std::ranges::any_of(sampleOffsets(antialiasing), [&](const LatticePoint &offset) {
        return covers(movedBy(triangle, offset), rule, x, y);
    });
}

Colour blended(const Colour &source, std::uint8_t alpha, const Colour &destination)
{
    Colour result;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const int sum
            = source.channels[channel] * alpha + destination.channels[channel] * (255 - alpha);
        result.channels[channel] = std::uint8_t((2 * sum + 255) / 510);
    }
    return result;
}

std::vector<LatticePoint> sampleOffsets(Antialiasing antialiasing)
{
    switch (antialiasing) {
    case Antialiasing::None:
    case Antialiasing::Area:
        break;
    case Antialiasing::Samples4:
        return {{-32, -96}, {96, -32}, {-96, 32}, {32, 96}};
    case Antialiasing::Samples16: {
        std::vector<LatticePoint> offsets
            = {{1, 1},  {-1, -3}, {-3, 2},  {4, -1}, {-5, -2}, {2, 5},  {5, 3}, {3, -5},
               {-2, 6}, {0, -7},  {-4, -6}, {-6, 4}, {-8, 0},  {7, -4}, {6, 7}, {-7, -8}};
        for (LatticePoint &offset : offsets)
            offset = {offset.x * unitsPerPixel / 16, offset.y * unitsPerPixel / 16};
        return offsets;
    }
    }
    return {{0, 0}};
}

std::vector<PixelPlace> drawEffects(const Primitives &primitives, const ScanSettings &settings,
                                    const EffectTruth &what, FrameView frame)
{
    Painter painter(primitives, settings, what, frame);
    std::vector<PixelPlace> undecided;
    for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
        painter.enterRow(y);
        for (std::int64_t x = frame.firstColumn; x < frame.endColumn(); ++x) {
            const Surface surface = painter.pixel(x, unpacked(*frame.at(x, y)));
            if (surface.isWritten)
                *frame.at(x, y) = packed(surface.colour);
            if (surface.isUndecided)
                undecided.push_back({x, y});
        }
    }
    return undecided;
}

} // namespace pixelplumb::oracle
