// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/strokes/strokescan.h"
#include "core/trace/numberrow.h"
#include "core/trace/stepwords.h"

/// The numbers and the words of strokes.
namespace pixelplumb {

/// What the numbers of a pixel read: the sample and what it belongs to.
struct StrokeSampleState {
    const StrokeSetUp &setUp;
    const StrokeSample &sample;
    ByteRounding rounding = ByteRounding::Nearest;
    std::int64_t x = 0, y = 0;
    bool isRefused = false;

    bool isOnLine() const { return setUp.shape.kind == PrimitiveKind::Line; }
    bool isByArea() const { return sample.samples == 0; }
    bool isMean() const { return sample.samples > 1; } ///< of samples that have their own colours
    /// Where a sample lies in the rectangle of a line, which covers it from −1 to 1 half widths
    /// across and from 0 to 1 length along; `offset` is from the pixel's own sample.
    Quantity across(const LatticePoint &offset = {}) const;
    Quantity along(const LatticePoint &offset = {}) const;
    Quantity place() const; ///< t
    Quantity level(std::size_t channel) const; ///< before rounding
};

const NumberTable<StrokeSetUp> &strokeSetUpNumbers();
const NumberTable<StrokeColumn> &strokeColumnNumbers();
/// For a run with this antialiasing: by area, or by 1, 4 or 16 samples.
NumberTable<StrokeSampleState> strokeSampleNumbers(Antialiasing antialiasing);

void tellStroke(StepWords &words, const StrokeSetUp &setUp);
void tellStroke(StepWords &words, const StrokeColumn &column);
void tellStroke(StepWords &words, const StrokeSampleState &state);

} // namespace pixelplumb
