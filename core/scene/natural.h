// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringView>

#include <cstdint>
#include <optional>
#include <vector>

namespace pixelplumb {

/// A natural number of any size, for coordinates whose text is longer than 128 bits. It reads and
/// compares; it never draws.
class Natural {
public:
    Natural() = default;
    explicit Natural(std::uint64_t value);
    /// Digits 0 … 9 only, as many as there are; none for an empty text and for anything else.
    static std::optional<Natural> fromDigits(QStringView digits);
    static Natural powerOfTen(int exponent);

    bool isZero() const { return m_words.empty(); }
    std::optional<std::uint64_t> toUint64() const;
    /// value = fraction * 2^exponent with fraction in [1/2, 1), to a long double's precision; 0 for
    /// zero. For reports of distances that no 128-bit rational holds.
    long double toFraction(int &exponent) const;

    friend Natural operator+(const Natural &a, const Natural &b);
    friend Natural operator*(const Natural &a, const Natural &b);
    /// a − b, for a >= b.
    friend Natural operator-(const Natural &a, const Natural &b);
    friend bool operator==(const Natural &, const Natural &) = default;
    friend bool operator<(const Natural &a, const Natural &b);

private:
    void trim();

    std::vector<std::uint32_t> m_words; ///< least significant first, no zero at the end
};

struct NaturalDivision {
    std::uint64_t quotient = 0;
    Natural remainder;
};

/// a / b for b > 0; none when the quotient does not fit 62 bits.
std::optional<NaturalDivision> divide(const Natural &a, const Natural &b);

} // namespace pixelplumb
