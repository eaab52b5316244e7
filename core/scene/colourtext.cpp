// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/colourtext.h"

namespace pixelplumb {

namespace {

bool isHexadecimal(QStringView digits)
{
    for (const QChar digit : digits) {
        const QChar lower = digit.toLower();
        if (!((lower >= u'0' && lower <= u'9') || (lower >= u'a' && lower <= u'f')))
            return false;
    }
    return true;
}

} // namespace

Result<Colour> parseColour(QStringView text)
{
    const bool isColour = text.startsWith(u'#') && (text.size() == 7 || text.size() == 9)
        && isHexadecimal(text.sliced(1));
    if (!isColour) {
        return InputError{{},
                          QStringLiteral("“%1” is no colour").arg(text.left(60)),
                          QStringLiteral("#rrggbb in hexadecimal digits")};
    }
    if (text.size() == 9 && text.sliced(7).toInt(nullptr, 16) != 255) {
        return InputError{
            {},
            QStringLiteral("“%1” is not opaque, and blending is not available").arg(text),
            QStringLiteral("alpha ff, or #rrggbb without alpha")};
    }
    Colour colour;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const QStringView digits = text.sliced(1 + 2 * qsizetype(channel), 2);
        colour.channels[channel] = std::uint8_t(digits.toInt(nullptr, 16));
    }
    return colour;
}

QString colourText(const Colour &colour)
{
    QString text = QStringLiteral("#");
    for (const std::uint8_t channel : colour.channels)
        text += QStringLiteral("%1").arg(int(channel), 2, 16, QChar(u'0'));
    return text;
}

} // namespace pixelplumb
