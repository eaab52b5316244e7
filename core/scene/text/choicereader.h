// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/choicenames.h"
#include "core/scene/text/jsonreader.h"

#include <array>

namespace pixelplumb {

/// "one of a, b, c"; a single name stands alone.
inline QString anyOf(const QStringList &names)
{
    return names.size() == 1 ? names.front() : u"one of "_s + names.join(u", "_s);
}

/// Reads a choice by its name, or as a number where the name is one; a missing key keeps the
/// default.
template <class Choice, std::size_t Count>
void readChoice(JsonReader &json, const JsonNode &node, const std::array<Choice, Count> &choices,
                Choice &choice)
{
    if (node.isMissing())
        return;
    const QStringList names = namesOf(choices);
    const auto isNumber = [](const QString &name) { return name.front().isDigit(); };
    for (std::size_t index = 0; index < Count; ++index) {
        const QString &name = names[qsizetype(index)];
        const bool isSaid = isNumber(name) ? node.toInteger(-1) == name.toInt()
                                           : node.isString() && node.toString() == name;
        if (isSaid) {
            choice = choices[index];
            return;
        }
    }
    json.fail(node, describe(node), anyOf(names));
}

} // namespace pixelplumb
