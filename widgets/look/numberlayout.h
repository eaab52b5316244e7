// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGui>

namespace pixelplumb {

/// A display text split as a column of numbers aligns it: 17 | 3 / 8 or 17 | .375.
struct NumberParts {
    QString whole; ///< with its sign
    QString numerator, denominator; ///< of a mixed number; then decimals is empty
    QString decimals; ///< from the point on

    friend bool operator==(const NumberParts &, const NumberParts &) = default;
};

NumberParts partsOf(const QString &displayText);

/// The widths that a column of numbers reserves, so that points, slashes and units align and
/// nothing moves when a value changes. Fractions are smaller, so that 7 11/54 is not read as
/// 711/54.
class NumberLayout {
public:
    /// Makes room for a text. A numerator gets the room of its denominator, which it cannot exceed
    /// in width.
    void include(const QString &displayText, const QFont &font);
    double width() const { return m_whole + tailWidth(); }

    /// Draws the text into the rectangle, with the column right-aligned in it. Characters from
    /// `marked` on (−1: none) are underlined. Text that is not a number is right-aligned.
    void draw(QPainter &painter, const QRectF &rect, const QString &displayText, int marked) const;

private:
    double fractionWidth() const { return m_gap + m_numerator + m_slash + m_denominator; }
    double tailWidth() const;

    double m_whole = 0;
    double m_gap = 0; ///< between whole and numerator
    double m_numerator = 0;
    double m_slash = 0;
    double m_denominator = 0;
    double m_decimals = 0;
};

} // namespace pixelplumb
