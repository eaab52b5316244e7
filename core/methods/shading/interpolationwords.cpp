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
        const QString name = u"P%1 = "_s.arg(vertexDigits[i]);
        points.append((isSorted ? name + u"vertex %1 "_s.arg(vertex) : name)
                      + pointText(positions[vertex]));
    }
    const QString sorted = axisOf(form) == SpanAxis::Row ? u"Sorted by y, the largest first: "_s
                                                         : u"Sorted by x: "_s;
    return (isSorted ? sorted : u"The vertices as they are given: "_s) + points.join(u", "_s)
        + u'.';
}

QString segmentText(InterpolationForm form, const std::array<int, 3> &order)
{
    const QString segment = isBilinear(form) ? nameOf(SortedEdge::L02)
                                             : u"P%1P%2"_s.arg(vertexDigits[std::size_t(order[0])])
                                                   .arg(vertexDigits[std::size_t(order[2])]);
    return u" It has no area: the closed rule paints the samples on its segment, "
           "coloured along %1."_s.arg(segment);
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
