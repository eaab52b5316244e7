// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/meshtext.h"

#include "core/scene/text/byteordermark.h"

namespace pixelplumb {

bool isCorner(QByteArrayView word)
{
    constexpr qsizetype mostDigits = 9;
    qsizetype parts = 1;
    qsizetype digits = 0;
    for (const char character : word) {
        if (character == '/') {
            ++parts;
            digits = 0;
        } else if (character >= '0' && character <= '9') {
            ++digits;
        } else if (character != '-' || digits > 0) {
            return false;
        }
        if (digits > mostDigits || parts > 3)
            return false;
    }
    return !word.startsWith('/') && !word.endsWith('/');
}

QByteArray withoutRemarks(const QByteArray &text)
{
    QByteArray plain;
    plain.reserve(text.size());
    qsizetype place = text.startsWith(byteOrderMark) ? byteOrderMark.size() : 0;
    qsizetype joined = 0;
    bool isRemark = false;
    for (; place < text.size(); ++place) {
        const char character = text[place];
        const bool goesOn = character == '\\' && !isRemark
            && (text.sliced(place + 1, qMin<qsizetype>(2, text.size() - place - 1)) == "\r\n"
                || (place + 1 < text.size() && text[place + 1] == '\n'));
        if (goesOn) {
            place += text[place + 1] == '\r' ? 2 : 1;
            plain += ' ';
            ++joined;
        } else if (character == '\n') {
            plain += QByteArray(joined + 1, '\n');
            joined = 0;
            isRemark = false;
        } else {
            isRemark = isRemark || character == '#';
            if (!isRemark)
                plain += character;
        }
    }
    return plain;
}

} // namespace pixelplumb
