// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/spanheadings.h"
#include "core/runs/tracedscene.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_spanwords {

using namespace pixelplumb;

namespace {

Triangle firstTriangle()
{
    return triangleAtUnits(latticePixel(4, 5), latticePixel(30, 12), latticePixel(20, 40));
}

Scene sceneOf(const QString &method, const Triangle &triangle)
{
    Scene scene;
    scene.method = method.toStdString();
    scene.triangles = {triangle};
    return scene;
}

QString sentenceAt(const Scene &scene, std::size_t step)
{
    return explainStep(*traceScene(scene), step).sentence;
}

} // namespace

/// What set-ups and spans of triangles are called, and what is said about them.
class TestSpanWords : public QObject {
    Q_OBJECT

private slots:
    void barycentricLettersAreThoseOfVertices_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("expected");
        QTest::newRow("a, b, c") << "barycentric-rectangle"
                                 << "a = P₀ (4, 5), b = P₁ (30, 12), c = P₂ (20, 40). The weights "
                                    "are α of P₀, β of P₁ and γ of P₂.";
        QTest::newRow("A, B, C") << "barycentric-cramer"
                                 << "A = P₀ (4, 5), B = P₁ (30, 12), C = P₂ (20, 40). The weights "
                                    "are u of P₀, v of P₁ and w of P₂.";
    }
    void barycentricLettersAreThoseOfVertices()
    {
        QFETCH(QString, id);
        QFETCH(QString, expected);
        QCOMPARE(sentenceAt(sceneOf(id, firstTriangle()), 0), expected);
    }

    void spansAreHeadedByTheirHalf_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<Lattice>("middle"); // y of the second vertex, px
        QTest::addColumn<QString>("last");
        const auto row = [](const char *id, const char *heading, const char *withoutArea) {
            QTest::addRow("%s", id) << id << Lattice(1) << heading;
            QTest::addRow("%s, no area", id) << id << Lattice(4) << withoutArea;
        };
        row("column-scan", "Column 8, second half", "Column 8");
        row("row-walk", "Row 1, second trapezoid", "Row 2");
        row("interpolate-plane", "Column 8, second half", "Column 8");
        row("interpolate-bilinear", "Column 8, second half", "Column 8");
        row("interpolate-bilinear-rows", "Row 1, second trapezoid", "Row 2");
    }
    void spansAreHeadedByTheirHalf()
    {
        QFETCH(QString, id);
        QFETCH(Lattice, middle);
        QFETCH(QString, last);
        const auto traced = traceScene(sceneOf(
            id, triangleAtUnits(latticePixel(2, 2), latticePixel(4, middle), latticePixel(8, 8))));
        const std::size_t span = traced->trace->spanCount() - 1;
        QCOMPARE(spanHeading(*traced->trace, span), last);
        const std::vector<NumberDescription> numbers = traced->trace->numbers().span;
        const auto half = std::ranges::find_if(numbers, [](const NumberDescription &number) {
            return number.id == u"half"_s || number.id == u"trapezoid"_s;
        });
        QVERIFY(half != numbers.end());
        const Quantity cell = traced->trace->span(span).cells[std::size_t(half - numbers.begin())];
        QCOMPARE(cell.isNone(), !last.contains(u','));
    }

    void aSpanOfTiesTellsThatTheRuleDoesNotTakeThem_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<FillRule>("rule");
        QTest::addColumn<QString>("expected");
        // (1, 1), (9, 1), (1, 8): the top row is one sample, row 1 is the lower edge.
        QTest::newRow("one bound") << "row-walk" << FillRule::TopLeft
                                   << "x_L = 1 and x_R = 1 have just the column 1 between them, "
                                      "exactly on an edge, and the fill rule does not take it.";
        QTest::newRow("no bounds told") << "interpolate-plane" << FillRule::Open
                                        << "The fill rule takes no sample of the frame here.";
        QTest::newRow("two bounds")
            << "column-scan" << FillRule::Open
            << "y_B = 1 and y_T = 2 have just the rows 1 and 2 between them, exactly on edges, and "
               "the fill rule takes neither.";
    }
    void aSpanOfTiesTellsThatTheRuleDoesNotTakeThem()
    {
        QFETCH(QString, id);
        QFETCH(FillRule, rule);
        QFETCH(QString, expected);
        Scene scene = sceneOf(
            id, triangleAtUnits(latticePixel(1, 1), latticePixel(9, 1), latticePixel(1, 9)));
        scene.settings.fillRule = rule;
        const auto traced = traceScene(scene);
        QStringList told;
        for (std::size_t span = 0; span < traced->trace->spanCount(); ++span)
            told.append(explainStep(*traced, traced->trace->indexOfSpan(span)).sentence);
        QVERIFY2(told.contains(expected), qPrintable(told.join(u'\n')));
    }
};

PIXELPLUMB_TEST(TestSpanWords)

} // namespace tst_spanwords

#include "tst_spanwords.moc"
