// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/wideinteger.h"

#include <QStringList>

#include <map>
#include <stdexcept>

/// The words and expressions of listings that are run.
namespace pixelplumb {

/// A line of pseudocode that cannot be read, or a name in it that has no value yet.
struct ListingFault : std::runtime_error {
    explicit ListingFault(const QString &what)
        : std::runtime_error(what.toStdString())
    {
    }
};

/// What names stand for so far.
using ListingNames = std::map<QString, BigRational>;

/// "A ← B; C and D likewise" as three statements, conditions in the same way. "likewise" turns
/// ₀ ₁ ₂, bc ca ab, a b c and α β γ by one, or R G B.
QStringList spelledOut(const QString &text);

/// The value of an expression of + − · / ( ), whole numbers and names.
BigRational valueOf(const QString &expression, const ListingNames &names);

} // namespace pixelplumb
