// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/words/pseudocode.h"

namespace pixelplumb {

Pseudocode underRule(Pseudocode code, FillRule rule, FrameOrigin origin)
{
    for (PseudocodeLine &line : code) {
        for (const RuledLine &ruled : line.ruled) {
            if (ruled.rule == rule && ruled.origin.value_or(origin) == origin)
                line.text = ruled.text;
        }
    }
    std::erase_if(code, [](const PseudocodeLine &line) { return line.text.isEmpty(); });
    return code;
}

Pseudocode linesOf(LineOf kind, Pseudocode code)
{
    std::erase_if(code, [kind](const PseudocodeLine &line) {
        return line.of != LineOf::EveryPrimitive && line.of != kind;
    });
    return code;
}

} // namespace pixelplumb
