// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/tracedscene.h"
#include "tests/support/numbernamed.h"
#include "tests/support/programs/tablefolder.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_linetables {

using namespace pixelplumb;

namespace {

const FrameSpec slideFrame = frameOf(16, 10, 18, 38);

/// The cells with these ids, one line per span; "-" for a missing cell.
QStringList tableOf(const Scene &scene, const QStringList &ids)
{
    const auto traced = traceScene(scene);
    QStringList lines;
    for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
        const SpanRecord record = traced->trace->span(span);
        QStringList cells;
        for (const QString &id : ids) {
            for (std::size_t i = 0; i < record.cells.size(); ++i) {
                if (traced->method->numbers.span[i].id == id)
                    cells.append(record.cells[i].isNone() ? u"-"_s : toText(record.cells[i]));
            }
        }
        lines.append(cells.join(u' '));
    }
    return lines;
}

} // namespace

/// The tables that the course texts print for their lines, and how each step is explained.
class TestLineTables : public QObject {
    Q_OBJECT

private slots:
    void slopeInterceptGivesTheSlidesTable()
    {
        const QStringList table
            = tableOf(sceneOf(lineAt(20, 41, 30, 44), "line-slope-intercept", slideFrame),
                      {u"x"_s, u"y"_s, u"y_r"_s});

        // Rasterization slides, "Example": from x = 21 on; the first end point needs no computing.
        QCOMPARE(table.mid(1),
                 QStringList({u"21 41 3/10 41"_s, u"22 41 3/5 42"_s, u"23 41 9/10 42"_s,
                              u"24 42 1/5 42"_s, u"25 42 1/2 43"_s, u"26 42 4/5 43"_s,
                              u"27 43 1/10 43"_s, u"28 43 2/5 43"_s, u"29 43 7/10 44"_s,
                              u"30 44 44"_s}));
        QCOMPARE(table.front(), u"20 41 41"_s);
    }

    void slopeInterceptGivesTheSlidesSteepLineItsOnePixelAfterTheFirst()
    {
        const Scene scene = sceneOf(lineAt(20, 41, 21, 46), "line-slope-intercept", slideFrame);

        const auto traced = traceScene(scene);

        // Rasterization slides, "Example 2": m = 5, b = −59, and the one row 21 46.
        const SetUpRecord setUp = traced->trace->setUp(0);
        QCOMPARE(toText(setUp.cells[4]), u"5"_s);
        QCOMPARE(toText(setUp.cells[5]), u"-59"_s);
        QCOMPARE(tableOf(scene, {u"x"_s, u"y_r"_s}), QStringList({u"20 41"_s, u"21 46"_s}));
        QCOMPARE(traced->differences.count(Difference::Missing), std::int64_t(4));
    }

    void slopeInterceptRefusesAVerticalLineWithAReason()
    {
        const auto traced
            = traceScene(sceneOf(lineAt(3, 2, 3, 9), "line-slope-intercept", frameOf(8, 12)));

        QCOMPARE(traced->trace->setUp(0).rejection, PrimitiveRejection::VerticalLine);
        QVERIFY(explainStep(*traced, 0).sentence.contains(u"has no m"));
    }

    void slopeInterceptCallsALineWithoutALengthAPoint()
    {
        const auto traced
            = traceScene(sceneOf(lineAt(3, 2, 3, 2), "line-slope-intercept", frameOf(8, 12)));

        QCOMPARE(traced->trace->setUp(0).rejection, PrimitiveRejection::LineOfNoLength);
        const QString sentence = explainStep(*traced, 0).sentence;
        QVERIFY2(sentence.contains(u"The line is a point"_s), qPrintable(sentence));
        QVERIFY(!sentence.contains(u"vertical"_s));
    }

    void bresenhamGivesTheSlidesTable()
    {
        const Scene scene = sceneOf(lineAt(20, 41, 30, 44), "line-bresenham", slideFrame);

        const QStringList table = tableOf(scene, {u"k"_s, u"p_k"_s, u"x"_s, u"y"_s});

        // Rasterization slides, "Bresenham: Example". The tie p₄ = 0 goes up, although the rule
        // printed next to it says otherwise.
        QCOMPARE(table,
                 QStringList({u"- - 20 41"_s, u"0 -4 21 41"_s, u"1 2 22 42"_s, u"2 -12 23 42"_s,
                              u"3 -6 24 42"_s, u"4 0 25 43"_s, u"5 -14 26 43"_s, u"6 -8 27 43"_s,
                              u"7 -2 28 43"_s, u"8 4 29 44"_s, u"9 -10 30 44"_s}));
    }

    void everyStepIsExplainedByItsNumbers()
    {
        const auto traced
            = traceScene(sceneOf(lineAt(20, 41, 30, 44), "line-bresenham", slideFrame));

        const Explanation setUp = explainStep(*traced, 0);
        const Explanation second = explainStep(*traced, traced->trace->indexOfSpan(2));

        const auto has
            = [](const Explanation &explanation, const char *symbols, const char *substituted) {
                  return std::ranges::any_of(explanation.lines, [&](const FormulaLine &line) {
                      return line.symbols == QString::fromUtf8(symbols)
                          && line.substituted == QString::fromUtf8(substituted);
                  });
              };
        QVERIFY(has(setUp, "p₀ = 2Δy − Δx", "6 − 10"));
        QVERIFY(has(second, "p_k ← p_k₊₁′", "2"));
        QVERIFY(has(second, "Δp = 2Δy − 2Δx", "−14"));
    }

    void whatBeginsBetweenPixelsComesFromLettersOfItsOwnStep_data()
    {
        QTest::addColumn<Shape>("line");
        QTest::newRow("flat, rising") << lineAtUnits({900, 600}, {4000, 3000});
        QTest::newRow("flat, falling") << lineAtUnits({900, 2500}, {4000, 700});
        QTest::newRow("steep, rising") << lineAtUnits({2100, -300}, {2900, 5000});
        QTest::newRow("steep, falling") << lineAtUnits({2900, -300}, {2100, 5000});
    }
    void whatBeginsBetweenPixelsComesFromLettersOfItsOwnStep()
    {
        QFETCH(Shape, line);
        const auto traced = traceScene(sceneOf(line, "line-bresenham-symmetric", frameOf(30, 30)));
        const std::vector<Quantity> setUp = traced->trace->setUp(0).cells;
        const auto inSetUp = [&](const char *id) {
            const auto &numbers = traced->method->numbers.setUp;
            const auto found
                = std::ranges::find(numbers, QString::fromLatin1(id), &NumberDescription::id);
            return setUp[std::size_t(found - numbers.begin())].toDouble();
        };
        const auto inStep = [&](const char *id) {
            return spanNumber(*traced, 0, QString::fromLatin1(id)).toDouble();
        };

        const double side = inSetUp("y_1") < inSetUp("y_0") ? -1 : 1;
        const double ordinate = inSetUp("y_0")
            + side * (inStep("x_k") + 2 - inSetUp("x_0")) * inSetUp("delta_y") / inSetUp("delta_x");
        const double decision = inSetUp("delta_x") * (side * 2 * (ordinate - inStep("y_k")) - 1);

        QVERIFY(std::abs(decision - inStep("p_next")) < 1e-9);
        const Explanation first = explainStep(*traced, traced->trace->indexOfSpan(0));
        const QString formula = first.lines.front().symbols;
        QCOMPARE(formula,
                 side > 0 ? "p_k₊₁ = Δx·(2·(y₀ + (x_k + 2 − x₀)·Δy/Δx) − 2·y_k − 1)"
                          : "p_k₊₁ = Δx·(2·y_k − 2·(y₀ − (x_k + 2 − x₀)·Δy/Δx) − 1)");
    }

    void aStepIsExplainedByItsDecision_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<int>("span");
        QTest::addColumn<QString>("sentence");

        const auto row = [](const char *method, int span, const char *sentence) {
            QTest::addRow("%s, %d", method, span)
                << QString::fromLatin1(method) << span << QString::fromUtf8(sentence);
        };
        row("line-bresenham", 0,
            "The line starts at the pixel (20, 41) without a decision; p_k₊₁ = −4 < 0 decides "
            "about the next one.");
        row("line-bresenham", 1,
            "p_k = 2Δy·x_k − 2Δx·y_k + c = 6·20 − 20·41 + 696 = −4 < 0: stay in the row, at the "
            "pixel (21, 41); Δp = 2Δy = 6.");
        row("line-bresenham", 2,
            "p_k = 2Δy·x_k − 2Δx·y_k + c = 6·21 − 20·41 + 696 = 2 > 0: step diagonally to the "
            "pixel "
            "(22, 42); Δp = 2Δy − 2Δx = −14.");
        row("line-bresenham-symmetric", 5,
            "p_k = 0, a tie: step diagonally to the pixel (25, 43); Δp = 2Δy − 2Δx = −14.");
        row("line-dda", 1,
            "On the column 21 the walk is at y = 41 3/10, which rounds to the pixel (21, 41).");
        row("line-slope-intercept", 2,
            "On the column 22 the line is at y = 41 3/5; (int)(y + ½) makes it the pixel (22, "
            "42).");
    }
    void aStepIsExplainedByItsDecision()
    {
        QFETCH(QString, method);
        QFETCH(int, span);
        QFETCH(QString, sentence);

        const auto traced = traceScene(
            sceneOf(lineAt(20, 41, 30, 44), method.toLatin1().constData(), slideFrame));

        QCOMPARE(explainStep(*traced, traced->trace->indexOfSpan(std::size_t(span))).sentence,
                 sentence);
    }

    /// Where a line falls, its distances are positive as where it rises: the subtraction changes.
    void theDistancesOfAFallingLineAreMeasuredAlongIt()
    {
        for (const char *method : {"line-bresenham", "line-bresenham-symmetric"}) {
            const Scene scene = sceneOf(lineAt(0, 5, 8, 2), method, frameOf(12, 8));
            QCOMPARE(tableOf(scene, {u"y_line"_s, u"d_lower"_s, u"d_upper"_s})[1],
                     u"4 5/8 3/8 5/8"_s);
            for (const NumberDescription &number :
                 methodNamed(QString::fromLatin1(method))->numbers.span)
                QVERIFY2(!number.toolTip.contains(u"where it falls"), qPrintable(number.toolTip));
        }
    }

    /// A third is in no double.
    void theLevelsOfALineHaveTheirFractionsInFiles()
    {
        Scene scene = sceneOf(lineAt(0, 0, 3, 1), "line-dda", frameOf(6, 6));
        scene.shapes[0].vertices[0].colour = {{0, 0, 0}};
        scene.shapes[0].vertices[1].colour = {{1, 3, 255}};
        TraceExportOptions options;
        options.level = TraceLevel::Pixel;
        options.format = TableFormat::Csv;
        options.columns = {u"R_exact"_s, u"B_exact"_s};
        const QByteArray text = exported(*traceScene(scene), options);
        QVERIFY(!text.isEmpty());
        QCOMPARE(text, QByteArray("R_exact,B_exact\r\n0,0\r\n1/3,85\r\n2/3,170\r\n1,255\r\n"));
    }

    void pointsAreWrittenToTheirAddress()
    {
        Shape points;
        points.kind = PrimitiveKind::Point;
        points.vertices = {{latticePixel(3, 2), {{0, 0, 255}}},
                           {{4 * 256 + 128, 127}, {{255, 0, 0}}},
                           {latticePixel(9, 9), {{0, 255, 0}}}};
        const Scene scene = sceneOf(points, "point-address", frameOf(6, 6));

        const QStringList table = tableOf(scene, {u"x"_s, u"y"_s, u"addr"_s});

        // Rasterization slides, "Point Plotting": (3, 2) in a frame of width 6 is at 2·6 + 3.
        QCOMPARE(table, QStringList({u"3 2 15"_s, u"5 0 5"_s, u"9 9 -"_s}));
        QVERIFY(departure(pictureBy(u"point-address", points, scene.frame),
                          truthOf(points, scene.frame))
                    .isEmpty());
        QCOMPARE(textOf(truthOf(points, frameOf(6, 3))), u"...#..\n......\n.....#\n"_s);
    }
};

PIXELPLUMB_TEST(TestLineTables)

} // namespace tst_linetables

#include "tst_linetables.moc"
