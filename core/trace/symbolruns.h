// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace pixelplumb {

/// A piece of a symbol as typeset: on the line, or as a subscript.
struct SymbolRun {
    enum class Level { Line, Subscript };

    QString text;
    Level level = Level::Line;

    friend bool operator==(const SymbolRun &, const SymbolRun &) = default;
};

/// How the symbols in a text are typeset: an underscore makes the letters and digits after it a
/// subscript, as in "⌈y_B⌉" and "x_start"; the exponent in "r_x²" stays up.
std::vector<SymbolRun> symbolRuns(const QString &text);

} // namespace pixelplumb
