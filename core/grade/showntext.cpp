// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/showntext.h"

namespace pixelplumb {

namespace {

/// Format characters turn the direction of writing, or cannot be seen.
bool isControl(QChar character)
{
    const auto category = character.category();
    return category == QChar::Other_Control || category == QChar::Other_Format
        || category == QChar::Separator_Line || category == QChar::Separator_Paragraph;
}

} // namespace

QString escapedControls(const QString &text)
{
    QString escaped;
    for (const QChar character : text) {
        const ushort code = character.unicode();
        if (!isControl(character))
            escaped += character;
        else if (code < 0x100)
            escaped += QStringLiteral("\\x%1").arg(code, 2, 16, QLatin1Char('0'));
        else
            escaped += QStringLiteral("\\u%1").arg(code, 4, 16, QLatin1Char('0'));
    }
    return escaped;
}

QString shownText(const QByteArray &bytes, qsizetype longest)
{
    constexpr qsizetype longestCharacter = 4; // bytes of UTF-8
    QString text = QString::fromUtf8(bytes.left(longest * longestCharacter));
    for (QChar &character : text) {
        if (isControl(character) && character != u'\n' && character != u'\t')
            character = QChar::ReplacementCharacter;
    }
    if (text.size() > longest)
        text = text.left(longest) + QStringLiteral(" …");
    return text;
}

QString fewNames(const QStringList &names)
{
    constexpr qsizetype mostNamed = 5;
    return names.mid(0, mostNamed).join(QStringLiteral(", "))
        + (names.size() > mostNamed ? QStringLiteral(" …") : QString());
}

} // namespace pixelplumb
