// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/runs/explanation.h"
#include "tests/support/rangearithmetic.h"

#include <QString>

#include <optional>

namespace pixelplumb {

/// What a formula with its numbers put in can come out at: its numbers are known only as far as
/// they are shown ("0.333333…"), and each operation of an arithmetic that rounds may round once.
class FormulaRange {
public:
    /// Works out + − · / mod ² ^ √ ( ) ⌈ ⌉ ⌊ ⌋ (int) min( , ) max( , ) cos sin, ½ π, decimals and
    /// mixed numbers ("-17 3/8"), and "1 if 3 > 2, else 0". None where words or names are left in
    /// the text or a divisor is 0.
    static std::optional<FormulaRange> of(const QString &text, Arithmetic arithmetic);
    /// The same in numbers that wrap, as fixed-point numbers do where an operation leaves their
    /// range. What is computed in integers beside them does not.
    static std::optional<FormulaRange> wrappedOf(const QString &text, Arithmetic arithmetic);

    bool holds(const Quantity &number) const;
    /// Whether so much is known that a wrong number would be noticed: within a hundredth of it.
    bool isNarrow() const;
    QString text() const;

private:
    explicit FormulaRange(const NumberRange &range)
        : m_range(range)
    {
    }
    static std::optional<FormulaRange> workedOut(const QString &text,
                                                 const RangeArithmetic &arithmetic);

    NumberRange m_range;
};

/// What is wrong with a formula that comes out within the range, where there is one; empty where
/// nothing is.
QString formulaFault(const FormulaLine &line, const std::optional<FormulaRange> &range,
                     Arithmetic arithmetic);

} // namespace pixelplumb
