// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/rangearithmetic.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace pixelplumb {

namespace {

/// Twice the arithmetic's promised error, which also covers numbers shown as the shortest decimal
/// that reads back the same. The rounding of long double itself is added to all.
RangeArithmetic::RoundingStep roundingOf(Arithmetic arithmetic)
{
    constexpr long double own = NumberRange::ownRounding;
    switch (arithmetic) {
    case Arithmetic::Exact:
        return {own, 0};
    case Arithmetic::Float32:
        return {0x1p-23L, 0x1p-148L};
    case Arithmetic::Float64:
        return {0x1p-52L, 0};
    case Arithmetic::Fixed16:
        return {own, 0x1p-16L};
    case Arithmetic::Fixed32:
        return {own, 0x1p-32L};
    }
    return {};
}

/// The distance between two numbers that wrap to the same fixed-point number; 0 if numbers do not
/// wrap.
long double periodOf(Arithmetic arithmetic)
{
    if (arithmetic == Arithmetic::Fixed16)
        return 0x1p16L;
    return arithmetic == Arithmetic::Fixed32 ? 0x1p32L : 0;
}

/// The range of an operation's results on the ends of two ranges.
template <class Operation>
NumberRange hullOf(const NumberRange &a, const NumberRange &b, const Operation &operation)
{
    const auto [least, greatest]
        = std::minmax({operation(a.least, b.least), operation(a.least, b.greatest),
                       operation(a.greatest, b.least), operation(a.greatest, b.greatest)});
    return {least, greatest};
}

} // namespace

RangeArithmetic::RangeArithmetic(Arithmetic arithmetic, Overflow overflow)
    : m_step(roundingOf(arithmetic))
    , m_period(overflow == Overflow::Wraps ? periodOf(arithmetic) : 0)
{
}

NumberRange RangeArithmetic::unknown()
{
    constexpr long double infinity = std::numeric_limits<long double>::infinity();
    return {-infinity, infinity};
}

NumberRange RangeArithmetic::sum(const NumberRange &a, const NumberRange &b) const
{
    const NumberRange all = {a.least + b.least, a.greatest + b.greatest};
    const bool isWhole = all.least == all.greatest && std::floor(all.least) == all.least
        && std::abs(all.least) < 0x1p62L && !rounds();
    return isWhole || m_step.absolute > NumberRange::ownRounding ? wrapped(all) : rounded(all);
}

NumberRange RangeArithmetic::wrapped(const NumberRange &range) const
{
    if (m_period == 0 || !range.isFinite())
        return range;
    const long double turns = std::floor((range.least + range.greatest) / 2 / m_period + 0.5L);
    return {range.least - turns * m_period, range.greatest - turns * m_period};
}

NumberRange RangeArithmetic::rounded(const NumberRange &range) const
{
    if (!range.isFinite())
        return unknown();
    const long double slack = m_step.absolute
        + m_step.relative * std::max(std::abs(range.least), std::abs(range.greatest));
    return {range.least - slack, range.greatest + slack};
}

NumberRange RangeArithmetic::product(const NumberRange &a, const NumberRange &b) const
{
    return wrapped(rounded(hullOf(a, b, std::multiplies<long double>())));
}

std::optional<NumberRange> RangeArithmetic::quotient(const NumberRange &a,
                                                     const NumberRange &b) const
{
    if (b.least == 0 && b.greatest == 0)
        return std::nullopt;
    if (b.least <= 0 && b.greatest >= 0)
        return unknown();
    return wrapped(rounded(hullOf(a, b, std::divides<long double>())));
}

std::optional<NumberRange> RangeArithmetic::remainder(const NumberRange &a, const NumberRange &b)
{
    const long double divisor = std::round(b.least);
    if (divisor == 0)
        return std::nullopt;
    const long double rest = std::fmod(std::round(a.least), divisor);
    return NumberRange{rest, rest};
}

NumberRange RangeArithmetic::root(const NumberRange &range) const
{
    return rounded(
        {std::sqrt(std::max(range.least, 0.0L)), std::sqrt(std::max(range.greatest, 0.0L))});
}

NumberRange RangeArithmetic::power(const NumberRange &base, int exponent) const
{
    NumberRange result = {1, 1};
    for (int i = 0; i < exponent; ++i)
        result = product(result, base);
    if (std::abs(result.least) < std::numeric_limits<double>::min())
        result.least = std::min(result.least, 0.0L);
    return result;
}

NumberRange RangeArithmetic::turned(const NumberRange &angle,
                                    long double (*function)(long double)) const
{
    const long double middle = function((angle.least + angle.greatest) / 2);
    const long double reach = (angle.greatest - angle.least) / 2;
    return rounded({middle - reach, middle + reach});
}

NumberRange RangeArithmetic::shown(const NumberRange &seen) const
{
    return rounds() ? rounded(seen) : seen;
}

bool NumberRange::isFinite() const { return std::isfinite(least) && std::isfinite(greatest); }

} // namespace pixelplumb
