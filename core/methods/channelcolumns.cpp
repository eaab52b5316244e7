// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/channelcolumns.h"

#include "core/geometry/colour.h"

namespace pixelplumb {

void appendChannels(std::vector<TraceColumn> &columns, const TraceColumn &pattern)
{
    for (const QChar letter : channelLetters) {
        TraceColumn column = pattern;
        for (QString *text : {&column.id, &column.title, &column.unit, &column.toolTip,
                              &column.formula, &column.startFormula})
            text->replace(u'%', letter);
        columns.push_back(column);
    }
}

} // namespace pixelplumb
