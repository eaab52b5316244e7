// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/scan/boundaryrule.h"
#include "core/scan/tests/edgetestform.h"

#include <algorithm>
#include <utility>

namespace pixelplumb {

/// The samples [firstX, endX) × [firstY, endY).
struct SampleBox {
    std::int64_t firstX = 0, endX = 0, firstY = 0, endY = 0;

    bool isEmpty() const { return firstX >= endX || firstY >= endY; }
};

/// The samples in a box between two corners, lattice units, its boundary included.
inline SampleBox samplesIn(const LatticePoint &least, const LatticePoint &greatest)
{
    return {ceilPixel(least.x), floorPixel(greatest.x) + 1, ceilPixel(least.y),
            floorPixel(greatest.y) + 1};
}

/// Like samplesIn(), rounded as on the slides (Triangle Rasterization slides, "Triangle
/// rasterization implementation guidelines"): left = (int)(x_min + .5), right = (int)(x_max - .5),
/// in the scene's coordinates. With pixel centres at halves it loses only the samples on x_min and
/// y_min; with centres on whole numbers up to half a pixel. (int) rounds towards 0.
inline SampleBox roundedSamplesIn(const LatticePoint &least, const LatticePoint &greatest,
                                  PixelCentre pixelCentre)
{
    const Lattice offset = pixelCentre == PixelCentre::Half ? halfPixel : 0;
    const auto whole = [](Lattice units) { return units / unitsPerPixel; };
    const auto first = [&](Lattice from) { return whole(from + offset + halfPixel); };
    const auto end = [&](Lattice to) { return whole(to + offset - halfPixel) + 1; };
    return {first(least.x), end(greatest.x), first(least.y), end(greatest.y)};
}

/// How the box of the vertices becomes samples: as samplesIn(), or as roundedSamplesIn() for one of
/// the pixel centres.
enum class BoxRounding : std::uint8_t { None, IntegerCentres, HalfCentres };

/// The corners of the bounding box of the vertices, lattice units: the least and the greatest.
inline std::pair<LatticePoint, LatticePoint> boundingCornersOf(const Triangle &triangle)
{
    const auto &v = triangle.vertices;
    const auto [left, right] = std::minmax({v[0].position.x, v[1].position.x, v[2].position.x});
    const auto [low, high] = std::minmax({v[0].position.y, v[1].position.y, v[2].position.y});
    return {{left, low}, {right, high}};
}

/// The samples in the bounding box of the vertices, its boundary included.
inline SampleBox boundingBoxOf(const Triangle &triangle)
{
    const auto [least, greatest] = boundingCornersOf(triangle);
    return samplesIn(least, greatest);
}

inline SampleBox samplesOf(FrameView frame)
{
    return {frame.firstColumn, frame.endColumn(), frame.firstRow, frame.endRow()};
}

/// Scan Conversion slides, "Using Edge Equations": clip to window by clipping the bbox to the
/// window.
inline SampleBox intersection(const SampleBox &a, const SampleBox &b)
{
    return {std::max(a.firstX, b.firstX), std::min(a.endX, b.endX), std::max(a.firstY, b.firstY),
            std::min(a.endY, b.endY)};
}

/// Everything that is computed once for a triangle whose samples are tested one by one.
template <class A>
struct EdgeTestSetUp {
    using Number = typename A::Number;
    using Ratio = typename A::Ratio;

    std::array<Vertex, 3> vertices;
    bool zeroArea = false;
    SampleBox visited; ///< unclipped
    BoxRounding boxRounding = BoxRounding::None;
    SampleBox tested; ///< clipped to the frame
    std::array<EdgeLine<A>, 3> lines;
    std::array<Number, 3> atOpposite = {}; ///< each line's value at the vertex that faces it
    std::array<std::array<typename A::Level, 3>, 3> facing = {}; ///< that vertex's R G B
    BoundaryRule rule = FillRule::Closed; ///< decides ownsTie
    std::array<bool, 3> ownsTie = {}; ///< whether a sample exactly on the line is inside
    // Where weights and colours are incremental: their changes for each step of x and of y.
    std::array<Ratio, 3> weightPerX = {}, weightPerY = {};
    std::array<Ratio, 3> colourPerX = {}, colourPerY = {};
};

/// The numbers that tested and coloured one sample.
template <class A>
struct TestedSample {
    std::array<typename A::Number, 3> value = {}; ///< of each line
    std::array<typename A::Ratio, 3> weight = {}; ///< of the vertex that faces each line
    std::array<typename A::Ratio, 3> colour = {}; ///< levels, if covered
    std::array<std::int64_t, 3> level = {}; ///< rounded, before clamping to 0 … 255
    bool covered = false;
    bool ofSegment = false; ///< decided by the segment alone

    bool isClamped() const
    {
        return std::ranges::any_of(level, [](std::int64_t byte) { return byte < 0 || byte > 255; });
    }
};

/// One row or column of tested samples.
template <class A>
struct EdgeTestSpan {
    std::int64_t coordinate = 0; ///< y of a row, x of a column
    std::int64_t firstSample = 0, endSample = 0; ///< along the span, unclipped
    std::int64_t firstTested = 0, endTested = 0; ///< clipped to the frame
    /// The numbers at firstTested, where they are incremental.
    std::array<typename A::Number, 3> value = {};
    std::array<typename A::Ratio, 3> weight = {};
    std::array<typename A::Ratio, 3> colour = {};
};

template <class A>
struct EdgeTestNumbers {
    using SetUp = EdgeTestSetUp<A>;
    using Span = EdgeTestSpan<A>;
    using Sample = TestedSample<A>;
};

} // namespace pixelplumb
