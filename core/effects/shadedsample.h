// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/samplelight.h"
#include "core/effects/scratchframe.h"
#include "core/effects/shadedsetup.h"
#include "core/effects/texelfetch.h"
#include "core/number/mixednumber.h"
#include "core/number/quantity.h"

#include <QRgb>

#include <cstdint>

namespace pixelplumb {

/// Where the numbers of a column's edges come from.
enum class ColumnOrigin : std::uint8_t {
    Walked, ///< from the column before it
    Direct, ///< from the vertices
    None, ///< no edge meets it: only samples beside the centres reach it
};

/// What one column of a shaded triangle uses.
template <class N>
struct ShadedColumn {
    using Number = typename N::Number;

    std::int64_t x = 0; ///< px
    ColumnOrigin origin = ColumnOrigin::None;
    ColumnHalf half = ColumnHalf::First;
    LongEdge longEdge = LongEdge::Above;
    std::int64_t firstRow = 0, endRow = 0; ///< covered
    std::int64_t firstDrawn = 0, endDrawn = 0; ///< clipped to the frame
    // Of the bilinear form.
    PerChannel<Number> rate; ///< per row
    /// In floating numbers: what the edges have where they meet the column, and where that is, px.
    Number yBottom, yTop;
    PerChannel<Number> bottom, top;
    /// In exact numbers, over the area: at row 0, where the plane of the channel meets the column.
    PerChannel<Number> atRow0;
};

/// With the bounds that were walked in A, px.
template <class N, class A>
struct BoundedColumn : ShadedColumn<N> {
    typename A::Number lower = {}, upper = {};
};

/// The samples of a pixel that has 4 or 16.
struct SampleColours {
    std::uint16_t written; ///< by this primitive; bit k: sample k
    SampleMean mean; ///< of what stands in them now; of no sample where the pixel has one

    int count() const { return int(mean.samples().size()); }
};

/// What a sample was compared with.
template <class N>
struct DepthVerdict {
    typename N::Depth before, now; ///< of DepthTest::Number
    std::uint32_t levelBefore, levelNow; ///< of DepthTest::Levels
};

/// What one sample has: every number that led to its byte. For who reads numbers.
template <class N>
struct ShadedSample {
    using Number = typename N::Number;

    std::int64_t runFirst; ///< the row at which adding began
    PerChannel<Number> value; ///< linear in the frame; in exact numbers over the area
    std::array<Number, 3> weight; ///< α β γ of the barycentric form
    DepthVerdict<N> depth;
    std::array<std::int64_t, 3> level; ///< R G B, rounded, before clamping
    Colour interpolated; ///< clamped
    TexelSample<N> texels;
    Colour textured; ///< after the texture, if there is one
    LitSample<typename N::Real> light;
    Colour source; ///< after the light, if there is any: what is blended
    std::int64_t alphaLevel; ///< rounded, before clamping
    std::uint8_t alpha;
    std::uint8_t blendedAlpha; ///< times the covered area
    QRgb before, after;
    SampleColours samples; ///< then nothing else is meaningful but before and after
    Quantity area; ///< of the pixel, where areas are covered

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
