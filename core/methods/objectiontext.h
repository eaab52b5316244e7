// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace pixelplumb {

using namespace Qt::StringLiterals;

/// Objections, some of them empty, in one text that is read after a method's name.
inline QString joinedObjections(QStringList objections)
{
    objections.removeAll(QString());
    return objections.join(u". It also "_s);
}

} // namespace pixelplumb
