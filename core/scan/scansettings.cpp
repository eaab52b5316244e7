// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scan/scansettings.h"

namespace pixelplumb {

namespace {

template <class Choice, std::size_t Count>
std::optional<Choice> choiceNamed(const std::array<Choice, Count> &choices, std::string_view name)
{
    for (const Choice choice : choices) {
        if (nameOf(choice) == name)
            return choice;
    }
    return std::nullopt;
}

} // namespace

std::string_view nameOf(FillRule rule)
{
    static constexpr std::array<std::string_view, allFillRules.size()> names
        = {"closed", "half-open-column", "top-left", "off-screen-point", "open"};
    return names[std::size_t(rule)];
}

std::string_view nameOf(Arithmetic arithmetic)
{
    static constexpr std::array<std::string_view, allArithmetics.size()> names
        = {"exact", "float32", "float64", "fixed16.16", "fixed32.32"};
    return names[std::size_t(arithmetic)];
}

std::string_view nameOf(ByteRounding rounding)
{
    switch (rounding) {
    case ByteRounding::Nearest:
        return "nearest";
    case ByteRounding::Truncate:
        return "truncate";
    }
    return {};
}

std::optional<FillRule> fillRuleNamed(std::string_view name)
{
    return choiceNamed(allFillRules, name);
}

std::optional<Arithmetic> arithmeticNamed(std::string_view name)
{
    return choiceNamed(allArithmetics, name);
}

} // namespace pixelplumb
