// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/runs/explain/explanation.h"
#include "tests/support/rangearithmetic.h"

#include <QString>

#include <optional>

namespace pixelplumb {

/// The range of results of a formula with its numbers put in: the numbers are known only to the
/// digits shown ("0.333333…"), and every operation of a rounding arithmetic may round once.
class FormulaRange {
public:
    /// Works out + − · / mod ² ^ √ ( ) ⌈ ⌉ ⌊ ⌋ (int) min( , ) max( , ) cos sin, ½ π, decimals and
    /// mixed numbers ("-17 3/8"), and "1 if 3 > 2, else 0". None if words or names remain in the
    /// text or a divisor is 0.
    static std::optional<FormulaRange> of(const QString &text, Arithmetic arithmetic);
    /// Like of(), but in numbers that wrap, as fixed-point numbers do when an operation leaves
    /// their range. Parts computed in integers do not wrap.
    static std::optional<FormulaRange> wrappedOf(const QString &text, Arithmetic arithmetic);

    bool holds(const Quantity &number) const;
    /// Whether the range is narrow enough, within a hundredth, that a wrong number would be
    /// noticed.
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

/// What is wrong with a formula whose result should lie in the range; empty if nothing is.
QString formulaFault(const FormulaLine &line, const std::optional<FormulaRange> &range,
                     Arithmetic arithmetic);

} // namespace pixelplumb
