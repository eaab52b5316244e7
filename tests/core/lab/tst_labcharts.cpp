// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/budget.h"
#include "core/lab/study/costorder.h"
#include "core/lab/study/pareto.h"
#include "core/oracle/truepicture.h"
#include "core/runs/contender.h"
#include "core/runs/tracedscene.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QFile>
#include <QTest>

#include <cmath>

namespace tst_labcharts {

using namespace pixelplumb;

namespace {

/// ns per pixel, wrong pixels in a million, the largest byte error.
struct MadeRow {
    const char *contender;
    double perPixel;
    std::int64_t wrongBytes;
    int byteError;
    bool isProved = false;
};

/// A study of a million pixels of one family, with made-up figures.
Study studyOf(const std::vector<MadeRow> &made)
{
    Study study;
    StudyFamily family;
    family.id = u"f"_s;
    family.triangles = 100;
    family.timedTriangles = 10;
    family.timedPixels = 1000;
    study.families = {family};
    for (const MadeRow &row : made) {
        const QString id = QString::fromLatin1(row.contender);
        study.contenders.push_back({id, id, kernelOf(id), row.isProved, u"all"_s, {}});
        LabRow measured;
        measured.contender = id;
        measured.family = family.id;
        measured.outcome = LabOutcome::Measured;
        measured.accuracy.emplace().pixels = 1'000'000;
        measured.accuracy->wrongBytes = row.wrongBytes;
        measured.accuracy->largestByteError = row.byteError;
        const double draw = row.perPixel * 1000;
        measured.cost.emplace().perDraw = {draw * 0.9, draw, draw * 1.1};
        measured.cost->rounds = 5;
        study.rows.push_back(measured);
    }
    return study;
}

const Study &exampleStudy()
{
    static const Study study = studyOf({{"column-scan:float32", 2.0, 50, 1},
                                        {"cheap", 1.0, 100, 7},
                                        {"lucky", 1.5, 0, 0},
                                        {"proved", 3.0, 0, 0, true},
                                        {"dearer proved", 4.0, 0, 0, true},
                                        {"few", 1.8, 5, 1}});
    return study;
}

QStringList frontierOf(const ParetoChart &chart, LabKernel kernel = LabKernel::Plain)
{
    QStringList names;
    for (const std::size_t index : chart.frontier(kernel))
        names << chart.points[index].contender;
    return names;
}

} // namespace

class TestLabCharts : public QObject {
    Q_OBJECT

private slots:
    void theFrontierHoldsUnbeatenContenders()
    {
        const ParetoChart chart = paretoOf(exampleStudy(), u"f"_s, *errorAxisNamed("wrong-pixels"));

        QCOMPARE(chart.points.size(), std::size_t(6));
        QCOMPARE(frontierOf(chart), (QStringList{"cheap", "lucky", "proved"}));
    }

    void theStaircaseGoesRightAndThenDown()
    {
        const ParetoChart chart = paretoOf(exampleStudy(), u"f"_s, *errorAxisNamed("wrong-pixels"));

        const std::vector<StaircaseCorner> expected = {{1.0, ErrorClass::Positive, 100},
                                                       {1.5, ErrorClass::Positive, 100},
                                                       {1.5, ErrorClass::ZeroObserved, 0},
                                                       {3.0, ErrorClass::ZeroObserved, 0},
                                                       {3.0, ErrorClass::ZeroProved, 0}};
        QVERIFY(chart.staircase(LabKernel::Plain) == expected);
        QVERIFY(chart.staircase(LabKernel::Fast).empty());
    }

    void noSimdKernelBeatsAPlainOneNorTheReverse()
    {
        const ParetoChart chart = paretoOf(studyOf({{"cheap", 1.0, 100, 7},
                                                    {"proved", 3.0, 0, 0, true},
                                                    {"wrong:fast", 0.2, 50, 1},
                                                    {"proved:fast", 0.1, 0, 0, true},
                                                    {"lucky:fast", 0.05, 0, 0}}),
                                           u"f"_s, *errorAxisNamed("wrong-pixels"));

        QCOMPARE(frontierOf(chart), (QStringList{"cheap", "proved"}));
        QCOMPARE(frontierOf(chart, LabKernel::Fast), (QStringList{"lucky:fast", "proved:fast"}));
        const std::vector<StaircaseCorner> expected = {{0.05, ErrorClass::ZeroObserved, 0},
                                                       {0.1, ErrorClass::ZeroObserved, 0},
                                                       {0.1, ErrorClass::ZeroTested, 0}};
        QVERIFY(chart.staircase(LabKernel::Fast) == expected);
        QVERIFY(!chart.points[2].isOnFrontier);
    }

    void errorsWithoutATimeWait()
    {
        Study study = exampleStudy();
        study.rows[1].cost.reset();
        study.rows[2].cost->rounds = 0;
        study.rows[3].accuracy.reset();

        const ParetoChart chart = paretoOf(study, u"f"_s, *errorAxisNamed("wrong-pixels"));

        QCOMPARE(chart.points.size(), std::size_t(3));
        QCOMPARE(chart.untimed.size(), std::size_t(2));
        QCOMPARE(chart.untimed[0].contender, u"cheap"_s);
        QCOMPARE(chart.untimed[0].error, 100.0);
        QVERIFY(chart.untimed[1].errorClass == ErrorClass::ZeroObserved);
    }

    void timesNameTheirMethodAndZerosTheirProof()
    {
        const ParetoChart chart = paretoOf(exampleStudy(), u"f"_s, *errorAxisNamed("wrong-pixels"));

        QCOMPARE(chart.points[0].timesReference, std::optional(1.0));
        QCOMPARE(chart.points[3].timesReference, std::optional(1.5));
        QCOMPARE(chart.points[0].cost.upper, 2.2);
        QVERIFY(chart.points[2].errorClass == ErrorClass::ZeroObserved);
        QVERIFY(chart.points[3].errorClass == ErrorClass::ZeroProved);
        QCOMPARE(chart.points[0].error, 50.0);
    }

    void chartsOfNothingAndOfOnePointStand()
    {
        const ErrorAxis &axis = *errorAxisNamed("wrong-pixels");
        const ParetoChart nothing = paretoOf(Study(), u"f"_s, axis);
        const ParetoChart one = paretoOf(studyOf({{"only", 1, 3, 1}}), u"f"_s, axis);

        QVERIFY(nothing.points.empty() && nothing.staircase(LabKernel::Plain).empty());
        QCOMPARE(one.staircase(LabKernel::Plain).size(), std::size_t(1));
        QVERIFY(!one.points[0].timesReference);
    }

    void anAxisWithoutAFigureHasNoPoints()
    {
        QVERIFY(paretoOf(exampleStudy(), u"f"_s, *errorAxisNamed("level-max")).points.empty());
        QVERIFY(!errorAxisNamed("no such axis"));
    }

    void aBudgetNamesTheCheapestThatMeetsIt_data()
    {
        QTest::addColumn<QByteArray>("budget");
        QTest::addColumn<QString>("contender");
        QTest::addColumn<bool>("byProof");
        QTest::newRow("exact") << QByteArray("exact") << u"proved"_s << true;
        QTest::newRow("1-level") << QByteArray("1-level") << u"lucky"_s << false;
        QTest::newRow("10-ppm") << QByteArray("10-ppm") << u"lucky"_s << false;
        QTest::newRow("16-ms") << QByteArray("16-ms") << u"lucky"_s << false;
    }
    void aBudgetNamesTheCheapestThatMeetsIt()
    {
        QFETCH(const QByteArray, budget);
        QFETCH(const QString, contender);
        QFETCH(const bool, byProof);

        const BudgetAnswer answer
            = cheapestFor(*budgetNamed(budget.toStdString()), exampleStudy(), u"f"_s);

        QCOMPARE(answer.contender, contender);
        QCOMPARE(answer.ground == BudgetGround::Proof, byProof);
        QVERIFY2(
            answer.reason.contains(byProof ? u"proved for all"_s : u"0 wrong of 1000000 pixels"_s),
            qPrintable(answer.reason));
    }

    void aTimeIsNeverProved()
    {
        Study study = exampleStudy();
        std::erase_if(study.rows, [](const LabRow &row) { return row.contender != u"proved"_s; });

        const auto answer = cheapestFor(Budget::SixteenMilliseconds, study, u"f"_s);

        QCOMPARE(answer.contender, u"proved"_s);
        QCOMPARE(answer.ground, BudgetGround::Measurement);
    }

    void aBudgetThatNobodyMeetsSaysSo()
    {
        const Study study = studyOf({{"wrong", 1, 500, 9}});

        const BudgetAnswer answer = cheapestFor(Budget::Exact, study, u"f"_s);

        QCOMPARE(answer.ground, BudgetGround::Nobody);
        QVERIFY(answer.contender.isEmpty());
    }

    void whoWasNotTimedMeetsABudgetOfErrorsAfterAllOthers()
    {
        Study study = studyOf({{"slow", 2000, 0, 0, true}, {"untimed", 1, 0, 0, true}});
        study.rows.back().cost.reset();
        Study none = study;
        none.rows.erase(none.rows.begin());

        QCOMPARE(cheapestFor(Budget::Exact, study, u"f"_s).contender, u"slow"_s);
        const BudgetAnswer answer = cheapestFor(Budget::Exact, none, u"f"_s);
        QCOMPARE(answer.contender, u"untimed"_s);
        QVERIFY2(answer.reason.contains(u"not timed"_s), qPrintable(answer.reason));
        QCOMPARE(cheapestFor(Budget::SixteenMilliseconds, none, u"f"_s).ground,
                 BudgetGround::Nobody);
    }

    void framesAreTimedAsAWholeForSixteenMilliseconds()
    {
        // 1,000 px from a tenth of the triangles: 10,000 px a frame, 20 ms at 2,000 ns each.
        const Study study = studyOf({{"slow", 2000, 0, 0, true}, {"quick", 1000, 900, 9}});

        QCOMPARE(cheapestFor(Budget::SixteenMilliseconds, study, u"f"_s).contender, u"quick"_s);
    }

    void aFitFindsWhatTimesWereMadeOf()
    {
        std::vector<CostPoint> points;
        for (const auto &[triangles, columns, pixels] :
             {std::array{1.0, 10.0, 100.0}, std::array{100.0, 500.0, 1000.0},
              std::array{3.0, 2000.0, 90000.0}, std::array{10.0, 900.0, 900.0}}) {
            points.push_back(
                {triangles, columns, pixels, 30 * triangles + 5 * columns + 1.5 * pixels});
        }

        const auto fit = fitCost(points);

        QVERIFY(fit.has_value());
        QVERIFY(std::abs(fit->perTriangle - 30) < 1e-6);
        QVERIFY(std::abs(fit->perColumn - 5) < 1e-6);
        QVERIFY(std::abs(fit->perPixel - 1.5) < 1e-6);
        QVERIFY(fit->residual < 1e-9);
    }

    void aFitHasNoPartBelowZero()
    {
        const std::vector<CostPoint> points = {
            {10, 100, 1000, 900}, {20, 100, 1000, 850}, {10, 300, 4000, 4000}, {5, 80, 900, 950}};

        const auto fit = fitCost(points);

        QVERIFY(fit.has_value());
        QVERIFY(fit->perTriangle >= 0 && fit->perColumn >= 0 && fit->perPixel >= 0);
        QVERIFY(fit->residual > 0);
        QVERIFY(!fitCost(std::span(points).first(2)));
    }

    void theOrderOfCostIsSortedAndItsContendersExist()
    {
        double before = 0;
        for (const CostOrderEntry &entry : costOrder()) {
            QVERIFY2(labContenderNamed(QString::fromLatin1(entry.contender)).has_value(),
                     entry.contender);
            QVERIFY2(entry.nanosecondsPerPixel >= before, entry.contender);
            before = entry.nanosecondsPerPixel;
        }
    }

    void theManualPrintsTheOrder()
    {
        QFile manual(resource(u"/man/pixelplumb-cli.1.in"_s));
        QVERIFY(manual.open(QIODevice::ReadOnly));
        QStringList printed;
        for (const QByteArray &line : manual.readAll().split('\n')) {
            if (line.startsWith(".It ") && line.contains(" Ta "))
                printed << QString::fromUtf8(line.mid(4)).remove(u'\\');
        }
        QStringList order;
        for (const CostOrderEntry &entry : costOrder()) {
            order << u"%1 Ta %2"_s.arg(QLatin1String(entry.contender))
                         .arg(entry.nanosecondsPerPixel, 0, 'f', 1);
        }
        QCOMPARE(printed, order);
    }

    void everyRuleHasAMethodThatIsExact_data()
    {
        QTest::addColumn<FillRule>("rule");
        for (const FillRule rule : allFillRules)
            QTest::newRow(nameOf(rule).data()) << rule;
    }
    void everyRuleHasAMethodThatIsExact()
    {
        QFETCH(const FillRule, rule);
        Scene scene = defaultSceneIn(Arithmetic::Float32);
        scene.settings.fillRule = rule;

        const auto choice = firstInOrder(Budget::Exact, scene);

        QVERIFY(choice->contender != nullptr);
        QVERIFY(choice->ground == BudgetGround::Proof);
        QCOMPARE(choice->settings.fillRule, rule);
    }

    /// A choice draws everything the scene needs, or there is no choice.
    void anAccuracyIsChosenForWhatTheSceneCallsFor_data()
    {
        QTest::addColumn<FillRule>("rule");
        QTest::addColumn<Antialiasing>("antialiasing");
        QTest::addColumn<bool>("isDrawn");
        for (const Antialiasing antialiasing : {Antialiasing::None, Antialiasing::Samples4}) {
            const char *samples = antialiasing == Antialiasing::None ? "alpha" : "four samples";
            QTest::addRow("%s, closed", samples) << FillRule::Closed << antialiasing << true;
            QTest::addRow("%s, off-screen-point", samples)
                << FillRule::OffScreenPoint << antialiasing << false;
        }
    }
    void anAccuracyIsChosenForWhatTheSceneCallsFor()
    {
        QFETCH(FillRule, rule);
        QFETCH(Antialiasing, antialiasing);
        QFETCH(bool, isDrawn);
        Scene scene = defaultSceneIn(Arithmetic::Exact);
        scene.settings.fillRule = rule;
        scene.appearance.antialiasing = antialiasing;
        TriangleAttributes attributes;
        attributes.vertices[1].alpha = 128;
        scene.attributes = {attributes};
        for (const Budget budget : {Budget::Exact, Budget::OneLevel, Budget::TenPerMillion}) {
            const auto choice = firstInOrder(budget, scene);
            QCOMPARE(choice->contender != nullptr, isDrawn);
            if (!isDrawn)
                continue;
            QCOMPARE(choice->ground, BudgetGround::Measurement);
            FrameBuffer truth(scene.frame);
            FrameBuffer drawn(scene.frame);
            drawTruth(scene, truth);
            drawScene(sceneFor(scene, {choice->contender->method, choice->settings}), drawn);
            QVERIFY(drawn.image() == truth.image());
        }
    }
};

PIXELPLUMB_TEST(TestLabCharts)

} // namespace tst_labcharts

#include "tst_labcharts.moc"
