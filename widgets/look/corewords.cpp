// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/corewords.h"

#include "core/scan/choicenames.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace pixelplumb {

namespace {

constexpr const char *context = "pixelplumb::CoreWords";

/// A list for lupdate only. At run time words are looked up by core's text, not here.
[[maybe_unused]] constexpr const char *translatableWords[] = {
    // Kinds of primitives, of solids and of surfaces.
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "triangle"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "point"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "line"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "circle"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "ellipse"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "bezier"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "polygon"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "text"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "triangle3"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "polygon3"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "plane"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "sphere"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "patch"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "mesh"),
    // Steps, as a heading.
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Triangle %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Point %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Line %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Circle %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Ellipse %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Bezier %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Polygon %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Text %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "set-up"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Pixel (%1, %2)"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Sample (%1, %2), refused"),
    // Why a triangle of a solid is not drawn: "3: each …".
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords",
                      "is not seen: the camera's eye is at its target, or up is where it looks"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "has no part beyond the near plane"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "has a corner that the camera takes nowhere"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "has a corner beyond ±%1^%2 px"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "has a corner with a number beyond ±%1^%2"),
    // Spans, as a heading and within a sentence.
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Column %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Column %1, first half"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Column %1, second half"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Column %1, part %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Column %1, edge %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Column %1, triangle %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Row %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Row %1, first trapezoid"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Row %1, second trapezoid"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Row %1, part %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Row %1, edge %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Row %1, triangle %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Step %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Step %1, part %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Step %1, edge %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Step %1, triangle %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Piece %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "column %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "column %1, first half"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "column %1, second half"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "column %1, part %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "column %1, edge %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "column %1, triangle %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "row %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "row %1, first trapezoid"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "row %1, second trapezoid"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "row %1, part %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "row %1, edge %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "row %1, triangle %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "step %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "step %1, part %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "step %1, edge %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "step %1, triangle %2"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "piece %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "part %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "edge %1"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "triangle %1"),
    // Verdicts on pixels, on submissions and on times.
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "same"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "missing"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "extra"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "colour"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "undecidable"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "right"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "wrong"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "nothing"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "right in coverage"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "undecidable in coverage"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "cannot be graded"),
    // Effects and the verdicts on them.
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "smooth colour"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "clipping"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "depth"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "perspective"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "texture"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "light"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "blending"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "antialiasing"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "called for"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "not called for"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "not ruled out"),
    // Why pictures differ.
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "agreed"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "tie rule"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "kind not drawn"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "rounding"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "drift"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "precision"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "method"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "not recorded"),
    // Families of methods, and the layers.
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Triangles"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Triangles, stable forms"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Interpolation"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Lines"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Curves"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Polygons"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Points and text"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Vertices and edges"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Bounding box"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Half-planes and normals"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Half-plane of E₀"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Half-plane of E₁"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Half-plane of E₂"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Weights in the cells"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "R G B in the cells"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Barycentric axes and points"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Affine map: weights stay"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Contour lines of R"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Contour lines of G"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Contour lines of B"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Triangles of a polygon"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Edge table"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Decision of the step"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Brightness by direction"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Sampling points"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Addresses in memory"),
    // The phases of a job.
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "reading"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "projecting"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "drawing"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "recording"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "recording in exact numbers"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "judging"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "explaining"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "measuring"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "writing"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "checking"),
    // Operations, and the arithmetics in which they were counted.
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "divisions"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "roundings"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "float additions"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "integer additions"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "multiplications"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "comparisons"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "conversions"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "functions"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "all"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 set-up"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 set-ups"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 span"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 spans"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 pixel"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 pixels"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 sample refused"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 samples refused"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 operation"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 operations"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 of %2 edges looked at"),
    // Axes, families and budgets of the lab.
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "wrong pixels"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "wrong coverage"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "wrong colours"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "largest error of a byte"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "largest error before rounding"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "RMS error before rounding"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "farthest missed sample"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "levels"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Random, whole pixels"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Random, %1/%2 px"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Slivers"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Ties"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Far from the origin"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Small triangles"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Large triangles"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Mesh"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Own scene"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "Hard cases"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "area"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "triangles"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "exact"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "at most one level"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "at most %1 wrong pixels per million"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 ms a frame"),
    // Times of contenders, and the time left.
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "plain kernel %1 ns a pixel"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords",
                      "The time is that of the plain kernel, the one that is stepped through, on "
                      "one thread:"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords",
                      "median of %1 rounds %2 ns a pixel, the middle half %3 … %4, over %5 px of "
                      "triangles, each as often as it is written."),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "waiting"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "about %1 s"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "about %1 min"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 %, about %2 s left"),
    QT_TRANSLATE_NOOP("pixelplumb::CoreWords", "%1 %, about %2 min left"),
};

QString translated(const QString &english)
{
    return QCoreApplication::translate(context, english.toUtf8().constData());
}

} // namespace

QString coreWord(const QString &english)
{
    static const QRegularExpression number(QStringLiteral("[-−]?\\b[0-9]+(\\.[0-9]+)?"));
    QStringList numbers;
    QString pattern;
    qsizetype end = 0;
    for (const QRegularExpressionMatch &match : number.globalMatch(english)) {
        numbers += match.captured();
        pattern += english.mid(end, match.capturedStart() - end)
            + QStringLiteral("%%1").arg(numbers.size());
        end = match.capturedEnd();
    }
    QString word = translated(pattern + english.mid(end));
    for (const QString &each : std::as_const(numbers))
        word = word.arg(each);
    return word;
}

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

QString coreWord(std::string_view english) { return coreWord(nameText(english)); }

} // namespace pixelplumb
