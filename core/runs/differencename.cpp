// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/differencename.h"

namespace pixelplumb {

QString nameOf(Difference difference)
{
    switch (difference) {
    case Difference::None:
        break;
    case Difference::Missing:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "missing"));
    case Difference::Extra:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "extra"));
    case Difference::Colour:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "colour"));
    }
    return QStringLiteral("none");
}

} // namespace pixelplumb
