// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/labcomparison.h"
#include "core/lab/labfile.h"
#include "tests/support/defaultscene.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <functional>

namespace tst_labfile {

using namespace pixelplumb;

namespace {

/// With all that a file can hold: measured and failed rows, times, misses.
const Study &measuredStudy()
{
    static const Study study = [] {
        StudySettings settings;
        settings.ownScene = std::make_shared<const Scene>(defaultSceneIn(Arithmetic::Exact, 2));
        settings.families = {QStringLiteral("own-scene"), QStringLiteral("ties")};
        settings.contenders = {*labContenderNamed(QStringLiteral("column-scan:float32")),
                               *labContenderNamed(QStringLiteral("column-scan:exact:fast"))};
        settings.rounds = 2;
        settings.growthRounds = 0;
        settings.longestDrawSeconds = 3600; // whatever the machine
        settings.seed = 18'446'744'073'709'551'615U;
        return runStudy(settings);
    }();
    return study;
}

QByteArray replaced(QByteArray text, const QByteArray &before, const QByteArray &after)
{
    return text.replace(text.indexOf(before), before.size(), after);
}

} // namespace

class TestLabFile : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenIsRead()
    {
        const QByteArray text = writeStudy(measuredStudy());

        const Result<Study> read = readStudy(text);

        QVERIFY2(bool(read), read ? "" : qPrintable(read.error().message()));
        QVERIFY(measuredStudy().rows[0].firstMiss.has_value());
        QVERIFY(read->rows == measuredStudy().rows);
        QVERIFY(*read == measuredStudy());
        QVERIFY(writeStudy(*read) == text);
    }

    void filesOfTheFirstVersionAreRead()
    {
        QByteArray text = writeStudy(measuredStudy());
        text.replace("            \"kernel\": \"plain\",\n", "");
        text.replace("            \"kernel\": \"SIMD\",\n", "");
        QVERIFY(!text.contains("kernel\""));
        text = replaced(text, "\"pixelplumbLab\": 3", "\"pixelplumbLab\": 1");
        for (const char *key : {"drift", "growth"}) {
            const qsizetype begin = text.indexOf(QByteArray("    \"") + key);
            text.remove(begin, text.indexOf(']', begin) + 3 - begin);
        }
        QVERIFY(!text.contains("growth"));

        const Result<Study> read = readStudy(text);

        QVERIFY2(bool(read), read ? "" : qPrintable(read.error().message()));
        QVERIFY(*read == measuredStudy());
    }

    void curvesAreKept()
    {
        Study study = measuredStudy();
        study.drift = {{Arithmetic::Float32, {{1, 0.25, 0.5}, {2, 0.375, 1}}}};
        study.growth
            = {{QStringLiteral("column-scan:exact"), SizeAxis::Area, {{13, {1, 2, 3}}}, {}},
               {QStringLiteral("column-scan:exact"), SizeAxis::Width, {}, 1.5}};

        const Result<Study> read = readStudy(writeStudy(study));

        QVERIFY2(bool(read), read ? "" : qPrintable(read.error().message()));
        QVERIFY(*read == study);
    }

    void whatIsNotMeasuredIsNotInTheFile()
    {
        const QByteArray text = writeStudy(measuredStudy());

        QVERIFY(!text.contains("\"gaps\""));
        QVERIFY(text.contains("\"flicker\"") == false);
        QVERIFY(text.contains("\"levels\""));
    }

    void faultsAreNamed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("part");
        const QByteArray text = writeStudy(measuredStudy());
        QTest::newRow("nothing") << QByteArray() << QStringLiteral("JSON");
        QTest::newRow("cut short") << text.left(text.size() / 2) << QStringLiteral("line ");
        QTest::newRow("no object") << QByteArray("[1]") << QStringLiteral("expected");
        QTest::newRow("another kind of file")
            << QByteArray("{ \"pixelplumb\": 1 }") << QStringLiteral("no “pixelplumbLab”");
        QTest::newRow("newer version")
            << replaced(text, "\"pixelplumbLab\": 3", "\"pixelplumbLab\": 7")
            << QStringLiteral("pixelplumbLab: 7; expected 1 to 3");
        QTest::newRow("version of another type")
            << replaced(text, "\"pixelplumbLab\": 3", "\"pixelplumbLab\": \"1\"")
            << QStringLiteral("expected 1 to 3");
        QTest::newRow("contender without its kernel")
            << QByteArray(text).replace("            \"kernel\": \"plain\",\n", "")
            << QStringLiteral("kernel");
        QTest::newRow("text for a number")
            << replaced(text, "\"rounds\": 2", "\"rounds\": \"2\"") << QStringLiteral("rounds");
        QTest::newRow("number for a flag")
            << replaced(text, "\"complete\": true", "\"complete\": 1")
            << QStringLiteral("complete: 1; expected true or false");
        QTest::newRow("unknown outcome")
            << replaced(text, "\"outcome\": \"measured\"", "\"outcome\": \"lost\"")
            << QStringLiteral("expected one of pending, measured");
        QTest::newRow("unknown key")
            << replaced(text, "\"rounds\": 2", "\"laps\": 2") << QStringLiteral("laps");
        QTest::newRow("seed that is no number")
            << replaced(text, "\"18446744073709551615\"", "\"many\"")
            << QStringLiteral("expected a whole number as text");
    }
    void faultsAreNamed()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QString, part);

        const Result<Study> read = readStudy(text);

        QVERIFY(!read);
        QVERIFY2(read.error().message().contains(part), qPrintable(read.error().message()));
    }

    void everyLineOfTheCsvHasTheHeadersFields()
    {
        const QList<QByteArray> lines = csvOf(measuredStudy()).trimmed().split('\n');

        QCOMPARE(lines.size(), qsizetype(measuredStudy().rows.size()) + 1);
        const qsizetype fields = lines.front().split(',').size();
        QVERIFY(lines.front().startsWith("contender,family,outcome,remark,"));
        QVERIFY(lines.front().contains("accuracy.tiesMissing"));
        const qsizetype divisions
            = lines.front().split(',').indexOf("cost.operations.span divisions");
        QVERIFY(divisions > 0);
        const auto &operations = measuredStudy().rows[0].cost->operations;
        QCOMPARE(lines[1].split(',').at(divisions).toLongLong(),
                 operations->of(WorkStage::Span, Operation::Division));
        for (const QByteArray &line : lines)
            QCOMPARE(line.split(',').size(), fields);
    }

    void aStudyIsWithinTheSpreadOfItself()
    {
        const LabComparison comparison = compareStudies(measuredStudy(), measuredStudy());

        QCOMPARE(comparison.count(LabChange::WithinSpread),
                 std::int64_t(measuredStudy().rows.size()));
        QVERIFY(comparison.remarks.isEmpty());
        QVERIFY(!comparison.rows[0].isAccuracyChanged());
    }

    void whatElseDiffersIsRemarked_data()
    {
        using Change = std::function<void(Study &)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("remark");
        QTest::addColumn<int>("notComparable");
        const auto row
            = [](const char *name, const Change &change, const char *remark, int notComparable) {
                  QTest::newRow(name) << change << QString::fromLatin1(remark) << notComparable;
              };
        row(
            "machine", [](Study &study) { study.conditions.processor = "Z80"; }, "machine: ", 0);
        row(
            "build", [](Study &study) { study.conditions.buildType = "Tiny"; }, "build type: ", 0);
        row(
            "sanitizers",
            [](Study &study) {
                study.conditions.sanitizers = {"a", "b"};
            },
            "sanitizers: none before, a, b after", 0);
        row(
            "instructions", [](Study &study) { study.conditions.instructionSet = "z"; },
            "instruction set: ", 0);
        row(
            "extent", [](Study &study) { study.extent = StudyExtent::Full; },
            "extent: quick before, full after", 0);
        row(
            "end", [](Study &study) { study.isComplete = false; },
            "study: complete before, ended early after", 0);
        row(
            "settings", [](Study &study) { study.rows[0].settings.fillRule = FillRule::Open; },
            "other settings, times not compared: column-scan:float32 on ", 1);
        row(
            "own scene",
            [](Study &study) {
                for (StudyFamily &family : study.families) {
                    if (family.id == QStringLiteral("own-scene"))
                        family.digest = QStringLiteral("of another");
                }
            },
            "own scene: 2 triangles, ", 2);
        row(
            "other triangles",
            [](Study &study) {
                for (StudyFamily &family : study.families) {
                    if (family.id == QStringLiteral("ties"))
                        family.digest = QStringLiteral("of another");
                }
            },
            "other triangles, times not compared: ties", 2);
        row(
            "no own scene",
            [](Study &study) {
                std::erase_if(study.families, [](const StudyFamily &family) {
                    return family.id == QStringLiteral("own-scene");
                });
            },
            "own scene: 2 triangles, ", 2);
    }
    void whatElseDiffersIsRemarked()
    {
        QFETCH(const std::function<void(Study &)>, change);
        QFETCH(const QString, remark);
        QFETCH(const int, notComparable);
        Study before = measuredStudy();
        before.conditions.sanitizers = {}; // which this test may be compiled with
        Study after = before;
        change(after);

        const LabComparison comparison = compareStudies(before, after);

        QCOMPARE(comparison.remarks.size(), 1);
        QVERIFY2(comparison.remarks.front().startsWith(remark),
                 qPrintable(comparison.remarks.front()));
        QCOMPARE(comparison.count(LabChange::NotComparable), notComparable);
        QCOMPARE(comparison.count(LabChange::Faster) + comparison.count(LabChange::Slower), 0);
    }

    void otherSeedsDrawOtherTrianglesWhichAreNotCompared()
    {
        StudySettings settings;
        settings.families = {QStringLiteral("ties")};
        settings.contenders = {*labContenderNamed(QStringLiteral("column-scan:float32"))};
        settings.rounds = 1;
        settings.growthRounds = 0;
        const Study before = runStudy(settings);
        settings.seed = 2;
        const Study after = runStudy(settings);

        const LabComparison comparison = compareStudies(before, after);

        QCOMPARE(comparison.count(LabChange::NotComparable), 1);
        QVERIFY(!comparison.isWorse());
        QVERIFY(before.families.front().digest != after.families.front().digest);
    }

    void changesBeyondTheSpreadAreTold()
    {
        Study after = measuredStudy();
        Spread &faster = after.rows[0].cost->perDraw;
        faster = {faster.lower / 9, faster.lower / 8, faster.lower / 7};
        Spread &slower = after.rows[1].cost->perDraw;
        slower = {slower.upper * 7, slower.upper * 8, slower.upper * 9};
        after.rows[2].accuracy->wrongBytes += 1;
        after.rows[3].cost.reset();
        after.seed = 1;

        const LabComparison comparison = compareStudies(measuredStudy(), after);

        QVERIFY(comparison.rows[0].change == LabChange::Faster);
        QVERIFY(comparison.rows[1].change == LabChange::Slower);
        QVERIFY(comparison.rows[2].isAccuracyChanged());
        QVERIFY(comparison.rows[3].change == LabChange::NotComparable);
        QCOMPARE(comparison.remarks.size(), 1);
        QVERIFY(textOf(comparison).last().startsWith(QStringLiteral("1 faster, 1 slower, 1 ")));
    }

    void whatIsWorseIsToldFromWhatIsOther_data()
    {
        using Change = std::function<void(Study &)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("summary"); // the end of the last line
        QTest::addColumn<bool>("isWorse");
        const auto row
            = [](const char *name, const Change &change, const char *summary, bool isWorse) {
                  QTest::newRow(name) << change << QString::fromLatin1(summary) << isWorse;
              };
        row(
            "nothing", [](Study &) {}, "0 less accurate, 0 missing", false);
        row(
            "more wrong pixels", [](Study &study) { study.rows[0].accuracy->wrongBytes += 1; },
            "1 less accurate, 0 missing", true);
        row(
            "fewer wrong pixels", [](Study &study) { study.rows[0].accuracy->pixels *= 2; },
            "0 less accurate, 0 missing", false);
        row(
            "more wrong pixels under another rule",
            [](Study &study) {
                study.rows[0].accuracy->wrongBytes += 1;
                study.rows[0].settings.fillRule = FillRule::Open;
            },
            "0 less accurate, 0 missing", false);
        row(
            "a row is gone", [](Study &study) { study.rows.pop_back(); },
            "0 less accurate, 1 missing", true);
        row(
            "a contender failed", [](Study &study) { study.rows[0].outcome = LabOutcome::Failed; },
            "0 less accurate, 1 missing", true);
        row(
            "slower",
            [](Study &study) {
                Spread &slower = study.rows[0].cost->perDraw;
                slower = {slower.upper * 7, slower.upper * 8, slower.upper * 9};
            },
            "0 less accurate, 0 missing", true);
    }
    void whatIsWorseIsToldFromWhatIsOther()
    {
        QFETCH(const std::function<void(Study &)>, change);
        QFETCH(const QString, summary);
        QFETCH(const bool, isWorse);
        Study after = measuredStudy();
        QVERIFY(after.rows[0].accuracy->wrongPixels() > 0);
        change(after);

        const LabComparison comparison = compareStudies(measuredStudy(), after);

        QVERIFY2(textOf(comparison).last().endsWith(summary),
                 qPrintable(textOf(comparison).last()));
        QCOMPARE(comparison.isWorse(), isWorse);
        QVERIFY(!compareStudies(after, after).isWorse());
    }
};

PIXELPLUMB_TEST(TestLabFile)

} // namespace tst_labfile

#include "tst_labfile.moc"
