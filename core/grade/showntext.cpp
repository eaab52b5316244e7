// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/showntext.h"

namespace pixelplumb {

QString shownText(const QByteArray &bytes, qsizetype longest)
{
    constexpr qsizetype longestCharacter = 4; // bytes of UTF-8
    QString text = QString::fromUtf8(bytes.left(longest * longestCharacter));
    for (QChar &character : text) {
        const auto category = character.category();
        // Format characters turn the direction of writing, or cannot be seen.
        const bool isControl = category == QChar::Other_Control || category == QChar::Other_Format
            || category == QChar::Separator_Line || category == QChar::Separator_Paragraph;
        if (isControl && character != u'\n' && character != u'\t')
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
