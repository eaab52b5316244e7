// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/shownname.h"

#include "core/grade/showntext.h"
#include "core/scene/shortened.h"

#include <QFileInfo>

namespace pixelplumb {

QString shownName(const QString &path)
{
    constexpr qsizetype longestName = 120; // characters
    return escapedControls(shortened(QFileInfo(path).fileName(), longestName));
}

} // namespace pixelplumb
