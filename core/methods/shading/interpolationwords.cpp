// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/interpolationwords.h"

#include "core/methods/shading/interpolationnames.h"
#include "core/methods/words/formulatext.h"

#include <QStringList>

namespace pixelplumb {

QString verticesText(InterpolationForm form, const std::array<int, 3> &order,
                     const std::array<LatticePoint, 3> &positions)
{
    const bool isSorted = isBilinear(form);
    QStringList points;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t vertex = isSorted ? std::size_t(order[i]) : i;
        const QString name = QStringLiteral("P%1 = ").arg(vertexDigits[i]);
        points.append((isSorted ? name + QStringLiteral("vertex %1 ").arg(vertex) : name)
                      + pointText(positions[vertex]));
    }
    const QString sorted = axisOf(form) == SpanAxis::Row
        ? QStringLiteral("Sorted by y, the largest first: ")
        : QStringLiteral("Sorted by x: ");
    return (isSorted ? sorted : QStringLiteral("The vertices as they are given: "))
        + points.join(QStringLiteral(", ")) + u'.';
}

QString segmentText(InterpolationForm form, const std::array<int, 3> &order)
{
    const QString segment = isBilinear(form) ? nameOf(SortedEdge::L02)
                                             : QStringLiteral("P%1P%2")
                                                   .arg(vertexDigits[std::size_t(order[0])])
                                                   .arg(vertexDigits[std::size_t(order[2])]);
    return QStringLiteral(" It has no area: the closed rule paints the samples on its segment, "
                          "coloured along %1.")
        .arg(segment);
}

void tellInterpolated(StepWords &words, const ShadedSpanState &state, InterpolationForm form)
{
    words.heading = walkNames(form).heading(state.walk);
    if (state.walk.start.hasPlane && state.walk.beginsHalf && !state.walk.isFirst)
        words.moment = Moment::TakeOver;
    if (!isBilinear(form) || state.drawnSamples() == 0 || state.hasRate()
        || !state.walk.start.hasPlane)
        return;
    words.sentence = walkNames(form)
                         .filled("{a}_{lo} = {a}_{hi} = %1: the {span} is the {across} %2 alone, "
                                 "and there is no change to share out, and no Δ.")
                         .arg(term(state.lower))
                         .arg(state.firstDrawn);
}

} // namespace pixelplumb
