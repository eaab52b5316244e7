// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/wideinteger.h"
#include "core/scan/scansettings.h"

#include <QStringList>

#include <map>
#include <stdexcept>

/// The words and expressions of listings that the tests run.
namespace pixelplumb {

using namespace Qt::StringLiterals;

/// Between a name and its new value.
inline const QString assigns = u" ← "_s;

/// A line of pseudocode that cannot be read, or that uses a name without a value.
struct ListingFault : std::runtime_error {
    explicit ListingFault(const QString &what)
        : std::runtime_error(what.toStdString())
    {
    }
};

/// The current values of the names.
using ListingNames = std::map<QString, BigRational>;

/// Whether a character goes on with a name.
bool belongsToName(QChar character);

/// Splits "A ← B; C and D likewise" into three statements; conditions likewise. "likewise" advances
/// ₀ ₁ ₂, bc ca ab, a b c, A B C and α β γ by one, or R G B; of a coordinate along an edge, y₀₂ and
/// m₀₂, it makes R₀₂ and δR₀₂. "each carried value likewise" stands for all of `carried`.
QStringList spelledOut(const QString &text, const QStringList &carried = {});

/// The parts of "A, B" that commas divide outside of brackets: "max(A, B), C" has two.
QStringList listed(const QString &text);

/// The value of an expression of + − · / mod ( ), ⌊ ⌋, ⌈ ⌉, | |, √, ², cos, sin, max(A, B), min(A,
/// B), (int)( ), whole numbers, ½, ¼ and names; 2Δy is 2·Δy. In float32 and float64 each operation
/// rounds its result.
BigRational valueOf(const QString &expression, const ListingNames &names, Arithmetic arithmetic);

/// Whether a condition holds: "A > 0, or A = 0 and B > 0; C and D likewise", "0 ≤ A ≤ 1",
/// "A = 1 by even-odd, or B ≠ 0 by non-zero", where the name after "by" has a value if it is asked.
bool holds(const QString &condition, const ListingNames &names, Arithmetic arithmetic);

} // namespace pixelplumb
