// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listings/listingstate.h"

#include <QRegularExpression>

#include <algorithm>

namespace pixelplumb {

namespace {

/// A pixel's coordinate.
std::int64_t whole(const BigRational &value, const QString &place)
{
    if (denominator(value) != 1)
        throw ListingFault(u"is no pixel: "_s + place);
    return numerator(value).convert_to<std::int64_t>();
}

} // namespace

/// The nearest byte.
ListingState::Number ListingState::byteOf(const QString &level) const
{
    const Number nearest
        = pixelplumb::valueOf(u"⌊R + ½⌋"_s, {{u"R"_s, valueOf(level)}}, m_arithmetic);
    return std::clamp(nearest, Number(0), Number(255));
}

QRgb ListingState::pixelAt(const QString &place) const
{
    const auto at = std::pair(whole(valueOf(place.section(u", "_s, 0, 0)), place),
                              whole(valueOf(place.section(u", "_s, 1)), place));
    const auto drawn = m_pixels.find(at);
    return drawn != m_pixels.end() ? drawn->second : m_under.at(at);
}

/// ⌊(R₁ + … + Rₙ)/n + ½⌋
QRgb ListingState::meanAt(const QString &place) const
{
    const auto mean = [&](const QString &channel) {
        Number sum = 0;
        const Number count = valueOf(u"n"_s);
        for (int k = 1; k <= count; ++k)
            sum += m_names.at(u"%1[%2,%3,%4]"_s.arg(channel).arg(k).arg(
                QString::fromStdString(valueOf(place.section(u", "_s, 0, 0)).str()),
                QString::fromStdString(valueOf(place.section(u", "_s, 1)).str())));
        const Number level = sum / count;
        return pixelplumb::valueOf(u"⌊R + ½⌋"_s, {{u"R"_s, level}}, Arithmetic::Exact)
            .convert_to<int>();
    };
    return qRgb(mean(u"R"_s), mean(u"G"_s), mean(u"B"_s));
}

void ListingState::draw(const QString &statement)
{
    if (statement.endsWith(u") ← the mean of its samples"_s)) {
        const QString place = statement.section(u" ("_s, 1).section(u") ← "_s, 0, 0);
        write(place, meanAt(place));
        return;
    }
    static const QRegularExpression pixel(
        u"^(?:pixel \\((.+)\\)|frame\\[(.+)\\]) ← (?:the bytes of (.+), (.+), (.+)|colour)$"_s);
    const auto match = pixel.match(statement);
    if (!match.hasMatch())
        throw ListingFault(u"draws nothing: "_s + statement);
    const auto byte = [&](int part, const char *channel) {
        const QString named = match.captured(part);
        return byteOf(named.isEmpty() ? u"colour "_s + QLatin1String(channel) : named)
            .convert_to<int>();
    };
    const QRgb colour = qRgb(byte(3, "R"), byte(4, "G"), byte(5, "B"));
    const QString address = match.captured(2);
    write(address.isEmpty() ? match.captured(1)
                            : u"x₀ + %1 mod width, y₀ + ⌊%1/width⌋"_s.arg(address),
          colour);
}

/// Writes both pixels of "x ± 1".
void ListingState::write(const QString &place, QRgb colour)
{
    const qsizetype both = place.indexOf(u'±');
    if (both >= 0) {
        for (const QChar sign : {u'+', u'−'})
            write(QString(place).replace(both, 1, sign), colour);
        return;
    }
    std::int64_t x = whole(valueOf(place.section(u", "_s, 0, 0)), place);
    std::int64_t y = whole(valueOf(place.section(u", "_s, 1, 1)), place);
    if (m_exchange == Exchange::Axes)
        std::swap(x, y);
    if (x >= m_box.firstX && x < m_box.endX && y >= m_box.firstY && y < m_box.endY) {
        m_pixels[{x, y}] = colour;
        m_written = {x, y};
    }
}

} // namespace pixelplumb
