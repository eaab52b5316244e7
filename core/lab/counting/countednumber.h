// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/counting/operationtally.h"
#include "core/number/commonfraction.h"
#include "core/number/companiontypes.h"
#include "core/number/mixednumber.h"
#include "core/number/widerinteger.h"

#include <cmath>
#include <compare>

namespace pixelplumb {

template <class T>
concept PlainInteger = std::integral<T> || std::same_as<T, Int128> || std::same_as<T, Int256>;

/// A number that computes like a T and reports each operation to the tally. Kernels are templates
/// over their numbers: with this one they draw the same picture and count.
template <class T>
class Counted {
public:
    using Plain = T;

    constexpr Counted() = default;
    constexpr Counted(const T &value)
        : m_value(value)
    {
    }
    /// An integer. Up to the size of an int it is a constant of the kernel; a longer one that
    /// becomes a float is a conversion.
    template <PlainInteger Integer>
    requires(!std::same_as<Integer, T>) constexpr Counted(const Integer &value)
        : m_value(static_cast<T>(value))
    {
        if (std::floating_point<T> && sizeof(Integer) > sizeof(int))
            OperationTally::count(Operation::Conversion);
    }
    /// A constant of the kernel.
    constexpr Counted(double value) requires std::same_as<T, float> : m_value(float(value)) { }
    /// Between integers this costs nothing; to a float it is a conversion.
    template <class From>
    requires(!std::same_as<From, T>) constexpr explicit(
        PlainInteger<T> != PlainInteger<From> || sizeof(From) > sizeof(T))
        Counted(const Counted<From> &from)
        : m_value(static_cast<T>(from.plain()))
    {
        if (std::floating_point<T> && PlainInteger<From>)
            OperationTally::count(Operation::Conversion);
    }

    constexpr const T &plain() const { return m_value; }
    template <PlainInteger Integer>
    constexpr explicit operator Integer() const
    {
        if (std::floating_point<T>)
            OperationTally::count(Operation::Conversion);
        return static_cast<Integer>(m_value);
    }

    friend constexpr Counted operator+(const Counted &a, const Counted &b)
    {
        OperationTally::count(addition);
        return static_cast<T>(a.m_value + b.m_value);
    }
    friend constexpr Counted operator-(const Counted &a, const Counted &b)
    {
        OperationTally::count(addition);
        return static_cast<T>(a.m_value - b.m_value);
    }
    friend constexpr Counted operator*(const Counted &a, const Counted &b)
    {
        OperationTally::count(Operation::Multiplication);
        return static_cast<T>(a.m_value * b.m_value);
    }
    friend constexpr Counted operator/(const Counted &a, const Counted &b)
    {
        OperationTally::count(Operation::Division);
        return static_cast<T>(a.m_value / b.m_value);
    }
    /// Counted with its quotient's division.
    friend constexpr Counted operator%(const Counted &a, const Counted &b)
    {
        return static_cast<T>(a.m_value % b.m_value);
    }
    constexpr Counted operator-() const { return static_cast<T>(-m_value); }
    constexpr Counted &operator+=(const Counted &other) { return *this = *this + other; }
    constexpr Counted &operator-=(const Counted &other) { return *this = *this - other; }
    constexpr Counted &operator++() { return *this += Counted(T(1)); }

    friend constexpr bool operator==(const Counted &a, const Counted &b)
    {
        OperationTally::count(Operation::Comparison);
        return a.m_value == b.m_value;
    }
    friend constexpr auto operator<=>(const Counted &a, const Counted &b)
    {
        OperationTally::count(Operation::Comparison);
        if constexpr (std::same_as<T, Int256>)
            return a.m_value.compare(b.m_value) <=> 0;
        else
            return a.m_value <=> b.m_value;
    }

    friend Counted sqrt(const Counted &a) { return function(std::sqrt(a.m_value)); }
    friend Counted sin(const Counted &a) { return function(std::sin(a.m_value)); }
    friend Counted cos(const Counted &a) { return function(std::cos(a.m_value)); }

private:
    static constexpr Operation addition
        = std::floating_point<T> ? Operation::FloatAddition : Operation::IntegerAddition;

    static Counted function(T value)
    {
        OperationTally::count(Operation::Function);
        return value;
    }

    T m_value = {};
};

template <std::floating_point Float>
inline constexpr bool isFloatingNumber<Counted<Float>> = true;

template <class T>
struct CompanionTypes<Counted<T>> {
    using Narrow = Counted<std::int64_t>;
    using Wide = Counted<Int128>;
    using Real = Counted<double>;
};
template <class T>
struct CompanionTypes<MixedNumber<Counted<T>>> : CompanionTypes<Counted<T>> {
};
template <class T>
struct CompanionTypes<FractionOf<Counted<T>>> : CompanionTypes<Counted<T>> {
};
template <>
struct WiderInteger<Counted<Int128>> {
    using Type = Counted<Int256>;
};

} // namespace pixelplumb
