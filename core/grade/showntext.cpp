// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/showntext.h"

#include <algorithm>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

QString escapeOf(char32_t character)
{
    const auto padded = [character](int digits) {
        return u"%1"_s.arg(uint(character), digits, 16, QLatin1Char('0'));
    };
    if (character < 0x100)
        return u"\\x"_s + padded(2);
    return character < 0x10000 ? u"\\u"_s + padded(4) : u"\\U"_s + padded(8);
}

} // namespace

bool canBeShown(char32_t character)
{
    switch (QChar::category(character)) {
    case QChar::Other_Control:
    case QChar::Other_Format:
    case QChar::Other_Surrogate:
    case QChar::Other_PrivateUse:
    case QChar::Other_NotAssigned:
    case QChar::Separator_Line:
    case QChar::Separator_Paragraph:
        return false;
    default:
        return true;
    }
}

QString escapedControls(const QString &text)
{
    const auto isPlain = [](QChar character) { return character >= u' ' && character <= u'~'; };
    if (std::ranges::all_of(text, isPlain)) // nearly always, also for whole rasters
        return text;
    QString escaped;
    for (const char32_t character : text.toUcs4())
        escaped += canBeShown(character) ? QString::fromUcs4(&character, 1) : escapeOf(character);
    return escaped;
}

QString escapedLines(const QString &text)
{
    QStringList lines;
    for (const QString &line : text.split(u'\n'))
        lines += escapedControls(line);
    return lines.join(u'\n');
}

QByteArray escapedJson(const QByteArray &json)
{
    QString escaped;
    for (const char32_t character : QString::fromUtf8(json).toUcs4()) {
        const QString units = QString::fromUcs4(&character, 1);
        if (canBeShown(character) || character == U'\n') {
            escaped += units;
            continue;
        }
        for (const QChar unit : units)
            escaped += u"\\u%1"_s.arg(unit.unicode(), 4, 16, QLatin1Char('0'));
    }
    return escaped.toUtf8();
}

QString shownText(const QByteArray &bytes, qsizetype longest)
{
    constexpr qsizetype longestCharacter = 4; // bytes of UTF-8
    const QList<uint> characters
        = QString::fromUtf8(bytes.left(longest * longestCharacter)).toUcs4();
    QString text;
    for (const char32_t character : characters.first(std::min(longest, characters.size())))
        text += canBeShown(character) || character == U'\n' || character == U'\t'
            ? QString::fromUcs4(&character, 1)
            : QString(QChar::ReplacementCharacter);
    return characters.size() > longest ? text + u" …"_s : text;
}

QString fewNames(const QStringList &names)
{
    constexpr qsizetype mostNamed = 5;
    return names.mid(0, mostNamed).join(u", "_s) + (names.size() > mostNamed ? u" …"_s : QString());
}

} // namespace pixelplumb
