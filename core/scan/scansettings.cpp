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
    switch (rule) {
    case FillRule::Closed:
        return "closed";
    case FillRule::HalfOpenColumn:
        return "half-open-column";
    case FillRule::TopLeft:
        return "top-left";
    case FillRule::OffScreenPoint:
        return "off-screen-point";
    case FillRule::Open:
        return "open";
    }
    return {};
}

std::string_view nameOf(Arithmetic arithmetic)
{
    switch (arithmetic) {
    case Arithmetic::Exact:
        return "exact";
    case Arithmetic::Float32:
        return "float32";
    case Arithmetic::Float64:
        return "float64";
    case Arithmetic::Fixed16:
        return "fixed16.16";
    case Arithmetic::Fixed32:
        return "fixed32.32";
    }
    return {};
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
