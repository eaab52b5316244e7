// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/words/channelnumbers.h"

#include "core/geometry/colour.h"

namespace pixelplumb {

QString forChannel(QString text, std::size_t channel)
{
    return text.replace(u'%', channelLetters[channel]);
}

NumberDescription forChannel(NumberDescription pattern, std::size_t channel)
{
    constexpr std::array subjects = {NumberSubject::Red, NumberSubject::Green, NumberSubject::Blue};
    for (QString *text : {&pattern.id, &pattern.title, &pattern.unit, &pattern.toolTip,
                          &pattern.formula, &pattern.startFormula})
        *text = forChannel(*text, channel);
    pattern.subject = subjects[channel];
    return pattern;
}

} // namespace pixelplumb
