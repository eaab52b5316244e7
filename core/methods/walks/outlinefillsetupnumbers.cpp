// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/lines/lineendnumbers.h"
#include "core/methods/walks/outlinefillnames.h"
#include "core/methods/walks/outlinefillnumbers.h"
#include "core/methods/words/channelnumbers.h"
#include "core/methods/words/formulatext.h"
#include "core/methods/words/placenumbers.h"

namespace pixelplumb {

const NumberTable<OutlineFillSetUp> &outlineSetUpNumbers()
{
    using State = OutlineFillSetUp;
    static const auto numbers = [] {
        NumberTable<State> table;
        for (int corner = 0; corner < 3; ++corner) {
            const QString toolTip = u"of P%1, rounded to a whole pixel: ⌊v + ½⌋."_s.arg(
                vertexDigits[std::size_t(corner)]);
            table.push_back(endNumber<State>(u'x', corner, toolTip, [corner](const State &setUp) {
                return pixels(setUp.corners[std::size_t(corner)].position.x);
            }));
            table.push_back(endNumber<State>(u'y', corner, toolTip, [corner](const State &setUp) {
                return pixels(setUp.corners[std::size_t(corner)].position.y);
            }));
        }
        for (std::size_t corner = 0; corner < 3; ++corner) {
            appendChannels(
                table,
                plainNumber(u"%_"_s + QString::number(corner), QString(u'%') + vertexDigits[corner],
                            "levels", u"Level of % at P"_s + vertexDigits[corner] + u'.'),
                [corner](const State &setUp, std::size_t channel) {
                    return Quantity::integer(setUp.corners[corner].colour.channels[channel]);
                });
        }
        for (std::size_t edge = 0; edge < 3; ++edge) {
            const QString axes = "%1%2 − %1%3";
            const auto along = [&](QChar axis) {
                return axes.arg(axis).arg(vertexDigits[(edge + 1) % 3]).arg(vertexDigits[edge]);
            };
            const auto back = [&](QChar axis) {
                return axes.arg(axis).arg(vertexDigits[edge]).arg(vertexDigits[(edge + 1) % 3]);
            };
            const QString alongX = u"max(%1, %2)"_s.arg(along(u'x'), back(u'x'));
            const QString alongY = u"max(%1, %2)"_s.arg(along(u'y'), back(u'y'));
            table.push_back(
                {plainNumber(u"steps_%1"_s.arg(edge), lengthTitle(edge), "px",
                             u"The steps of the midpoint algorithm along %1: its longer side."_s
                                 .arg(outlineEdgeName(edge)),
                             lengthTitle(edge) + u" = max(%1, %2)"_s.arg(alongX, alongY)),
                 [edge](const State &setUp) {
                     return Quantity::integer(setUp.edges[edge].line.deltaX);
                 }});
            table.push_back(
                {plainNumber(
                     u"across_%1"_s.arg(edge), acrossTitle(edge), "px",
                     u"How far %1 goes across: its shorter side."_s.arg(outlineEdgeName(edge)),
                     acrossTitle(edge) + u" = min(%1, %2)"_s.arg(alongX, alongY)),
                 [edge](const State &setUp) {
                     return Quantity::integer(setUp.edges[edge].line.deltaY);
                 }});
        }
        return table;
    }();
    return numbers;
}

} // namespace pixelplumb
