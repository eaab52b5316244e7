// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/pseudocode.h"

namespace pixelplumb {

Pseudocode underRule(Pseudocode code, FillRule rule)
{
    for (PseudocodeLine &line : code) {
        for (const RuledLine &ruled : line.ruled) {
            if (ruled.rule == rule)
                line.text = ruled.text;
        }
    }
    return code;
}

} // namespace pixelplumb
