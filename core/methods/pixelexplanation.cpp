// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/columnrecord.h"
#include "core/methods/columnscanexplanation.h"
#include "core/methods/formulatext.h"
#include "core/methods/sortedtriangle.h"

#include <algorithm>

namespace pixelplumb {

Explanation explainPixel(const TracedScene &traced, const TraceStep &step)
{
    const ScanTrace &trace = *traced.trace;
    const std::vector<SampleRecord> fragments = trace.samples(step.span);
    const std::size_t place = step.sample - trace.firstSampleOf(step.span);
    const SampleRecord &fragment = fragments[place];
    const ColumnRecord column(trace.span(step.span));
    const auto exact
        = oracle::colourAt(traced.primitives.triangles[step.primitive], fragment.x, fragment.y);
    const bool nearest = traced.scene.settings.rounding == ByteRounding::Nearest;

    Explanation explanation;
    explanation.heading = QStringLiteral("Pixel (%1, %2)").arg(fragment.x).arg(fragment.y);
    explanation.sentence = place == 0
        ? QStringLiteral("The column's first pixel takes R, G and B as they start.")
        : QStringLiteral("One row up: each level grows by its Δ.");
    if (fragment.clamped)
        explanation.sentence += QStringLiteral(" A level left 0 … 255 and is clamped.");
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const QChar name = channelLetters[channel];
        FormulaLine level;
        level.subject = channelSubjects[channel];
        level.used = fragment.colour[channel];
        level.exact = exact[channel];
        if (place == 0) {
            level.symbols = QStringLiteral("%1 = %1_B + (⌈y_B⌉ − y_B)·Δ%1").arg(name);
            level.substituted
                = QStringLiteral("%1 + (%2 − %3)·%4")
                      .arg(term(column.colourBottom(channel)))
                      .arg(column.span().firstDrawn)
                      .arg(operand(column.yBottom()), operand(column.colourRate(channel)));
        } else {
            level.symbols = QStringLiteral("%1 ← %1 + Δ%1").arg(name);
            level.substituted = QStringLiteral("%1 + %2").arg(
                term(fragments[place - 1].colour[channel]), operand(column.colourRate(channel)));
        }
        explanation.lines.push_back(level);

        FormulaLine byte;
        byte.subject = channelSubjects[channel];
        byte.symbols = (nearest ? QStringLiteral("byte = ⌊%1 + ½⌋") : QStringLiteral("byte = ⌊%1⌋"))
                           .arg(name);
        byte.substituted
            = (nearest ? QStringLiteral("⌊%1 + ½⌋") : QStringLiteral("⌊%1⌋")).arg(term(level.used));
        byte.used = Quantity::integer(std::clamp<std::int64_t>(fragment.level[channel], 0, 255));
        byte.exact = Quantity::integer(
            oracle::byteColourAt(traced.primitives.triangles[step.primitive], fragment.x,
                                 fragment.y, traced.scene.settings.rounding)
                .channels[channel]);
        explanation.lines.push_back(byte);
    }
    return explanation;
}

} // namespace pixelplumb
