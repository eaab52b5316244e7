// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/typesetting.h"

#include "widgets/look/symboltext.h"

#include <QRegularExpression>

namespace pixelplumb {

QString typeset(QString text)
{
    static const QRegularExpression mixed(QStringLiteral("(\\d)[ \u2009](\\d+/\\d+)"));
    text.replace(mixed, QStringLiteral("\\1\u202f\\2"));
    static const QRegularExpression negative(QStringLiteral("(^|[^\\w⌋⌉)])-(?=\\d)"));
    return text.replace(negative, QStringLiteral("\\1−"));
}

QString typesetHtml(const QString &text)
{
    static const QRegularExpression fraction(
        QStringLiteral("(?<![\\d).])(\\d+/\\d+)(?!\\d|\\.\\d)"));
    // Rich text turns every space except the no-break space into an ordinary one, at which a line
    // may break, as it may at an exponent's sign.
    static const QRegularExpression exponent(QStringLiteral("(\\de)([-−+])(?=\\d)"));
    QString whole = typeset(text).replace(u'\u202f', QChar::Nbsp);
    whole.replace(QStringLiteral("else "), QStringLiteral("else\u00a0"));
    whole.replace(exponent, QStringLiteral("\\1\u2060\\2\u2060"));
    QString html = SymbolText(whole).html();
    return html.replace(fraction, QStringLiteral("<small>\\1</small>"));
}

} // namespace pixelplumb
