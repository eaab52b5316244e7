// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/differencename.h"

namespace pixelplumb {

QString nameOf(Difference difference)
{
    switch (difference) {
    case Difference::None:
        break;
    case Difference::Missing:
        return QStringLiteral("missing");
    case Difference::Extra:
        return QStringLiteral("extra");
    case Difference::Colour:
        return QStringLiteral("colour");
    }
    return QStringLiteral("none");
}

} // namespace pixelplumb
