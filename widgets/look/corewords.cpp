// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/corewords.h"

#include "core/methods/method.h"
#include "core/scan/choicenames.h"

#include <QtWidgets>

#include <algorithm>

namespace pixelplumb {

namespace {

/// What core puts together, for lupdate only. What it says in one piece is marked there.
[[maybe_unused]] constexpr const char *composedWords[] = {
    QT_TRANSLATE_NOOP("core", "set-up"),
    QT_TRANSLATE_NOOP("core", "Triangle %1"),
    QT_TRANSLATE_NOOP("core", "Point %1"),
    QT_TRANSLATE_NOOP("core", "Line %1"),
    QT_TRANSLATE_NOOP("core", "Circle %1"),
    QT_TRANSLATE_NOOP("core", "Ellipse %1"),
    QT_TRANSLATE_NOOP("core", "Bezier %1"),
    QT_TRANSLATE_NOOP("core", "Polygon %1"),
    QT_TRANSLATE_NOOP("core", "Text %1"),
    QT_TRANSLATE_NOOP("core", "column %1"),
    QT_TRANSLATE_NOOP("core", "row %1"),
    QT_TRANSLATE_NOOP("core", "step %1"),
    QT_TRANSLATE_NOOP("core", "piece %1"),
    QT_TRANSLATE_NOOP("core", "edge %1"),
    QT_TRANSLATE_NOOP("core", "triangle %1"),
    QT_TRANSLATE_NOOP("core", "first half"),
    QT_TRANSLATE_NOOP("core", "second half"),
    QT_TRANSLATE_NOOP("core", "first trapezoid"),
    QT_TRANSLATE_NOOP("core", "second trapezoid"),
    QT_TRANSLATE_NOOP("core", "has a corner beyond ±%1^%2 px"),
    QT_TRANSLATE_NOOP("core", "has a corner with a number beyond ±%1^%2"),
    QT_TRANSLATE_NOOP("core", "right in coverage"),
    QT_TRANSLATE_NOOP("core", "undecidable in coverage"),
    QT_TRANSLATE_NOOP("core", "pictures right"),
    QT_TRANSLATE_NOOP("core", "pictures undecidable"),
    QT_TRANSLATE_NOOP("core", "breaks runs"),
    QT_TRANSLATE_NOOP("core", "breaks bounds"),
    QT_TRANSLATE_NOOP("core", "breaks range"),
    QT_TRANSLATE_NOOP("core", "breaks corners"),
    QT_TRANSLATE_NOOP("core", "breaks count"),
    QT_TRANSLATE_NOOP("core", "breaks order"),
    QT_TRANSLATE_NOOP("core", "breaks translation"),
    QT_TRANSLATE_NOOP("core", "breaks once"),
    QT_TRANSLATE_NOOP("core", "Half-plane of E₀"),
    QT_TRANSLATE_NOOP("core", "Half-plane of E₁"),
    QT_TRANSLATE_NOOP("core", "Half-plane of E₂"),
    QT_TRANSLATE_NOOP("core", "%1 set-up"),
    QT_TRANSLATE_NOOP("core", "%1 set-ups"),
    QT_TRANSLATE_NOOP("core", "%1 span"),
    QT_TRANSLATE_NOOP("core", "%1 spans"),
    QT_TRANSLATE_NOOP("core", "%1 pixel"),
    QT_TRANSLATE_NOOP("core", "%1 pixels"),
    QT_TRANSLATE_NOOP("core", "%1 sample refused"),
    QT_TRANSLATE_NOOP("core", "%1 samples refused"),
    QT_TRANSLATE_NOOP("core", "%1 operation"),
    QT_TRANSLATE_NOOP("core", "%1 operations"),
    QT_TRANSLATE_NOOP("core", "Random, %1/%2 px"),
    QT_TRANSLATE_NOOP("core", "exact"),
    QT_TRANSLATE_NOOP("core", "at most %1 wrong pixels per million"),
    QT_TRANSLATE_NOOP("core", "%1 ms a frame"),
    QT_TRANSLATE_NOOP("core",
                      "The time is that of the plain kernel, the one that is stepped through, on "
                      "one thread:"),
    QT_TRANSLATE_NOOP("core",
                      "median of %1 rounds %2 ns a pixel, the middle half %3 … %4, over %5 px of "
                      "triangles, each as often as it is written."),
    QT_TRANSLATE_NOOP("core", "%1 %, about %2 s left"),
    QT_TRANSLATE_NOOP("core", "%1 %, about %2 min left"),
};

QString translated(const QString &english)
{
    return QCoreApplication::translate("core", english.toUtf8().constData());
}

} // namespace

QString coreWord(const QString &english)
{
    static const QRegularExpression number(u"[-−]?\\b[0-9]+(\\.[0-9]+)?"_s);
    QStringList numbers;
    QString pattern;
    qsizetype end = 0;
    for (const QRegularExpressionMatch &match : number.globalMatch(english)) {
        numbers += match.captured();
        pattern += english.mid(end, match.capturedStart() - end) + u"%%1"_s.arg(numbers.size());
        end = match.capturedEnd();
    }
    pattern += english.mid(end);
    QString word = translated(pattern);
    const QString comma = u", "_s;
    if (word == pattern && english.contains(comma))
        return coreWords(english, comma); // "Column 27, second half"
    for (const QString &each : std::as_const(numbers))
        word = word.arg(each);
    return word;
}

QString coreWord(std::string_view english) { return coreWord(nameText(english)); }

QString coreWords(const QString &english, const QString &separator)
{
    QStringList lines = english.split(u'\n');
    for (QString &line : lines) {
        QStringList words = line.split(separator);
        for (QString &word : words)
            word = coreWord(word);
        line = words.join(separator);
    }
    return lines.join(u'\n');
}

QString methodTitle(const Method &method) { return translated(method.title); }

QString methodSummary(const Method &method) { return translated(method.summary); }

Translation::Translation(const QStringList &languages)
{
    // English has a file too, so that a person who prefers it to German gets it.
    const auto loads = [this](const QString &language) { return load(language); };
    if (!std::ranges::any_of(languages, loads))
        load(u"en"_s);
    // Qt's texts use the language of ours, not a less preferred one.
    if (m_ofQt.load(u"qtbase_"_s + language(), QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_ofQt);
    QCoreApplication::installTranslator(&m_ours);
}

/// Without a file for the country the language's is loaded: QTranslator cuts at underscores.
bool Translation::load(QString language)
{
    return m_ours.load(u"pixelplumb_"_s + language.replace(u'-', u'_'), u":/i18n"_s);
}

} // namespace pixelplumb
