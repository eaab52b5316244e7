// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/pngfault.h"

#include <QtEndian>

#include <boost/crc.hpp>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr qsizetype signatureSize = 8;
constexpr qsizetype frameOfChunk = 12; // length, type and checksum

/// The cyclic redundancy check of ISO/IEC 15948, annex D.
std::uint32_t checksumOf(QByteArrayView bytes)
{
    boost::crc_32_type check;
    check.process_bytes(bytes.data(), std::size_t(bytes.size()));
    return check.checksum();
}

/// Critical chunks have a capital first: bit 5 is not set.
bool isCritical(QByteArrayView type) { return (std::uint8_t(type.front()) & 0x20U) == 0; }

/// A damaged file may have anything for a type.
QString typeText(QByteArrayView type)
{
    const bool isName = std::ranges::all_of(type, [](char letter) {
        return (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z');
    });
    return isName ? QString::fromLatin1(type) : QStringLiteral("a chunk");
}

} // namespace

QString pngFault(const QByteArray &content)
{
    if (!content.startsWith("\x89PNG\r\n\x1a\n"))
        return {};
    for (qsizetype at = signatureSize;;) {
        const qsizetype left = content.size() - at;
        if (left < frameOfChunk)
            return QStringLiteral("a PNG that ends early, at byte %1").arg(content.size());
        const auto length = qFromBigEndian<quint32>(content.constData() + at);
        const QByteArrayView type = QByteArrayView(content).sliced(at + 4, 4);
        if (length > quint64(left - frameOfChunk))
            return QStringLiteral("a PNG that ends early, in %1 at byte %2")
                .arg(typeText(type))
                .arg(at);
        const QByteArrayView checked
            = QByteArrayView(content).sliced(at + 4, 4 + qsizetype(length));
        const auto checksum
            = qFromBigEndian<quint32>(content.constData() + at + 8 + qsizetype(length));
        if (isCritical(type) && checksumOf(checked) != checksum)
            return QStringLiteral("a broken PNG: the checksum of %1 at byte %2 is wrong")
                .arg(typeText(type))
                .arg(at);
        if (type == "IEND")
            return {};
        at += frameOfChunk + qsizetype(length);
    }
}

} // namespace pixelplumb
