// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace pixelplumb {

/// "10⁻⁷"
QString powerOfTenText(int exponent);

/// An axis for errors of either sign over many decades with a true 0 in its middle: logarithmic
/// from 10^least on, linear between that and 0. One decade is one unit of the axis.
class PrecisionScale {
public:
    PrecisionScale() = default;
    /// From the decade below the smallest nonzero error up to that of the largest.
    PrecisionScale(double smallest, double largest);

    int leastExponent() const { return m_least; }
    int largestExponent() const { return m_largest; }
    double toAxis(double error) const;
    /// The axis length from 0 to its end.
    double extent() const { return double(m_largest - m_least) + 1; }

    struct Tick {
        double axis = 0;
        QString label; ///< "0", "10⁻⁷", "−10⁻⁷"
    };
    /// 0, and about `perSide` ticks on each side.
    std::vector<Tick> ticks(int perSide) const;

private:
    int m_least = -9;
    int m_largest = 0;
};

} // namespace pixelplumb
