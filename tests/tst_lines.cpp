// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecheck.h"
#include "core/methods/formulaexplanation.h"
#include "core/scene/fileaccess.h"
#include "core/trace/tracedscene.h"
#include "tests/support/shapes.h"

#include <QRandomGenerator>
#include <QTest>

using namespace pixelplumb;

namespace {

const FrameSpec slideFrame = windowOf(16, 10, 18, 38);

/// The cells with these ids of all spans of a scene, a line a span; "-" where there is none.
QStringList tableOf(const Scene &scene, const QStringList &ids)
{
    const auto traced = traceScene(scene);
    QStringList lines;
    for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
        const SpanRecord record = traced->trace->span(span);
        QStringList cells;
        for (const QString &id : ids) {
            for (std::size_t i = 0; i < record.cells.size(); ++i) {
                if (traced->method->spanColumns[i].id == id)
                    cells.append(record.cells[i].isNone() ? QStringLiteral("-")
                                                          : toText(record.cells[i]));
            }
        }
        lines.append(cells.join(u' '));
    }
    return lines;
}

/// Lines between all points of a lattice of 12 × 12, in units of a third of the frame's pixel or
/// whole pixels.
template <class Function>
void forEachSmallLine(Lattice step, const Function &function)
{
    for (Lattice x0 = 0; x0 < 12; ++x0) {
        for (Lattice y0 = 0; y0 < 12; ++y0) {
            for (Lattice x1 = 0; x1 < 12; ++x1) {
                for (Lattice y1 = 0; y1 < 12; ++y1)
                    function(lineAtUnits({x0 * step, y0 * step}, {x1 * step, y1 * step}));
            }
        }
    }
}

Shape randomLine(QRandomGenerator &random, Lattice reach)
{
    const auto coordinate
        = [&] { return Lattice(random.bounded(qint64(-reach), qint64(reach + 1))); };
    const LatticePoint a = {coordinate(), coordinate()};
    return lineAtUnits(a, {coordinate(), coordinate()});
}

/// The picture that the pixels of a trace make.
QImage replayOf(const TracedScene &traced)
{
    const FrameBuffer frame(traced.scene.frame);
    for (std::size_t i = 0; i < traced.trace->sampleCount(); ++i) {
        const PixelChange &change = traced.trace->changes()[i];
        *frame.view().at(change.x, change.y) = change.after;
    }
    return frame.copy();
}

} // namespace

class TestLines : public QObject {
    Q_OBJECT

private slots:
    void slopeInterceptGivesTheSlidesTable()
    {
        const QStringList table
            = tableOf(sceneOf(lineAt(20, 41, 30, 44), "line-slope-intercept", slideFrame),
                      {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("y_r")});

        // Seed 002, "Example": from x = 21 on; the first end point needs no computing.
        QCOMPARE(table.mid(1),
                 QStringList({QStringLiteral("21 41 3/10 41"), QStringLiteral("22 41 3/5 42"),
                              QStringLiteral("23 41 9/10 42"), QStringLiteral("24 42 1/5 42"),
                              QStringLiteral("25 42 1/2 43"), QStringLiteral("26 42 4/5 43"),
                              QStringLiteral("27 43 1/10 43"), QStringLiteral("28 43 2/5 43"),
                              QStringLiteral("29 43 7/10 44"), QStringLiteral("30 44 44")}));
        QCOMPARE(table.front(), QStringLiteral("20 41 41"));
    }

    void slopeInterceptGivesTheSlidesSteepLineItsOnePixelAfterTheFirst()
    {
        const Scene scene = sceneOf(lineAt(20, 41, 21, 46), "line-slope-intercept", slideFrame);

        const auto traced = traceScene(scene);

        // Seed 002, "Example 2": m = 5, b = −59, and the one row 21 46.
        const SetUpRecord setUp = traced->trace->setUp(0);
        QCOMPARE(toText(setUp.cells[1]), QStringLiteral("5"));
        QCOMPARE(toText(setUp.cells[2]), QStringLiteral("-59"));
        QCOMPARE(tableOf(scene, {QStringLiteral("x"), QStringLiteral("y_r")}),
                 QStringList({QStringLiteral("20 41"), QStringLiteral("21 46")}));
        QCOMPARE(traced->differences.count(Difference::Missing), std::int64_t(4));
    }

    void slopeInterceptRefusesAVerticalLineWithAReason()
    {
        const auto traced
            = traceScene(sceneOf(lineAt(3, 2, 3, 9), "line-slope-intercept", windowOf(8, 12)));

        QCOMPARE(traced->trace->setUp(0).rejection, PrimitiveRejection::VerticalLine);
        QVERIFY(explainStep(*traced, 0).sentence.contains(u"has no m"));
    }

    void bresenhamGivesTheSlidesTable()
    {
        const Scene scene = sceneOf(lineAt(20, 41, 30, 44), "line-bresenham", slideFrame);

        const QStringList table = tableOf(
            scene,
            {QStringLiteral("k"), QStringLiteral("p_k"), QStringLiteral("x"), QStringLiteral("y")});

        // Seed 002, "Bresenham: Example". The tie p₄ = 0 goes up, whatever the rule beside it
        // prints.
        QCOMPARE(table,
                 QStringList({QStringLiteral("- - 20 41"), QStringLiteral("0 -4 21 41"),
                              QStringLiteral("1 2 22 42"), QStringLiteral("2 -12 23 42"),
                              QStringLiteral("3 -6 24 42"), QStringLiteral("4 0 25 43"),
                              QStringLiteral("5 -14 26 43"), QStringLiteral("6 -8 27 43"),
                              QStringLiteral("7 -2 28 43"), QStringLiteral("8 4 29 44"),
                              QStringLiteral("9 -10 30 44")}));
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
    }

    void stableMethodsAreTheTruthOnEverySmallLine_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<qint64>("step");
        for (const char *method : {"line-dda", "line-bresenham-symmetric"}) {
            QTest::addRow("%s, whole pixels", method) << method << qint64(unitsPerPixel);
            QTest::addRow("%s, between pixels", method) << method << qint64(85);
        }
    }
    void stableMethodsAreTheTruthOnEverySmallLine()
    {
        QFETCH(QString, method);
        QFETCH(qint64, step);
        const FrameSpec frame = windowOf(14, 14, -1, -1);
        QString failure;
        forEachSmallLine(step, [&](const Shape &line) {
            if (!failure.isEmpty())
                return;
            const QString departed
                = departure(pictureBy(method, line, frame), truthOf(line, frame));
            if (!departed.isEmpty())
                failure = nameOf(line) + QStringLiteral(": ") + departed;
        });
        QVERIFY2(failure.isEmpty(), qPrintable(failure));
    }

    void stableMethodsAreTheTruthOnLongLines_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<qint64>("reach");
        for (const char *method : {"line-dda", "line-bresenham-symmetric"}) {
            QTest::addRow("%s, 300 px", method) << method << qint64(300 * unitsPerPixel);
            QTest::addRow("%s, 2^30 px", method) << method << qint64(largestCoordinate);
        }
    }
    void stableMethodsAreTheTruthOnLongLines()
    {
        QFETCH(QString, method);
        QFETCH(qint64, reach);
        QRandomGenerator random(20);
        for (int round = 0; round < 150; ++round) {
            const Shape line = randomLine(random, reach);
            // The window that a long line is sure to cross: around its middle.
            const auto middle = [&](Lattice a, Lattice b) {
                return std::int32_t(floorPixel(a / 2 + b / 2) - 40);
            };
            const LatticePoint a = line.vertices[0].position;
            const LatticePoint b = line.vertices[1].position;
            const FrameSpec frame = windowOf(80, 80, middle(a.x, b.x), middle(a.y, b.y));
            const CasePicture truth = truthOf(line, frame);
            QVERIFY2(departure(pictureBy(method, line, frame), truth).isEmpty(),
                     qPrintable(QStringLiteral("seed 20, ") + nameOf(line)));
            QVERIFY(truth.pixelCount() > 0);
        }
    }

    void aReversedLineHasTheSamePixelsInTheSymmetricMethodAlone()
    {
        const FrameSpec frame = windowOf(12, 12);
        int changed = 0;
        QString failure;
        forEachSmallLine(unitsPerPixel, [&](const Shape &line) {
            const auto text = [&](QStringView method, const Shape &shape) {
                return textOf(pictureBy(method, shape, frame));
            };
            if (text(u"line-bresenham-symmetric", line)
                != text(u"line-bresenham-symmetric", reversed(line)))
                failure = nameOf(line);
            changed += text(u"line-bresenham", line) != text(u"line-bresenham", reversed(line));
        });
        QVERIFY2(failure.isEmpty(), qPrintable(failure));
        // The shortest of them: (0, 0)–(2, 1), where y(1) = 1/2.
        QVERIFY(changed > 1000);
        QCOMPARE(textOf(pictureBy(u"line-bresenham", lineAt(0, 0, 2, 1), windowOf(3, 2))),
                 QStringLiteral(".##\n#..\n"));
        QCOMPARE(textOf(pictureBy(u"line-bresenham", lineAt(2, 1, 0, 0), windowOf(3, 2))),
                 QStringLiteral("..#\n##.\n"));
    }

    void bresenhamIsWrongAtTiesAlone()
    {
        const FrameSpec frame = windowOf(12, 12);
        QString failure;
        forEachSmallLine(unitsPerPixel, [&](const Shape &line) {
            const PictureDifference difference = differenceBetween(
                pictureBy(u"line-bresenham", line, frame), truthOf(line, frame));
            const LatticePoint a = line.vertices[0].position;
            const LatticePoint b = line.vertices[1].position;
            const Lattice length = std::max(absolute(b.x - a.x), absolute(b.y - a.y));
            const Lattice breadth = std::min(absolute(b.x - a.x), absolute(b.y - a.y));
            // y(k) = k·Δy/Δx ends in 1/2 for some k only if Δx has more factors 2 than Δy.
            const bool mayTie = breadth != 0 && (length & -length) > (breadth & -breadth);
            if (!difference.isNone() && !mayTie)
                failure = nameOf(line) + QStringLiteral(": ") + difference.message();
        });
        QVERIFY2(failure.isEmpty(), qPrintable(failure));
    }

    void roundingArithmeticDriftsOnALongLine()
    {
        const Shape line = lineAt(0, 9001, 16381, 15013);
        const FrameSpec frame = windowOf(16382, 64, 0, 14960);
        const CasePicture truth = truthOf(line, frame);
        QVERIFY(departure(pictureBy(u"line-dda", line, frame), truth).isEmpty());
        QVERIFY(
            departure(pictureBy(u"line-dda", line, frame, Arithmetic::Fixed32), truth).isEmpty());
        QVERIFY(
            !departure(pictureBy(u"line-dda", line, frame, Arithmetic::Float32), truth).isEmpty());
    }

    void aWindowShowsWhatTheWholeFrameShows()
    {
        QRandomGenerator random(7);
        for (const QString &method :
             {QStringLiteral("line-dda"), QStringLiteral("line-slope-intercept"),
              QStringLiteral("line-bresenham"), QStringLiteral("line-bresenham-symmetric")}) {
            for (int round = 0; round < 60; ++round) {
                const Shape line = randomLine(random, 64 * unitsPerPixel);
                const CasePicture whole = pictureBy(method, line, windowOf(160, 160, -80, -80));
                const CasePicture window = pictureBy(method, line, windowOf(31, 17, -13, -5));
                for (std::int64_t y = -5; y < 12; ++y) {
                    for (std::int64_t x = -13; x < 18; ++x)
                        QVERIFY2(window.isWritten(x, y) == whole.isWritten(x, y),
                                 qPrintable(QStringLiteral("seed 7, ") + method + nameOf(line)));
                }
            }
        }
    }

    void tracingChangesNothingAndReplays_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<Arithmetic>("arithmetic");
        for (const Method &method : methods()) {
            if (method.family != MethodFamily::Lines)
                continue;
            for (const Arithmetic arithmetic : method.arithmetics)
                QTest::addRow("%s %s", qPrintable(method.id), nameOf(arithmetic).data())
                    << method.id << arithmetic;
        }
    }
    void tracingChangesNothingAndReplays()
    {
        QFETCH(QString, method);
        QFETCH(Arithmetic, arithmetic);
        QRandomGenerator random(5);
        Scene scene;
        scene.frame = windowOf(60, 50, -10, -5);
        scene.method = method.toStdString();
        scene.settings.arithmetic = arithmetic;
        for (int i = 0; i < 12; ++i)
            scene.shapes.push_back(randomLine(random, 60 * unitsPerPixel));
        FrameBuffer drawn(scene.frame);
        drawScene(scene, drawn);

        const auto traced = traceScene(scene);

        const ScanTrace &trace = *traced->trace;
        QCOMPARE(replayOf(*traced), drawn.copy());
        QCOMPARE(trace.primitiveCount(), std::size_t(12));
        for (std::size_t span = 0; span < trace.spanCount(); ++span) {
            const SpanRecord record = trace.span(span);
            QCOMPARE(record.cells.size(), traced->method->spanColumns.size());
            QCOMPARE(std::int64_t(trace.samples(span).size()), record.drawnSamples());
        }
        QCOMPARE(trace.setUp(0).cells.size(), traced->method->setUpColumns.size());
    }

    // Drawing takes each line's own integers, a trace the widest of all.
    void aLineBesideAVeryLongOneIsDrawnAsItIsTraced()
    {
        for (const char *method : {"line-dda", "line-slope-intercept"}) {
            Scene scene = sceneOf(lineAtUnits({515, 770}, {7700, 5401}), method, windowOf(40, 40));
            scene.shapes.push_back(
                lineAt(-largestPixel, -largestPixel + 3, largestPixel, largestPixel));
            const FrameBuffer drawn(scene.frame);
            drawScene(scene, drawn);

            const auto traced = traceScene(scene);

            QCOMPARE(replayOf(*traced), drawn.copy());
            QVERIFY(traced->trace->sampleCount() > 60);
        }
    }

    void stepsOfALongLineStayWithinTheFrame()
    {
        for (const char *method :
             {"line-dda", "line-slope-intercept", "line-bresenham", "line-bresenham-symmetric"}) {
            const auto traced = traceScene(
                sceneOf(lineAt(-largestPixel, -largestPixel + 3, largestPixel, largestPixel),
                        method, windowOf(16, 16)));
            QCOMPARE(traced->trace->spanCount(), std::size_t(16));
        }
    }

    // What literal forms get wrong in the catalogue of hard cases, each for its reason.
    void hardCasesAreFailedByTheFormsThatTheyStress_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::addColumn<QStringList>("failed");
        QTest::newRow("DDA, exact") << "line-dda" << Arithmetic::Exact << QStringList();
        QTest::newRow("DDA, float32 drifts") << "line-dda" << Arithmetic::Float32
                                             << QStringList({QStringLiteral("line_long_16381")});
        QTest::newRow("Bresenham, ties by direction")
            << "line-bresenham" << Arithmetic::Exact
            << QStringList({QStringLiteral("line_tie_half")});
        QTest::newRow("Bresenham, same both ways")
            << "line-bresenham-symmetric" << Arithmetic::Exact << QStringList();
        QTest::newRow("y = mx + b: casts, gaps, no slope")
            << "line-slope-intercept" << Arithmetic::Exact
            << QStringList({QStringLiteral("line_negative"), QStringLiteral("line_steep"),
                            QStringLiteral("line_vertical"), QStringLiteral("line_point"),
                            QStringLiteral("line_diagonal")});
    }
    void hardCasesAreFailedByTheFormsThatTheyStress()
    {
        QFETCH(QString, method);
        QFETCH(Arithmetic, arithmetic);
        QFETCH(QStringList, failed);
        const auto text = readFile(QFINDTESTDATA("data/hard_cases.json"));
        QVERIFY(text.isOk());
        const auto cases = readHardCases(*text);
        QVERIFY(cases.isOk());
        int lines = 0;
        QStringList found;
        for (const HardCase &hardCase : *cases) {
            if (hardCase.kind != HardCaseKind::Line)
                continue;
            ++lines;
            const CaseReport report = checkCase(
                hardCase,
                {{methodNamed(method), {arithmetic, FillRule::Closed, ByteRounding::Nearest}}});
            QCOMPARE(report.verdicts.size(), std::size_t(1));
            if (report.summary() == CaseOutcome::FellShort)
                found.append(hardCase.id);
        }
        QCOMPARE(lines, 8);
        QCOMPARE(found, failed);
    }

    void aLineCaseUnderAnotherRuleIsRefused()
    {
        const auto cases = readHardCases(
            R"({"version": 1, "cases": [{"id": "a", "kind": "line", "rule": "up", "endpoints": [[0, 0], [1, 1]]}]})");

        QVERIFY(!cases.isOk());
        QVERIFY(cases.error().message().contains(u"cases[0].rule: “up”; expected “major axis"));
    }

    void pointsAreWrittenToTheirAddress()
    {
        Shape points;
        points.kind = PrimitiveKind::Point;
        points.vertices = {{latticePixel(3, 2), {{0, 0, 255}}},
                           {{4 * 256 + 128, 127}, {{255, 0, 0}}},
                           {latticePixel(9, 9), {{0, 255, 0}}}};
        const Scene scene = sceneOf(points, "point-address", windowOf(6, 6));

        const QStringList table
            = tableOf(scene, {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("addr")});

        // Seed 002, "Point Plotting": (3, 2) in a frame of width 6 is at 2·6 + 3.
        QCOMPARE(table,
                 QStringList(
                     {QStringLiteral("3 2 15"), QStringLiteral("5 0 5"), QStringLiteral("9 9 -")}));
        QVERIFY(departure(pictureBy(u"point-address", points, scene.frame),
                          truthOf(points, scene.frame))
                    .isEmpty());
        QCOMPARE(textOf(truthOf(points, windowOf(6, 3))),
                 QStringLiteral("...#..\n......\n.....#\n"));
    }
};

QTEST_GUILESS_MAIN(TestLines)
#include "tst_lines.moc"
