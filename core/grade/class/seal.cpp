// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/seal.h"

#include "core/grade/showntext.h"

#include <QCryptographicHash>
#include <QJsonDocument>

namespace pixelplumb {

namespace {

constexpr qsizetype sealLength = 64; // hexadecimal digits of SHA-256

/// Stands in for the seal while it is computed.
const QByteArray &blank()
{
    static const QByteArray zeros(sealLength, '0');
    return zeros;
}

/// The offset of the first seal's digits; -1: there is none.
qsizetype placeOfSeal(const QByteArray &text)
{
    const QByteArray key = '"' + sealKey.toLatin1() + "\": \"";
    const qsizetype found = text.indexOf(key);
    const qsizetype place = found + key.size();
    return found < 0 || place + sealLength > text.size() ? -1 : place;
}

QByteArray sealOf(const QByteArray &blanked, const QByteArray &about)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(QByteArray::number(about.size()) + '\n' + about);
    hash.addData(blanked);
    return hash.result().toHex();
}

} // namespace

QByteArray sealed(QJsonObject object, const QByteArray &about)
{
    object.insert(sealKey, QString::fromLatin1(blank()));
    const QByteArray blanked = escapedJson(QJsonDocument(object).toJson());
    return QByteArray(blanked).replace(placeOfSeal(blanked), sealLength, sealOf(blanked, about));
}

bool isSealed(const QByteArray &text, const QByteArray &about)
{
    const qsizetype place = placeOfSeal(text);
    if (place < 0)
        return false;
    const QByteArray blanked = QByteArray(text).replace(place, sealLength, blank());
    return text.mid(place, sealLength) == sealOf(blanked, about);
}

} // namespace pixelplumb
