// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/workstage.h"

#include <QtGlobal>

#include <array>
#include <cstdint>
#include <string_view>

namespace pixelplumb {

/// The kinds of operations of a résumé (Rasterization slides, "Résumé": "Division, Round, Floating
/// point operation"). A subtraction counts as an addition; a change of sign does not count; a
/// remainder belongs to its quotient's division.
enum class Operation : std::uint8_t {
    Division,
    Rounding, ///< floor, ceil or nearest of a number that rounds, to an integer, its half included
    FloatAddition,
    IntegerAddition, ///< fixed point included
    Multiplication,
    Comparison,
    Conversion, ///< of an integer or a lattice coordinate to a number that rounds, or back
    Function, ///< a root, a sine or a cosine
};

inline constexpr std::array allOperations
    = {Operation::Division,        Operation::Rounding,       Operation::FloatAddition,
       Operation::IntegerAddition, Operation::Multiplication, Operation::Comparison,
       Operation::Conversion,      Operation::Function};
inline constexpr std::array allWorkStages = {WorkStage::SetUp, WorkStage::Span, WorkStage::Pixel};

/// The names in tables and files: "divisions", "float additions", …
constexpr std::string_view nameOf(Operation operation)
{
    switch (operation) {
    case Operation::Division:
        return QT_TRANSLATE_NOOP("core", "divisions");
    case Operation::Rounding:
        return QT_TRANSLATE_NOOP("core", "roundings");
    case Operation::FloatAddition:
        return QT_TRANSLATE_NOOP("core", "float additions");
    case Operation::IntegerAddition:
        return QT_TRANSLATE_NOOP("core", "integer additions");
    case Operation::Multiplication:
        return QT_TRANSLATE_NOOP("core", "multiplications");
    case Operation::Comparison:
        return QT_TRANSLATE_NOOP("core", "comparisons");
    case Operation::Conversion:
        return QT_TRANSLATE_NOOP("core", "conversions");
    case Operation::Function:
        return QT_TRANSLATE_NOOP("core", "functions");
    }
    return {};
}

/// "set-up", "span", "pixel"
constexpr std::string_view nameOf(WorkStage stage)
{
    switch (stage) {
    case WorkStage::SetUp:
        return "set-up";
    case WorkStage::Span:
        return "span";
    case WorkStage::Pixel:
        return "pixel";
    }
    return {};
}

} // namespace pixelplumb
