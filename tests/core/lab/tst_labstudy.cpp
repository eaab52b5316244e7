// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/labfile.h"
#include "core/lab/study/scenecost.h"
#include "core/lab/study/study.h"
#include "tests/support/caselist.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <stdexcept>

namespace tst_labstudy {

using namespace pixelplumb;

namespace {

std::vector<LabContender> contendersOf(const QStringList &ids)
{
    std::vector<LabContender> contenders;
    for (const QString &id : ids)
        contenders.push_back(*labContenderNamed(id));
    return contenders;
}

/// A study of the current scene alone: quick.
StudySettings smallStudy()
{
    StudySettings settings;
    settings.ownScene = std::make_shared<const Scene>(defaultSceneIn(Arithmetic::Exact));
    settings.families = {u"own-scene"_s};
    settings.contenders = contendersOf(
        {u"column-scan:exact"_s, u"column-scan:float32"_s, u"column-scan:exact:fast"_s});
    settings.rounds = 0;
    settings.longestDrawSeconds = 3600; // on any machine
    return settings;
}

LabContender thrower()
{
    LabContender contender = *labContenderNamed(u"row-walk:exact"_s);
    contender.draw = [](const Run &, FrameView) { throw std::runtime_error("out of luck"); };
    return contender;
}

} // namespace

class TestLabStudy : public QObject {
    Q_OBJECT

private slots:
    void sameSeedSameBytes()
    {
        StudySettings settings = smallStudy();
        settings.families = {u"far"_s, u"own-scene"_s};
        settings.seed = 5;

        const QByteArray first = writeAccuracy(runStudy(settings));
        const QByteArray second = writeAccuracy(runStudy(settings));
        settings.seed = 6;
        const QByteArray other = writeAccuracy(runStudy(settings));

        QVERIFY(first.size() > 1000);
        QVERIFY(first == second);
        QVERIFY(first != other);
    }

    void leavingAFamilyOutChangesNoOther()
    {
        StudySettings settings = smallStudy();
        settings.ownScene = nullptr;
        settings.contenders.resize(1);
        settings.families = {u"ties"_s, u"far"_s};

        const Study both = runStudy(settings);
        settings.families = {u"far"_s};
        const Study alone = runStudy(settings);

        QCOMPARE(both.rows.size(), std::size_t(2));
        QCOMPARE(alone.rows.size(), std::size_t(1));
        QVERIFY(both.rows[1].withoutTimes() == alone.rows[0].withoutTimes());
        QVERIFY(both.rows[0].withoutTimes() != alone.rows[0].withoutTimes());
    }

    void everyFamilyMakesTriangles()
    {
        FamilyRequest request;
        request.ownScene = std::make_shared<const Scene>(defaultSceneIn(Arithmetic::Exact));
        HardCase hardCase;
        hardCase.triangles = request.ownScene->triangles;
        request.hardCases = {hardCase};

        QCOMPARE(labFamilies().size(), std::size_t(10));
        for (const LabFamilyInfo &info : labFamilies()) {
            const auto family = makeFamily(info, request);
            QVERIFY2(family.has_value(), info.id);
            QVERIFY2(family->triangleCount() > 0, info.id);
            QCOMPARE(family->id, QString::fromLatin1(info.id));
        }
    }

    void aContenderThatFailsIsShownSoAndTheOthersAreMeasured()
    {
        StudySettings settings = smallStudy();
        settings.contenders.insert(settings.contenders.begin(), thrower());
        settings.rounds = 1;

        const Study study = runStudy(settings);

        QVERIFY(study.isComplete);
        QCOMPARE(study.rows.size(), std::size_t(4));
        QCOMPARE(study.rows[0].outcome, LabOutcome::Failed);
        QCOMPARE(study.rows[0].remark, u"out of luck"_s);
        QVERIFY(!study.rows[0].accuracy && !study.rows[0].cost);
        QCOMPARE(study.rows[1].outcome, LabOutcome::Measured);
        QVERIFY(study.perPixel(study.rows[3]).has_value());
    }

    void aContenderThatHangsIsShownSo()
    {
        StudySettings settings = smallStudy();
        settings.contenders[1].draw = [](const Run &run, FrameView frame) {
            for (int i = 0; i < 2000; ++i)
                run.draw(frame);
        };
        settings.hangSeconds = 1e-6;
        settings.contenders.resize(2);

        const Study study = runStudy(settings);

        QCOMPARE(study.rows[1].outcome, LabOutcome::TookTooLong);
        QVERIFY2(study.rows[1].remark.contains(u"of 1 triangles"_s),
                 qPrintable(study.rows[1].remark));
        QVERIFY(!study.rows[1].accuracy);
        QVERIFY(study.isComplete);
    }

    void howMuchIsJudgedDependsOnTheTrianglesNotOnTheSpeed()
    {
        StudySettings settings = smallStudy();
        Scene scene = defaultSceneIn(Arithmetic::Exact, 9);
        scene.frame.width = 640;
        scene.frame.height = 480;
        settings.ownScene = std::make_shared<const Scene>(scene);
        settings.contenders = contendersOf({u"column-scan:exact"_s, u"barycentric-all:float32"_s});
        settings.mostSamples = 30'000; // nine boxes, but less than nine frames
        StudySettings slow = settings;
        slow.hangSeconds = 3600;
        for (LabContender &contender : slow.contenders) {
            contender.draw = [](const Run &run, FrameView frame) {
                for (int i = 0; i < 50; ++i)
                    run.draw(frame);
            };
        }

        const Study study = runStudy(settings);

        QCOMPARE(study.rows[0].outcome, LabOutcome::Measured);
        QCOMPARE(study.rows[1].outcome, LabOutcome::TookTooLong);
        QVERIFY2(study.rows[1].remark.startsWith(u"looked at more than 30000 "_s),
                 qPrintable(study.rows[1].remark));
        QVERIFY(writeAccuracy(study) == writeAccuracy(runStudy(slow)));
    }

    void rowsAreToldAsTheyStandAndACancelledStudyKeepsThem()
    {
        StudySettings settings = smallStudy();
        std::vector<std::size_t> told;
        StudyListener listener;
        listener.rowChanged = [&](const Study &study, std::size_t row) {
            QVERIFY(study.rows[row].accuracy.has_value());
            told.push_back(row);
        };
        listener.progress = [&](const JobProgress &) { return told.size() < 2; };

        const Study study = runStudy(settings, listener);

        QCOMPARE(told, (std::vector<std::size_t>{0, 1}));
        QVERIFY(!study.isComplete);
        QVERIFY(study.rows[1].accuracy.has_value());
        QCOMPARE(study.rows[2].outcome, LabOutcome::Pending);
        QVERIFY(warningsOf(study).join(u'\n').contains(u"was ended before"_s));
    }

    void aStudyThatIsEndedWhileItTimesKeepsItsRounds()
    {
        StudySettings settings = smallStudy();
        settings.rounds = 5;
        StudyListener listener;
        int samples = 0;
        listener.progress = [&](const JobProgress &progress) {
            return progress.phase != JobPhase::Measuring || samples++ < 4;
        };

        const Study study = runStudy(settings, listener);

        QCOMPARE(study.rounds, 1);
        QCOMPARE(study.rows[0].cost->rounds, 1);
        QCOMPARE(study.rows[1].cost->rounds, 2); // the second round begins with this draw
        QVERIFY(warningsOf(study).join(u'\n').contains(u"Only 1 rounds"_s));
    }

    void eachRoundIsReportedImmediatelyWithItsNumber()
    {
        StudySettings settings = smallStudy();
        settings.rounds = 3;
        std::vector<int> rounds;
        StudyListener listener;
        listener.roundDone = [&](const Study &study) {
            rounds.push_back(study.rounds);
            for (const LabRow &row : study.rows)
                QCOMPARE(row.cost->rounds, study.rounds);
        };
        std::size_t rowsTold = 0;
        listener.rowChanged = [&](const Study &study, std::size_t) {
            QCOMPARE(study.rounds, 0);
            ++rowsTold;
        };

        runStudy(settings, listener);

        QCOMPARE(rounds, (std::vector<int>{1, 2, 3}));
        QCOMPARE(rowsTold, std::size_t(3));
    }

    void theProgressOfAWholeStudyIsOneScale()
    {
        StudySettings settings = smallStudy();
        settings.families << u"ties"_s;
        settings.rounds = 2;
        std::vector<JobProgress> told;
        StudyListener listener;
        listener.progress = [&](const JobProgress &progress) {
            told.push_back(progress);
            return true;
        };

        runStudy(settings, listener);

        QVERIFY(told.size() > 10);
        QCOMPARE(told.front().done, std::int64_t(0));
        for (std::size_t i = 1; i < told.size(); ++i) {
            QCOMPARE(told[i].total, told.front().total);
            QVERIFY(told[i].done >= told[i - 1].done);
        }
        QVERIFY(double(told.back().done) / double(told.back().total) > 0.9);
    }

    void aFamilyIsTimedOnceAsSoonAsItIsJudged()
    {
        StudySettings settings = smallStudy();
        settings.families = {u"ties"_s, u"hard-cases"_s};
        settings.hardCases = casesOf(testData("hard_cases.json"));
        settings.rounds = 2;
        std::vector<std::size_t> timed;
        StudyListener listener;
        listener.roundDone = [&](const Study &study) {
            timed.push_back(std::size_t(std::ranges::count_if(
                study.rows, [](const LabRow &row) { return row.cost && row.cost->rounds > 0; })));
        };

        const Study study = runStudy(settings, listener);

        QCOMPARE(study.families.size(), std::size_t(2));
        QVERIFY(study.families[1].timedTriangles > 3); // several pictures
        const std::size_t contenders = study.contenders.size();
        QCOMPARE(timed, (std::vector<std::size_t>{contenders, 2 * contenders, 2 * contenders}));
    }

    void aStudyOfNothingIsEmpty()
    {
        StudySettings settings = smallStudy();
        settings.ownScene = nullptr;

        const Study study = runStudy(settings);

        QVERIFY(study.rows.empty());
        QVERIFY(study.isComplete);
        QCOMPARE(csvOf(study).count('\n'), 1);
    }

    void aFastKernelHasNoNumbersOfItsOwnAndNoStraightLoop()
    {
        StudySettings settings = smallStudy();
        settings.rounds = 1;

        const Study study = runStudy(settings);

        QVERIFY(study.rows[0].accuracy->levels.has_value());
        QVERIFY(study.rows[0].cost->operations.has_value());
        QVERIFY(!study.rows[2].accuracy->levels);
        QVERIFY(!study.rows[2].cost->operations);
        QVERIFY(!study.rows[2].cost->straight);
        QCOMPARE(study.rows[2].accuracy->wrongPixels(), 0);
    }

    void straightLoopsAreTimedInTheSameRounds()
    {
        StudySettings settings = smallStudy();
        settings.families = {u"far"_s, u"small"_s, u"mesh"_s, u"own-scene"_s};
        settings.rounds = 2;

        const Study study = runStudy(settings);

        int timed = 0;
        for (const LabRow &row : study.rows) {
            const bool isPlain = row.contender != u"column-scan:exact:fast"_s;
            if (row.remark.startsWith(u"not timed: a draw takes"_s))
                continue; // a build with sanitizers takes too long
            ++timed;
            QVERIFY(row.cost.has_value());
            QCOMPARE(row.cost->straight.has_value(), isPlain);
            QCOMPARE(row.cost->timesStraight.has_value(), isPlain);
        }
        QVERIFY(timed >= 6);
        QCOMPARE(study.family(u"small"_s)->timedTriangles, 3000);
    }

    void theCurrentSceneIsTimedAsTheStudyTimesIt()
    {
        StudySettings settings = smallStudy();
        settings.ownScene = std::make_shared<const Scene>(defaultSceneIn(Arithmetic::Exact, 3));
        settings.rounds = 1;

        const auto cost = costOf(settings.ownScene);
        const Study study = runStudy(settings);

        // Three triangles on top of each other: each pixel is written three times.
        QVERIFY(cost.has_value());
        QCOMPARE(cost->pixels, study.family(u"own-scene"_s)->timedPixels);
        QCOMPARE(cost->pixels % 3, std::int64_t(0));
        QVERIFY(cost->rounds > 0);
        QVERIFY(cost->details().contains(u"median of "_s));
    }

    void withoutTrianglesOrWithoutPatienceThereIsNoCost()
    {
        Scene lines;
        lines.method = "line-bresenham";
        Shape line;
        line.kind = PrimitiveKind::Line;
        line.vertices = {{latticePixel(1, 1), {{255, 0, 0}}}, {latticePixel(8, 4), {{255, 0, 0}}}};
        lines.shapes = {line};

        QVERIFY(!costOf(std::make_shared<const Scene>()));
        QVERIFY(!costOf(std::make_shared<const Scene>(lines)));
        QVERIFY(!costOf(std::make_shared<const Scene>(defaultSceneIn(Arithmetic::Exact)),
                        [](const JobProgress &) { return false; }));
    }

    void theCommandDoesItAgain_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("words");
        const auto row = [](const char *name, const char *path, const char *quoted) {
            QTest::newRow(name) << QString::fromUtf8(path)
                                << u"pixelplumb-cli lab "_s + QString::fromUtf8(quoted);
        };
        row("plain", "/a/b-c_1.json", "/a/b-c_1.json");
        row("standard input", "-", "-");
        row("spaces", "my scene.json", "'my scene.json'");
        row("quotes", "it's.json", "'it'\\''s.json'");
        row("what a shell would expand", "$HOME*.json", "'$HOME*.json'");
        row("two lines", "a\n", "'a\n'");
        row("like an option", "-full", "./-full");
        QTest::newRow("no file") << QString() << QString();
    }
    void theCommandDoesItAgain()
    {
        QFETCH(const QString, path);
        QFETCH(const QString, words);
        StudySettings settings = smallStudy();
        settings.ownSceneName = path;
        settings.mostSamples = 1;
        settings.rounds = 0;

        const QString options = u" --quick --seed 1 --family own-scene --contender "
                                "column-scan:exact,column-scan:float32,column-scan:exact:fast"_s;
        QCOMPARE(runStudy(settings).command, words.isEmpty() ? QString() : words + options);
    }

    void spansAreThoseOfTheMethod_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<std::int64_t>("spans");
        constexpr std::int64_t columns = 7, rows = 5;
        QTest::newRow("column scan") << u"column-scan:exact"_s << columns;
        QTest::newRow("fast kernel") << u"column-scan:exact:fast"_s << columns;
        QTest::newRow("row walk") << u"row-walk:float32"_s << rows;
        QTest::newRow("row walk at a constant rate") << u"row-walk-constant-rate:float32"_s << rows;
        QTest::newRow("column scan at a constant rate")
            << u"column-scan-constant-rate:float32"_s << columns;
        QTest::newRow("nobody") << u"nobody:exact"_s << columns;
    }
    void spansAreThoseOfTheMethod()
    {
        QFETCH(const QString, id);
        QFETCH(const std::int64_t, spans);
        StudyFamily family;
        family.timedColumns = 7;
        family.timedRows = 5;

        QCOMPARE(family.timedSpans(id), spans);
    }

    void contendersAreFoundByTheirIds()
    {
        QCOMPARE(quickContenders().size(), std::size_t(15));
        for (const LabContender &contender : fullContenders()) {
            const auto found = labContenderNamed(contender.id);
            QVERIFY2(found.has_value(), qPrintable(contender.id));
            QCOMPARE(found->label, contender.label);
            QVERIFY(contender.isProved() == !contender.domain().isEmpty());
        }
        QVERIFY(!labContenderNamed(u"row-walk:exact:fast"_s));
        QVERIFY(!labContenderNamed(u"line-dda:exact"_s));
        QVERIFY(!labContenderNamed(u"column-scan"_s));
    }
};

PIXELPLUMB_TEST(TestLabStudy)

} // namespace tst_labstudy

#include "tst_labstudy.moc"
