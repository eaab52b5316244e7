// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/margin.h"

namespace pixelplumb {

QString nameOf(Leeway leeway)
{
    switch (leeway) {
    case Leeway::Strict:
        return QStringLiteral("strict");
    case Leeway::Rule:
        return QStringLiteral("rule");
    case Leeway::Edges:
        return QStringLiteral("edges");
    case Leeway::Once:
        break;
    }
    return QStringLiteral("once");
}

} // namespace pixelplumb
