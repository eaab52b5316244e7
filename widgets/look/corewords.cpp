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
    QT_TRANSLATE_NOOP("core", "right within leeway"),
    QT_TRANSLATE_NOOP("core", "right within leeway in coverage"),
    QT_TRANSLATE_NOOP("core", "pictures right"),
    QT_TRANSLATE_NOOP("core", "pictures right within leeway"),
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
    QT_TRANSLATE_NOOP("core", "Random, %1 px"),
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
    QT_TRANSLATE_NOOP("core", "half"),
    QT_TRANSLATE_NOOP("core", "trapezoid"),
    QT_TRANSLATE_NOOP("core", "tri"),
    QT_TRANSLATE_NOOP("core", "edges"),
    QT_TRANSLATE_NOOP("core", "contours"),
    QT_TRANSLATE_NOOP("core", "first R"),
    QT_TRANSLATE_NOOP("core", "first G"),
    QT_TRANSLATE_NOOP("core", "first B"),
    QT_TRANSLATE_NOOP("core", "first C"),
    QT_TRANSLATE_NOOP("core", "first row"),
    QT_TRANSLATE_NOOP("core", "last row"),
    QT_TRANSLATE_NOOP("core", "first column"),
    QT_TRANSLATE_NOOP("core", "last column"),
    QT_TRANSLATE_NOOP("core", "the first row"),
    QT_TRANSLATE_NOOP("core", "the last row"),
    QT_TRANSLATE_NOOP("core", "the first column"),
    QT_TRANSLATE_NOOP("core", "the last column"),
    QT_TRANSLATE_NOOP("core", "the number of pixels"),
    QT_TRANSLATE_NOOP("core", "the first R"),
    QT_TRANSLATE_NOOP("core", "the first G"),
    QT_TRANSLATE_NOOP("core", "the first B"),
    QT_TRANSLATE_NOOP("core", "closed"),
    QT_TRANSLATE_NOOP("core", "half-open-column"),
    QT_TRANSLATE_NOOP("core", "top-left"),
    QT_TRANSLATE_NOOP("core", "off-screen-point"),
    QT_TRANSLATE_NOOP("core", "open"),
    QT_TRANSLATE_NOOP("core", "nearest"),
    QT_TRANSLATE_NOOP("core", "truncate"),
    QT_TRANSLATE_NOOP(
        "core",
        "Sorted by x: P₀ = vertex %1 (%2, %3), P₁ = vertex %4 (%5, %6), P₂ = vertex %7 (%8, %9)."),
    QT_TRANSLATE_NOOP("core",
                      "Sorted by y, the largest first: P₀ = vertex %1 (%2, %3), P₁ = vertex %4 "
                      "(%5, %6), P₂ = vertex %7 (%8, %9)."),
    QT_TRANSLATE_NOOP("core", "Sorted by y, the largest first: P₀ = (%1, %2), P₂ = (%3, %4)."),
    QT_TRANSLATE_NOOP(
        "core",
        "It has no area: the closed rule paints the samples on its segment, coloured along L₀₂."),
    QT_TRANSLATE_NOOP("core",
                      "It has no area: its vertices lie on one line, and only a triangle under the "
                      "closed rule is drawn as a segment."),
    QT_TRANSLATE_NOOP("core", "It lies outside the frame."),
    QT_TRANSLATE_NOOP("core", "Nothing is drawn."),
    QT_TRANSLATE_NOOP(
        "core",
        "It reaches into the frame, but by the run's tests no sample of the frame belongs to it."),
    QT_TRANSLATE_NOOP("core",
                      "All coordinates are counted from the centre of pixel (%1, %2): ½ px less "
                      "than the scene's."),
    QT_TRANSLATE_NOOP(
        "core", "The bounds are equal, so there is no change to spread between them, and no Δ."),
    QT_TRANSLATE_NOOP("core", "Each level is computed from P₀ anew."),
    QT_TRANSLATE_NOOP("core", "L₀₁ and L₁₂ give y_B, L₀₂ gives y_T."),
    QT_TRANSLATE_NOOP("core", "L₀₂ gives y_B, L₀₁ and L₁₂ give y_T."),
    QT_TRANSLATE_NOOP("core", "x₀ = x₁: L₀₁ has no slope, and the first half is skipped."),
    QT_TRANSLATE_NOOP("core",
                      "x₁ = x₂: L₁₂ has no slope, and the second half is one column at most."),
    QT_TRANSLATE_NOOP("core", "The scan starts in the second half, between L₁₂ and L₀₂."),
    QT_TRANSLATE_NOOP("core", "At x₁ the scan stops tracking L₀₁ and starts L₁₂ at P₁."),
    QT_TRANSLATE_NOOP("core",
                      "Between y_B = %1 and y_T = %2 the fill rule takes no sample of the frame."),
    QT_TRANSLATE_NOOP("core",
                      "y_B = %1 and y_T = %2 have just the row %3 between them, exactly on an "
                      "edge, and the fill rule does not take it."),
    QT_TRANSLATE_NOOP("core",
                      "y_B = %1 and y_T = %2 have just the rows %3 and %4 between them, exactly on "
                      "edges, and the fill rule takes neither."),
    QT_TRANSLATE_NOOP("core", "y_B = %1 and y_T = %2 cover the row %3."),
    QT_TRANSLATE_NOOP("core", "y_B = %1 and y_T = %2 cover the rows %3 to %4."),
    QT_TRANSLATE_NOOP("core",
                      "Without a pre-step, an edge that begins here has its vertex's values, "
                      "wherever between two columns the vertex lies."),
    QT_TRANSLATE_NOOP(
        "core",
        "Without a pre-step, the first row has the colours of y_B: (⌈y_B⌉ − y_B)·Δ is left out."),
    QT_TRANSLATE_NOOP("core", "The column's first pixel takes the starting values of R, G and B."),
    QT_TRANSLATE_NOOP("core", "The next row: each level changes by its Δ."),
    QT_TRANSLATE_NOOP("core", "the second half comes first: L₁₂ and L₀₂"),
    QT_TRANSLATE_NOOP("core", "x₁ reached: L₁₂ takes over from L₀₁"),
    QT_TRANSLATE_NOOP("core", "L₀₁ and L₁₂ give x_L, L₀₂ gives x_R."),
    QT_TRANSLATE_NOOP("core", "L₀₂ gives x_L, L₀₁ and L₁₂ give x_R."),
    QT_TRANSLATE_NOOP("core", "y₀ = y₁: L₀₁ has no slope, and the first trapezoid is skipped."),
    QT_TRANSLATE_NOOP("core",
                      "y₁ = y₂: L₁₂ has no slope, and the second trapezoid is one row at most."),
    QT_TRANSLATE_NOOP("core", "The scan starts in the second trapezoid, between L₁₂ and L₀₂."),
    QT_TRANSLATE_NOOP("core", "At y₁ the scan stops tracking L₀₁ and starts L₁₂ at P₁."),
    QT_TRANSLATE_NOOP("core",
                      "Between x_L = %1 and x_R = %2 the fill rule takes no sample of the frame."),
    QT_TRANSLATE_NOOP("core",
                      "x_L = %1 and x_R = %2 have just the column %3 between them, exactly on an "
                      "edge, and the fill rule does not take it."),
    QT_TRANSLATE_NOOP("core",
                      "x_L = %1 and x_R = %2 have just the columns %3 and %4 between them, exactly "
                      "on edges, and the fill rule takes neither."),
    QT_TRANSLATE_NOOP("core", "x_L = %1 and x_R = %2 cover the column %3."),
    QT_TRANSLATE_NOOP("core", "x_L = %1 and x_R = %2 cover the columns %3 to %4."),
    QT_TRANSLATE_NOOP("core",
                      "Without a pre-step, an edge that begins here has its vertex's values, "
                      "wherever between two rows the vertex lies."),
    QT_TRANSLATE_NOOP("core",
                      "Without a pre-step, the first column has the colours of x_L: (⌈x_L⌉ − "
                      "x_L)·Δ is left out."),
    QT_TRANSLATE_NOOP("core", "The row's first pixel takes the starting values of R, G and B."),
    QT_TRANSLATE_NOOP("core", "The next column: each level changes by its Δ."),
    QT_TRANSLATE_NOOP("core", "the second trapezoid comes first: L₁₂ and L₀₂"),
    QT_TRANSLATE_NOOP("core", "y₁ reached: L₁₂ takes over from L₀₁"),
    QT_TRANSLATE_NOOP("core", "the triangle has vertex colours that differ"),
    QT_TRANSLATE_NOOP("core", "what is drawn lies within the frame"),
    QT_TRANSLATE_NOOP("core", "fewer than two triangles are drawn in the frame"),
    QT_TRANSLATE_NOOP("core", "w is the same at the vertices of every triangle"),
    QT_TRANSLATE_NOOP("core", "no triangle has a material with a texture"),
    QT_TRANSLATE_NOOP("core", "no light is on"),
    QT_TRANSLATE_NOOP("core", "every alpha is %1: opaque"),
    QT_TRANSLATE_NOOP("core", "the scene asks for one sample a pixel"),
    QT_TRANSLATE_NOOP("core", "there is no triangle, and nothing else has a depth"),
    QT_TRANSLATE_NOOP("core", "there is no triangle, and nothing else has w"),
    QT_TRANSLATE_NOOP("core", "there is no triangle, and nothing else has a texture"),
    QT_TRANSLATE_NOOP("core", "there is no triangle, and nothing else has normals"),
    QT_TRANSLATE_NOOP("core", "there is no triangle, and nothing else has an alpha"),
    QT_TRANSLATE_NOOP("core", "In English: %1"),
};

QString translated(const QString &english)
{
    return QCoreApplication::translate("core", english.toUtf8().constData());
}

} // namespace

QString coreWord(const QString &english)
{
    // A mixed number, 7 53/54, is one number, so that a sentence about it has one pattern.
    static const QRegularExpression number(
        u"[-−]?\\b[0-9]+(?:\\.[0-9]+)?(?:e[-−+]?[0-9]+)?(?:(?: [0-9]+)?/[0-9]+)?"_s);
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

QString coreSentences(const QString &english)
{
    static const QRegularExpression between(u"(?<=\\.) "_s);
    QStringList sentences = english.split(between);
    bool areAllKnown = true;
    for (QString &sentence : sentences) {
        const QString word = coreWord(sentence);
        areAllKnown = areAllKnown && (word != sentence || sentence.isEmpty());
        sentence = word;
    }
    return areAllKnown ? sentences.join(u' ') : inEnglish(english);
}

QString inEnglish(const QString &english)
{
    const QString pattern = u"In English: %1"_s;
    const QString marked = translated(pattern);
    return marked == pattern || english.isEmpty() ? english : marked.arg(english);
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
