// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace pixelplumb {

/// Objections, some of them empty, in one text that is read after a method's name.
inline QString joinedObjections(QStringList objections)
{
    objections.removeAll(QString());
    return objections.join(QStringLiteral(". It also "));
}

} // namespace pixelplumb
