// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formulatext.h"
#include "core/methods/interpolationnames.h"
#include "core/methods/interpolationwords.h"
#include "core/methods/shadednumbers.h"

#include <QStringList>

namespace pixelplumb {

namespace {

/// "2 (number 0, 3)": their places in the pattern (resources/scene-file.md).
QString writtenSamplesText(const ShadedSampleState &state)
{
    QStringList places;
    for (int k = 0; k < state.samples; ++k) {
        if ((state.samplesWritten >> k & 1) != 0)
            places.append(QString::number(k));
    }
    return places.size() == state.samples ? QStringLiteral("all")
                                          : QStringLiteral("%1 (number %2)")
                                                .arg(places.size())
                                                .arg(places.join(QStringLiteral(", ")));
}

} // namespace

void tellShaded(StepWords &words, const ShadedSetUpState &state)
{
    words.sentence = verticesText(state.form, state.order, state.position);
    if (state.zeroArea)
        words.sentence += segmentText(state.form, state.order);
    if (state.effects.perspective)
        words.sentence += QStringLiteral(" What the vertices carry is divided by w, because that "
                                         "is what changes linearly in the frame.");
}

void tellShaded(StepWords &words, const ShadedSpanState &state)
{
    if (state.isBounded) {
        words.heading = walkNames(InterpolationForm::Bilinear).heading(state.walk);
        const Lattice x = state.walk.column.x * unitsPerPixel;
        const auto &corners = state.walk.corners;
        if (x < corners[0].position.x || x > corners[2].position.x)
            words.sentence = QStringLiteral("The column lies beside the triangle, which covers "
                                            "parts of its pixels: its edges are prolonged to it, "
                                            "and may have crossed.");
        return;
    }
    words.heading = QStringLiteral("Column %1").arg(state.walk.column.x);
    words.sentence = QStringLiteral("Only samples beside the centres of its pixels lie in the "
                                    "triangle: no bounds are walked here.");
}

void tellShaded(StepWords &words, const ShadedSampleState &state)
{
    if (state.samples > 0) {
        words.sentence = state.isWritten
            ? QStringLiteral("An edge passes through the pixel: of its %1 samples this triangle "
                             "wrote %2. The pixel is the mean of all of them.")
                  .arg(state.samples)
                  .arg(writtenSamplesText(state))
            : QStringLiteral("Refused: at each of the pixel's %1 samples that the triangle covers "
                             "it lies behind what stands there.")
                  .arg(state.samples);
        return;
    }
    if (state.isBeyondHorizon) {
        words.sentence = QStringLiteral("Refused: it lies beyond the horizon of the triangle's "
                                        "plane, where there are no attributes.");
        return;
    }
    const QString covered = state.isWritten && !state.area.isNone()
        ? QStringLiteral("The triangle covers %1 of the pixel's square.").arg(term(state.area))
        : QString();
    if (state.effects.depth == DepthTest::None) {
        words.sentence = covered;
        return;
    }
    const QString z = term(state.depth);
    if (!state.isWritten)
        words.sentence = QStringLiteral("Refused: its depth %1 lies behind %2, which stands there.")
                             .arg(z, term(state.nearest));
    else if (state.nearest.isNone())
        words.sentence = QStringLiteral("Nothing stands there yet: depth %1 is kept.").arg(z);
    else
        words.sentence
            = QStringLiteral(
                  "Depth %1 is not behind %2, which stood there: it is written and kept.")
                  .arg(z, term(state.nearest));
    if (!covered.isEmpty())
        words.sentence = covered + u' ' + words.sentence;
}

} // namespace pixelplumb
