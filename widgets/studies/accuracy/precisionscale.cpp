// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/accuracy/precisionscale.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

using namespace Qt::StringLiterals;

QString powerOfTenText(int exponent)
{
    static const QString digits = u"⁰¹²³⁴⁵⁶⁷⁸⁹"_s;
    QString text = u"10"_s;
    for (const QChar figure : QString::number(exponent))
        text += figure == u'-' ? QChar(0x207b) : digits[figure.digitValue()];
    return text;
}

PrecisionScale::PrecisionScale(double smallest, double largest)
{
    m_largest = largest > 0 ? int(std::ceil(std::log10(largest))) : 0;
    m_least = smallest > 0 ? int(std::floor(std::log10(smallest))) - 1 : m_largest - 9;
    m_least = std::min(m_least, m_largest - 1);
}

double PrecisionScale::toAxis(double error) const
{
    const double magnitude = std::abs(error);
    const double unit = std::pow(10.0, m_least);
    const double axis = magnitude < unit ? magnitude / unit : 1 + std::log10(magnitude) - m_least;
    return std::copysign(axis, error);
}

std::vector<PrecisionScale::Tick> PrecisionScale::ticks(int perSide) const
{
    const int decades = m_largest - m_least;
    const int stride = std::max(1, (decades + perSide - 1) / perSide);
    std::vector<Tick> ticks = {{0, u"0"_s}};
    // The last tick keeps its distance from 0.
    for (int exponent = m_largest; 1 + exponent - m_least >= stride; exponent -= stride) {
        const QString label = powerOfTenText(exponent);
        const double axis = 1 + double(exponent - m_least);
        ticks.push_back({axis, label});
        ticks.push_back({-axis, QChar(0x2212) + label});
    }
    return ticks;
}

} // namespace pixelplumb
