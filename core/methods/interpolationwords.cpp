// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/interpolationwords.h"

#include "core/methods/formulatext.h"
#include "core/methods/interpolationnames.h"

#include <QStringList>

namespace pixelplumb {

void tellInterpolation(StepWords &words, const InterpolationSetUpState &state,
                       InterpolationForm form)
{
    const bool isSorted = isBilinear(form);
    QStringList points;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t vertex = isSorted ? std::size_t(state.order[i]) : i;
        const QString name = isSorted
            ? QStringLiteral("P%1 = vertex %2").arg(vertexDigits[i]).arg(vertex)
            : QStringLiteral("x%1 and y%1 of vertex %2").arg(vertexDigits[i]).arg(vertex);
        points.append(name + u' ' + pointText(state.vertices[vertex].position));
    }
    const QString order = axisOf(form) == SpanAxis::Row
        ? QStringLiteral("Sorted by y, the highest first: ")
        : QStringLiteral("Sorted by x: ");
    words.sentence = (isSorted ? order : QStringLiteral("The vertices as they are given: "))
        + points.join(QStringLiteral(", ")) + u'.';
    if (state.zeroArea)
        words.sentence += QStringLiteral(" It has no area: the closed rule paints the samples on "
                                         "its segment, coloured along L₀₂.");
}

void tellInterpolation(StepWords &words, const InterpolationSpanState &state,
                       InterpolationForm form)
{
    if (!isBilinear(form) || state.drawnSamples() == 0 || state.hasRate()
        || !state.walk.start.hasPlane)
        return;
    words.sentence = walkNames(form)
                         .filled(QStringLiteral("{a}_{lo} = {a}_{hi} = %1: the {span} is the "
                                                "{across} %2 alone, and there is no change to "
                                                "share out, and no Δ."))
                         .arg(term(state.column.yBottom))
                         .arg(state.column.firstDrawn);
}

} // namespace pixelplumb
