// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/natural.h"

#include <QString>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr int wordBits = 32;

} // namespace

Natural::Natural(std::uint64_t value)
    : m_words{std::uint32_t(value), std::uint32_t(value >> wordBits)}
{
    trim();
}

void Natural::trim()
{
    while (!m_words.empty() && m_words.back() == 0)
        m_words.pop_back();
}

std::optional<Natural> Natural::fromDigits(QStringView digits)
{
    if (digits.isEmpty())
        return std::nullopt;
    Natural number;
    for (const QChar digit : digits) {
        if (digit < u'0' || digit > u'9')
            return std::nullopt;
        auto carry = std::uint64_t(digit.unicode() - u'0');
        for (std::uint32_t &word : number.m_words) {
            carry += std::uint64_t(word) * 10;
            word = std::uint32_t(carry);
            carry >>= wordBits;
        }
        if (carry != 0)
            number.m_words.push_back(std::uint32_t(carry));
    }
    return number;
}

Natural Natural::powerOfTen(int exponent)
{
    return *fromDigits(QString(u'1') + QString(exponent, u'0'));
}

std::optional<std::uint64_t> Natural::toUint64() const
{
    if (m_words.size() > 2)
        return std::nullopt;
    std::uint64_t value = 0;
    for (std::size_t index = m_words.size(); index-- > 0;)
        value = value << wordBits | m_words[index];
    return value;
}

long double Natural::toFraction(int &exponent) const
{
    // Three words hold at least 65 significant bits: more than a long double keeps.
    const std::size_t skipped = m_words.size() > 3 ? m_words.size() - 3 : 0;
    long double value = 0;
    for (std::size_t index = m_words.size(); index-- > skipped;)
        value = std::ldexp(value, wordBits) + m_words[index];
    const long double fraction = std::frexp(value, &exponent);
    exponent += int(skipped) * wordBits;
    return fraction;
}

Natural operator+(const Natural &a, const Natural &b)
{
    Natural sum = a.m_words.size() >= b.m_words.size() ? a : b;
    const Natural &other = a.m_words.size() >= b.m_words.size() ? b : a;
    std::uint64_t carry = 0;
    for (std::size_t index = 0; index < sum.m_words.size(); ++index) {
        carry += sum.m_words[index];
        if (index < other.m_words.size())
            carry += other.m_words[index];
        sum.m_words[index] = std::uint32_t(carry);
        carry >>= wordBits;
    }
    if (carry != 0)
        sum.m_words.push_back(std::uint32_t(carry));
    return sum;
}

Natural operator*(const Natural &a, const Natural &b)
{
    Natural product;
    product.m_words.assign(a.m_words.size() + b.m_words.size(), 0);
    for (std::size_t i = 0; i < a.m_words.size(); ++i) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < b.m_words.size(); ++j) {
            carry += std::uint64_t(a.m_words[i]) * b.m_words[j] + product.m_words[i + j];
            product.m_words[i + j] = std::uint32_t(carry);
            carry >>= wordBits;
        }
        product.m_words[i + b.m_words.size()] = std::uint32_t(carry);
    }
    product.trim();
    return product;
}

Natural operator-(const Natural &a, const Natural &b)
{
    Q_ASSERT(!(a < b));
    Natural difference = a;
    std::int64_t borrow = 0;
    for (std::size_t index = 0; index < difference.m_words.size(); ++index) {
        std::int64_t word = std::int64_t(difference.m_words[index]) - borrow;
        if (index < b.m_words.size())
            word -= b.m_words[index];
        borrow = word < 0 ? 1 : 0;
        difference.m_words[index] = std::uint32_t(word);
    }
    difference.trim();
    return difference;
}

bool operator<(const Natural &a, const Natural &b)
{
    if (a.m_words.size() != b.m_words.size())
        return a.m_words.size() < b.m_words.size();
    return std::lexicographical_compare(a.m_words.rbegin(), a.m_words.rend(), b.m_words.rbegin(),
                                        b.m_words.rend());
}

std::optional<NaturalDivision> divide(const Natural &a, const Natural &b)
{
    // Long division in base two: the doublings of b that fit in a, largest first.
    constexpr int largestQuotientBits = 62;
    std::vector<Natural> doublings = {b};
    while (!(a < doublings.back())) {
        if (doublings.size() > largestQuotientBits)
            return std::nullopt;
        doublings.push_back(doublings.back() + doublings.back());
    }
    NaturalDivision division{0, a};
    for (std::size_t bit = doublings.size(); bit-- > 0;) {
        if (division.remainder < doublings[bit])
            continue;
        division.remainder = division.remainder - doublings[bit];
        division.quotient |= std::uint64_t(1) << bit;
    }
    return division;
}

} // namespace pixelplumb
