// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/pareto.h"

namespace pixelplumb {

/// The error axis of the Pareto chart: logarithmic, one decade per unit. Below the decades are rows
/// for an error of 0: as observed, as tested to equal a proved kernel (where there is one), and
/// proved.
class ErrorScale {
public:
    ErrorScale() = default;
    /// Spans whole decades around the errors of class Positive; three decades around 1 where there
    /// are none.
    explicit ErrorScale(const ParetoChart &chart);

    int leastExponent() const { return m_least; }
    int largestExponent() const { return m_largest; }

    double toAxis(ErrorClass errorClass, double error) const;
    /// The class and the error at a place on the axis: the nearest row, or the error.
    ErrorClass classAt(double axis) const;
    double errorAt(double axis) const; ///< 0 in the rows

    /// The axis' ends.
    static constexpr double bottom = -1;
    double top() const { return double(m_largest - m_least) + decades() + 0.25; }
    /// The line between the rows and the decades.
    double separator() const { return observedRow() + 1; }

    struct Tick {
        double axis = 0;
        QString label; ///< "10⁻³", "0, observed", "0, proved"
    };
    /// The rows, and at most about `most` decades.
    std::vector<Tick> ticks(int most) const;

private:
    static constexpr double provedRow = 0;
    static constexpr double betweenRows = 1.5;
    double testedRow() const { return m_hasTested ? provedRow + betweenRows : provedRow; }
    double observedRow() const { return testedRow() + betweenRows; }
    double decades() const { return separator() + 0.5; } ///< where 10^least is

    int m_least = -1;
    int m_largest = 2;
    bool m_hasTested = false;
};

} // namespace pixelplumb
