// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/text/colourtext.h"

#include "core/scene/text/shortened.h"

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

QString byteText(std::uint8_t byte) { return u"%1"_s.arg(int(byte), 2, 16, QChar(u'0')); }

} // namespace

Result<BlendedColour> parseColour(QStringView text)
{
    const bool isColour = text.startsWith(u'#') && (text.size() == 7 || text.size() == 9)
        && isHexadecimal(text.sliced(1));
    if (!isColour) {
        return InputError{{},
                          u"“%1” is no colour"_s.arg(shortened(text.toString())),
                          "#rrggbb or #rrggbbaa in hexadecimal digits"};
    }
    const auto byte = [text](std::size_t index) {
        return std::uint8_t(text.sliced(1 + 2 * qsizetype(index), 2).toInt(nullptr, 16));
    };
    BlendedColour colour;
    for (std::size_t channel = 0; channel < 3; ++channel)
        colour.colour.channels[channel] = byte(channel);
    if (text.size() == 9)
        colour.alpha = byte(3);
    return colour;
}

QString colourText(const Colour &colour)
{
    QString text = "#";
    for (const std::uint8_t channel : colour.channels)
        text += byteText(channel);
    return text;
}

QString colourText(const BlendedColour &colour)
{
    const QString text = colourText(colour.colour);
    return colour.alpha == 255 ? text : text + byteText(colour.alpha);
}

} // namespace pixelplumb
