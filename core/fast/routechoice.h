// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fast/colourplane.h"
#include "core/fast/fastroute.h"

#include <algorithm>

namespace pixelplumb {

/// How one triangle of a batch is drawn.
struct Route {
    FastKernel kernel;
    ColourWord word;
    FastReason reason;
};

/// Whether the batch's own colour words are exact for this triangle; if not, words of 56 bits are
/// computed.
inline bool hasExactWords(const TriangleBatch &batch, std::size_t i)
{
    return batch.resolution[i] < resolutionLimit(middleFractionBits)
        && batch.magnitude[i] < magnitudeLimit;
}

/// A triangle at least this wide and high stores its colours in a table instead of 64-bit words.
inline constexpr std::int32_t narrowestTableBox = 64;

/// The narrowest colour word that is exact (colourplane.h).
inline ColourWord colourWordFor(const TriangleBatch &batch, std::size_t i)
{
    if (TriangleBatch::contains(batch.flat, i))
        return ColourWord::Flat;
    if (!hasExactWords(batch, i))
        return batch.resolution[i] < resolutionLimit(wideFractionBits) ? ColourWord::Steps64
                                                                       : ColourWord::Other;
    if (batch.resolution[i] < resolutionLimit(narrowFractionBits))
        return ColourWord::Steps32;
    const std::int64_t walk = std::int64_t(batch.endColumn[i]) - batch.firstColumn[i]
        + batch.endRow[i] - batch.firstRow[i];
    // A table costs a few additions per row: less than it saves only where rows are many pixels
    // wide.
    const std::int32_t narrower
        = std::min(batch.endColumn[i] - batch.firstColumn[i], batch.endRow[i] - batch.firstRow[i]);
    if (narrower >= narrowestTableBox && batch.reducedArea[i] <= largestTableArea
        && walk < longestTableWalk)
        return ColourWord::Table32;
    return ColourWord::Steps64;
}

/// Chooses the kernel by the bounding box; all routes are decided here. A window has at least 16
/// columns; `widestStrip` is what fits into it and into the registers.
inline Route routeFor(const TriangleBatch &batch, std::size_t i, FillRule rule,
                      std::int32_t widestStrip)
{
    if (TriangleBatch::contains(batch.farAway, i))
        return {FastKernel::Plain, ColourWord::Other, FastReason::FarAway};
    const std::int32_t width = batch.endColumn[i] - batch.firstColumn[i];
    const std::int32_t height = batch.endRow[i] - batch.firstRow[i];
    if (width <= 0 || height <= 0)
        return {FastKernel::None, ColourWord::Other, FastReason::OutsideFrame};
    if (batch.signedArea[i] == 0) {
        if (rule == FillRule::Closed)
            return {FastKernel::Plain, ColourWord::Other, FastReason::ZeroAreaSegment};
        return {FastKernel::None, ColourWord::Other, FastReason::ZeroAreaPaintsNothing};
    }
    const ColourWord word = colourWordFor(batch, i);
    if (word == ColourWord::Other)
        return {FastKernel::Plain, word, FastReason::BeyondExactWords};
    if (width <= 16 && batch.extent[i] <= TriangleBatch::blockExtent
        && (word == ColourWord::Flat || word == ColourWord::Steps32))
        return {width <= 8 ? FastKernel::Block8 : FastKernel::Block16, word, FastReason::SmallBox};
    if (width <= 16)
        return {width <= 8 ? FastKernel::Strip8 : FastKernel::Strip16, word, FastReason::NarrowBox};
    if (TriangleBatch::contains(batch.spansRows, i))
        return {FastKernel::RowSpans, word,
                TriangleBatch::contains(batch.flat, i) ? FastReason::LargeFlat
                                                       : FastReason::WideBox};
    if (width < 64 || widestStrip < 32)
        return {FastKernel::Strip16, word, FastReason::TallBox};
    return {FastKernel::Strip32, word, FastReason::TallBox};
}

} // namespace pixelplumb
