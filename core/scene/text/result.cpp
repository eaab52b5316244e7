// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/text/result.h"

namespace pixelplumb {

QString InputError::message() const
{
    QString text = found;
    if (!place.isEmpty())
        text.prepend(place + u": "_s);
    if (!expected.isEmpty())
        text += u"; expected "_s + expected;
    return text;
}

} // namespace pixelplumb
