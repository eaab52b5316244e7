// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/rounding/margin.h"

namespace pixelplumb {

std::string_view nameOf(Leeway leeway)
{
    switch (leeway) {
    case Leeway::Strict:
        return "strict";
    case Leeway::Rule:
        return "rule";
    case Leeway::Edges:
        return "edges";
    case Leeway::Once:
        break;
    }
    return "once";
}

} // namespace pixelplumb
