// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/spreadsheettext.h"

namespace pixelplumb {

namespace {

/// The plain form of a look-alike character: "=" for "＝".
QChar plainForm(QChar character)
{
    const QString plain = QString(character).normalized(QString::NormalizationForm_KC);
    return plain.size() == 1 ? plain.front() : character;
}

} // namespace

QString spreadsheetText(const QString &text)
{
    QString safe;
    bool isAtStart = true;
    for (const QChar character : text) {
        const QChar plain = plainForm(character);
        // An apostrophe already here is doubled, so that no two texts become the same.
        if (isAtStart && QStringView(u"=+-@\t\r'").contains(plain))
            safe += u'\'';
        safe += character;
        const bool isSkipped = plain.isSpace() || plain == u'"';
        isAtStart = QStringView(u",;|\t\r\n").contains(plain) || (isAtStart && isSkipped);
    }
    return safe;
}

} // namespace pixelplumb
