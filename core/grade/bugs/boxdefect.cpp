// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/edgetestdefect.h"
#include "core/grade/scan/boxredrawings.h"

namespace pixelplumb {

namespace {

constexpr const char *edgesQuestion = "Are all three edges tested alike?";
constexpr const char *boxQuestion
    = "Which samples of the bounding box are tested, and which are inside?";

QString vertexText(std::size_t vertex) { return QString::number(vertex % 3); }

} // namespace

std::vector<Defect> boxDefects()
{
    std::vector<Defect> defects;
    const auto add = [&](const QString &id, const char *forStudent, const QString &forAssistant,
                         const Redrawing &redrawing) {
        defects.push_back(redrawnBy(redrawing, {id, QString::fromUtf8(forStudent), forAssistant}));
    };
    const auto addOfBox
        = [&](const char *id, const char *forAssistant, const Redrawing &redrawing) {
              add(QString::fromLatin1(id), boxQuestion, QString::fromUtf8(forAssistant), redrawing);
          };
    addOfBox("box-filled", "The whole bounding box is drawn: no sample is tested.", {fillBox});
    addOfBox("box-last-row-missing", "The box' last row is left out: < in place of ≤.",
             {omitLastRowOfBox});
    addOfBox("box-last-column-missing", "The box' last column is left out: < in place of ≤.",
             {omitLastColumnOfBox});
    addOfBox("box-ends-missing",
             "The box' last row and its last column are left out: < in place of ≤.",
             {[](TriangleRuns &triangle) {
                 omitLastRowOfBox(triangle);
                 omitLastColumnOfBox(triangle);
             }});
    addOfBox("box-open-at-greatest",
             "Samples at x_max or y_max itself are left out: < in place of ≤.",
             {omitGreatestOfBox});
    addOfBox("box-first-row-missing", "The box' first row is left out.", {omitFirstRowOfBox});
    addOfBox("box-first-column-missing", "The box' first column is left out.",
             {omitFirstColumnOfBox});
    addOfBox("box-starts-missing", "The box' first row and its first column are left out.",
             {[](TriangleRuns &triangle) {
                 omitFirstRowOfBox(triangle);
                 omitFirstColumnOfBox(triangle);
             }});
    add(QStringLiteral("levels-wrap"), "What becomes of a level that no byte holds?",
        QStringLiteral("Levels beyond 0 … 255 wrap in a byte. That alone is no mistake."),
        {[](TriangleRuns &) {}, LevelOverflow::Wraps});
    defects.back().isRightAlone = true;
    Redrawing outward{[](TriangleRuns &) {}};
    outward.box = VisitedBox::Outward;
    addOfBox("box-outward",
             "The box is rounded outward, ⌊x_min⌋ … ⌈x_max⌉ and ⌊y_min⌋ … ⌈y_max⌉: samples beside "
             "the triangle are tested, too. That alone is no mistake.",
             outward);
    defects.back().isRightAlone = true;
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const QString from = vertexText(edge);
        const QString to = vertexText(edge + 1);
        add(QStringLiteral("box-of-vertices-%1-and-%2").arg(from, to), boxQuestion,
            QStringLiteral("The box is that of the vertices %1 and %2 alone.").arg(from, to),
            {[edge](TriangleRuns &triangle) { omitBesideBoxOfEdge(triangle, edge); }});
        add(QStringLiteral("strict-at-edge-%1").arg(edge), edgesQuestion,
            QStringLiteral("The edge from vertex %1 to vertex %2 is tested by > in place of ≥, the "
                           "others are not.")
                .arg(from, to),
            {[edge](TriangleRuns &triangle) { omitOnEdge(triangle, edge); }});
        defects.back().choice = QString::fromLatin1(ruleChoice);
        add(QStringLiteral("strict-but-at-edge-%1").arg(edge), edgesQuestion,
            QStringLiteral("Two edges are tested by > in place of ≥, that from vertex %1 to vertex "
                           "%2 is not.")
                .arg(from, to),
            {[edge](TriangleRuns &triangle) {
                omitOnEdge(triangle, (edge + 1) % 3);
                omitOnEdge(triangle, (edge + 2) % 3);
            }});
        defects.back().choice = QString::fromLatin1(ruleChoice);
    }
    return defects;
}

} // namespace pixelplumb
