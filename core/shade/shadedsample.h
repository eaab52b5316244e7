// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/mixednumber.h"
#include "core/number/quantity.h"
#include "core/shade/samplelight.h"
#include "core/shade/scratchframe.h"
#include "core/shade/shadedsetup.h"
#include "core/shade/texelfetch.h"

#include <QRgb>

#include <cstdint>

namespace pixelplumb {

/// Where the numbers of a column's edges come from.
enum class ColumnOrigin : std::uint8_t {
    Walked, ///< from the column before it
    Direct, ///< from the vertices
    None, ///< no edge meets it: only samples off the centres reach it
};

/// The numbers of one column of a shaded triangle.
template <class N>
struct ShadedColumn {
    using Number = typename N::Number;

    std::int64_t x = 0; ///< px
    ColumnOrigin origin = ColumnOrigin::None;
    ColumnHalf half = ColumnHalf::First;
    LongEdge longEdge = LongEdge::Above;
    std::int64_t firstRow = 0, endRow = 0; ///< covered
    std::int64_t firstDrawn = 0, endDrawn = 0; ///< clipped to the frame
    // For the bilinear form.
    PerChannel<Number> rate; ///< per row
    /// In floating numbers: the edges' values where they meet the column, and those places, px.
    Number yBottom, yTop;
    PerChannel<Number> bottom, top;
    /// In exact numbers, over the area: the plane of the channel at row 0 of the column.
    PerChannel<Number> atRow0;
};

/// A column with the bounds walked in A, px.
template <class N, class A>
struct BoundedColumn : ShadedColumn<N> {
    typename A::Number lower = {}, upper = {};
};

/// The samples of a pixel with 4 or 16.
struct SampleColours {
    std::uint16_t written; ///< by this primitive; bit k: sample k
    PixelSamples current;

    int count() const { return int(current.colours().size()); }
};

/// The depths compared for a sample.
template <class N>
struct DepthVerdict {
    typename N::Depth before, now; ///< for DepthTest::Number
    std::uint32_t levelBefore, levelNow; ///< for DepthTest::Levels
};

/// Every number that led to a sample's byte, for observers that read numbers.
template <class N>
struct ShadedSample {
    using Number = typename N::Number;

    std::int64_t runFirst; ///< the row at which adding began
    PerChannel<Number> value; ///< linear in the frame; exact numbers are over the area
    std::array<Number, 3> weight; ///< α β γ of the barycentric form
    DepthVerdict<N> depth;
    std::array<std::int64_t, 3> level; ///< R G B, rounded, before clamping
    Colour interpolated; ///< clamped
    TexelSample<N> texels;
    Colour textured; ///< after the texture, if there is one
    LitSample<typename N::Real> light;
    Colour source; ///< after the light, if there is any: the source colour for blending
    std::int64_t alphaLevel; ///< rounded, before clamping
    std::uint8_t alpha;
    std::uint8_t blendedAlpha; ///< alpha times the covered area
    QRgb before, after;
    SampleColours samples; ///< if there are any, only they, `before` and `after` are meaningful
    Quantity area; ///< the covered area of the pixel, with area antialiasing

    bool isClamped() const
    {
        if (samples.count() > 0)
            return false;
        return std::uint64_t(level[0] | level[1] | level[2] | alphaLevel) > 255 || light.clamped;
    }
};

/// ⌊(s·α + d·(255 − α))/255 + ½⌋
constexpr std::uint8_t blended(std::uint8_t source, std::uint8_t destination, std::uint8_t alpha)
{
    return std::uint8_t(
        (2 * (unsigned(source) * alpha + unsigned(destination) * (255U - alpha)) + 255) / 510);
}

constexpr QRgb blended(const Colour &source, QRgb destination, std::uint8_t alpha)
{
    const Colour under = unpacked(destination);
    return qRgb(blended(source.red(), under.red(), alpha),
                blended(source.green(), under.green(), alpha),
                blended(source.blue(), under.blue(), alpha));
}

} // namespace pixelplumb
