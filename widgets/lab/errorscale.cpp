// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/errorscale.h"

#include "widgets/studies/precisionscale.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

ErrorScale::ErrorScale(const ParetoChart &chart)
{
    std::vector<ParetoPoint> points = chart.points;
    points.insert(points.end(), chart.untimed.begin(), chart.untimed.end());
    m_hasTested = std::ranges::find(points, ErrorClass::ZeroTested, &ParetoPoint::errorClass)
        != points.end();
    double smallest = 0;
    double largest = 0;
    for (const ParetoPoint &point : points) {
        if (point.errorClass != ErrorClass::Positive || !std::isfinite(point.error))
            continue;
        smallest = smallest > 0 ? std::min(smallest, point.error) : point.error;
        largest = std::max(largest, point.error);
    }
    if (smallest <= 0)
        return;
    m_least = int(std::floor(std::log10(smallest)));
    m_largest = std::max(int(std::ceil(std::log10(largest))), m_least + 1);
}

double ErrorScale::toAxis(ErrorClass errorClass, double error) const
{
    switch (errorClass) {
    case ErrorClass::ZeroProved:
        return provedRow;
    case ErrorClass::ZeroTested:
        return testedRow();
    case ErrorClass::ZeroObserved:
        return observedRow();
    case ErrorClass::Positive:
        break;
    }
    // An infinite error is at the upper end.
    return std::min(decades() + std::log10(error) - m_least, top());
}

ErrorClass ErrorScale::classAt(double axis) const
{
    if (axis >= separator())
        return ErrorClass::Positive;
    if (axis >= observedRow() - betweenRows / 2)
        return ErrorClass::ZeroObserved;
    return m_hasTested && axis >= testedRow() - betweenRows / 2 ? ErrorClass::ZeroTested
                                                                : ErrorClass::ZeroProved;
}

double ErrorScale::errorAt(double axis) const
{
    return classAt(axis) == ErrorClass::Positive ? std::pow(10.0, axis - decades() + m_least) : 0;
}

std::vector<ErrorScale::Tick> ErrorScale::ticks(int most) const
{
    std::vector<Tick> ticks
        = {{provedRow, QCoreApplication::translate("pixelplumb::ErrorScale", "0, proved")},
           {observedRow(), QCoreApplication::translate("pixelplumb::ErrorScale", "0, observed")}};
    if (m_hasTested)
        ticks.push_back(
            {testedRow(), QCoreApplication::translate("pixelplumb::ErrorScale", "0, tested")});
    const int stride = std::max(1, (m_largest - m_least + most) / std::max(1, most));
    for (int exponent = m_largest; exponent >= m_least; exponent -= stride)
        ticks.push_back({decades() + exponent - m_least, powerOfTenText(exponent)});
    return ticks;
}

} // namespace pixelplumb
