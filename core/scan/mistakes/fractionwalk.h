// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/fraction.h"
#include "core/number/mixednumber.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/scanbugs.h"

#include <type_traits>

/// What a program's walk computes in when it is exact: fractions, which no mistake makes too wide.
namespace pixelplumb {

template <>
struct NumberTraits<Fraction> {
    static constexpr Arithmetic arithmetic = Arithmetic::Exact;

    /// Fractions hold all, but nothing is walked so far.
    static bool represents(Lattice units) { return isNarrow(LatticePoint{units, units}); }
    static Fraction fromInteger(std::int64_t integer) { return integer; }
    static Fraction fromLattice(Lattice units) { return {units, unitsPerPixel}; }
    static std::int64_t floor(const Fraction &value) { return value.floor(); }
    static std::int64_t ceil(const Fraction &value) { return value.ceil(); }
};

/// The fraction as the column scan has it; one that 128 bits do not hold, to 2^−62.
inline MixedNumber<Int128> mixedNumber(const Fraction &value)
{
    const std::int64_t whole = value.floor();
    const Fraction rest = value - whole;
    if (rest.isNarrow())
        return {whole, rest.above(), rest.below()};
    constexpr Int128 unit = Int128(1) << 62;
    return {whole, Int128((rest * Fraction(unit, 1)).floor()), unit};
}

template <class Value>
void stepBy(Value &value, const Value &step)
{
    if constexpr (std::is_same_v<Value, Fraction>)
        value += step;
    else
        RoundedArithmetic<Value>::advance(value, step);
}
template <class Value>
std::int64_t wholeLevel(const Value &value, ByteRounding rounding)
{
    if constexpr (std::is_same_v<Value, Fraction>)
        return rounding == ByteRounding::Nearest ? value.nearest() : value.floor();
    else
        return RoundedArithmetic<Value>::level(value, rounding);
}

/// (int)quotient.
template <class Value>
Value cast(const Value &quotient)
{
    return NumberTraits<Value>::fromInteger(quotient < NumberTraits<Value>::fromInteger(0)
                                                ? RoundedArithmetic<Value>::ceil(quotient)
                                                : RoundedArithmetic<Value>::floor(quotient));
}

/// What is kept of a number.
template <class Value>
Value leftOf(const Value &value, Truncation kept)
{
    if (kept == Truncation::Down)
        return NumberTraits<Value>::fromInteger(RoundedArithmetic<Value>::floor(value));
    if (kept == Truncation::Nearest)
        return NumberTraits<Value>::fromInteger(wholeLevel(value, ByteRounding::Nearest));
    return kept == Truncation::TowardZero ? cast(value) : value;
}

/// The steps of a value of which a whole number is kept at each, in integers: each adds the same,
/// but toward 0 a step that is no whole number adds one more below 0.
class WholeSteps {
public:
    WholeSteps(const Fraction &step, Truncation kept)
        : m_step(kept == Truncation::Nearest ? step.nearest() : step.floor())
        , m_moreBelowZero(kept == Truncation::TowardZero && !(step == Fraction(m_step)))
    {
    }
    Int128 after(Int128 whole) const
    {
        const Int128 next = whole + m_step;
        return next < 0 ? next + m_moreBelowZero : next;
    }

private:
    std::int64_t m_step, m_moreBelowZero;
};

/// Whole levels at samples one after another, ⌊level⌋, ⌊level + step⌋ …: quotient and remainder are
/// stepped separately, without a division at each sample.
template <class Store>
void storeFloors(const Fraction &level, const Fraction &step, std::size_t samples,
                 const Store &store)
{
    std::int64_t whole = level.floor();
    const std::int64_t wholeStep = step.floor();
    const auto add = [&]<class Integer>(Integer at, const Integer &by, const Integer &over) {
        for (std::size_t i = 0; i < samples; ++i) {
            store(i, whole);
            whole += wholeStep;
            at += by;
            if (at >= over) {
                ++whole;
                at -= over;
            }
        }
    };
    const Fraction rest = level - whole;
    const Fraction restStep = step - wholeStep;
    if (const auto common = overOneDenominator(rest, restStep);
        common && common->first.below() < Int128(1) << 126) {
        const Int128 below = common->first.below();
        if (below < Int128(1) << 62)
            add(std::int64_t(common->first.above()), std::int64_t(common->second.above()),
                std::int64_t(below));
        else
            add(common->first.above(), common->second.above(), below);
        return;
    }
    const BigRational at = rest.wide();
    const BigRational by = restStep.wide();
    const BigInteger over = lcm(denominator(at), denominator(by));
    add(BigInteger(numerator(at) * (over / denominator(at))),
        BigInteger(numerator(by) * (over / denominator(by))), over);
}

/// What is kept of values one after another, as whole numbers; not all of them.
template <class Store>
void storeWhole(const Fraction &value, const Fraction &step, Truncation kept, std::size_t samples,
                const Store &store)
{
    storeFloors(kept == Truncation::Nearest ? value + Fraction(1, 2) : value, step, samples, store);
    if (kept != Truncation::TowardZero)
        return;
    storeFloors(-value, -step, samples, [&](std::size_t i, std::int64_t whole) {
        if (whole >= 0)
            store(i, -whole);
    });
}

} // namespace pixelplumb
