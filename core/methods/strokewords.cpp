// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formulatext.h"
#include "core/methods/strokenumbers.h"

namespace pixelplumb {

void tellStroke(StepWords &words, const StrokeSetUp &setUp)
{
    if (setUp.pieces == 0) {
        words.sentence = QStringLiteral("It has no length, and so no area. Nothing is drawn.");
        return;
    }
    words.sentence = setUp.shape.kind == PrimitiveKind::Line
        ? QStringLiteral("The line is the rectangle ½ px to either side of it, which ends where "
                         "the line ends; its corners are the ends and, to 2⁻¹⁶ px, the half width.")
        : QStringLiteral("The curve is a strip of %1 quadrilaterals ½ px to either side of its "
                         "points, of which %2 come near the frame.")
              .arg(setUp.pieces)
              .arg(setUp.nearFrame);
}

void tellStroke(StepWords &words, const StrokeColumn &column)
{
    const std::int64_t last = column.endRow - 1;
    words.sentence = last == column.firstRow
        ? QStringLiteral("In this column the stroke meets the square of the row %1.").arg(last)
        : QStringLiteral("In this column the stroke meets the squares of rows from %1 to %2.")
              .arg(column.firstRow)
              .arg(last);
}

void tellStroke(StepWords &words, const StrokeSampleState &state)
{
    const StrokeSample &sample = state.sample;
    if (state.isByArea()) {
        words.sentence = QStringLiteral("The stroke covers %1 of the pixel's square, which is its "
                                        "opacity: %2 of 255 parts are the stroke's, the others "
                                        "what stood there.")
                             .arg(term(sample.area))
                             .arg(sample.alpha);
        return;
    }
    if (sample.samples == 1) {
        words.sentence = QStringLiteral("The stroke covers the pixel's sample: it is painted.");
        return;
    }
    words.sentence
        = QStringLiteral("Of the pixel's %2 samples the stroke covers %1; the pixel is the "
                         "mean of what they hold now.")
              .arg(sampleNumbersText(sample.covered, sample.samples))
              .arg(sample.samples);
}

} // namespace pixelplumb
