// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QChar>
#include <QRgb>

#include <array>
#include <compare>
#include <cstdint>

namespace pixelplumb {

/// Red, green and blue, 0 … 255 each, interpolated as plain numbers (Assignment (Borst),
/// "Smoothly shading the triangle").
struct Colour {
    std::array<std::uint8_t, 3> channels = {0, 0, 0};

    constexpr std::uint8_t red() const { return channels[0]; }
    constexpr std::uint8_t green() const { return channels[1]; }
    constexpr std::uint8_t blue() const { return channels[2]; }

    friend constexpr auto operator<=>(const Colour &, const Colour &) = default;
};

/// The channels' names in tables, formulas and exports.
inline constexpr std::array<QChar, 3> channelLetters = {u'R', u'G', u'B'};

constexpr QRgb packed(const Colour &colour)
{
    return qRgb(colour.red(), colour.green(), colour.blue());
}

constexpr Colour unpacked(QRgb pixel)
{
    return {{std::uint8_t(qRed(pixel)), std::uint8_t(qGreen(pixel)), std::uint8_t(qBlue(pixel))}};
}

} // namespace pixelplumb
