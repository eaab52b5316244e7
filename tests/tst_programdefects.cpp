// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnosis.h"
#include "core/methods/method.h"
#include "core/scene/scenefile.h"
#include "tests/support/sourcetree.h"
#include "tests/support/studentwalk.h"

#include <QDir>
#include <QTest>

#include <algorithm>

using namespace pixelplumb;

Q_DECLARE_METATYPE(std::set<pixelplumb::WalkMistake>)

namespace {

using Mistakes = std::set<WalkMistake>;

std::vector<Scene> sheetOf(const QString &method)
{
    const QDir folder(resource(QStringLiteral("/probes")));
    std::vector<Scene> scenes;
    for (const QString &name : folder.entryList({method + QStringLiteral("-*.json")})) {
        if (const auto reading = readSceneFile(folder.filePath(name)))
            scenes.push_back(reading->scene);
    }
    return scenes;
}

Scene defaultScene(const QString &method)
{
    const auto reading = readSceneFile(resource(QStringLiteral("/scenes/default.json")));
    Scene scene = reading ? reading->scene : Scene();
    scene.method = method.toStdString();
    return scene;
}

WalkLines linesOf(const QString &method)
{
    return method == QStringLiteral("row-walk") ? WalkLines::Rows : WalkLines::Columns;
}

/// What the programs of a class draw, by method: one memory of defects' pictures for all.
DefectPictures &defectPicturesOf(const QString &method)
{
    static DefectPictures ofColumns(sheetOf(QStringLiteral("column-scan")));
    static DefectPictures ofRows(sheetOf(QStringLiteral("row-walk")));
    return method == QStringLiteral("row-walk") ? ofRows : ofColumns;
}

QString textOf(const Diagnosis &diagnosis)
{
    QStringList sets;
    for (const DiagnosisCandidate &candidate : diagnosis.candidates) {
        QStringList ids;
        for (const Defect &defect : candidate.defects)
            ids += defect.id;
        sets += ids.join(u'+') + QStringLiteral(" (%1)").arg(candidate.distance);
    }
    return sets.join(u' ');
}

void addRow(const char *id, const Mistakes &mistakes, const char *method)
{
    QTest::addRow("%s, %s", method, id)
        << QString::fromLatin1(method) << QString::fromLatin1(id) << mistakes;
}

/// Mistakes that go by columns and, from either end, by rows.
void addOfEdges(const char *id, Mistakes mistakes)
{
    addRow(id, mistakes, "column-scan");
    addRow(id, mistakes, "row-walk");
    mistakes.insert(WalkMistake::FromBelow);
    addRow(qPrintable(QString::fromLatin1(id) + QStringLiteral("-from-below")), mistakes,
           "row-walk");
}

/// Of spans, where it does not matter from which end they are gone through.
void addOfSpans(const char *id, Mistakes mistakes)
{
    addRow(id, mistakes, "column-scan");
    addRow(id, mistakes, "row-walk");
}

/// From above the last row is that of the least y.
void addOfEnds(const char *id, const char *fromAbove, Mistakes mistakes)
{
    addRow(id, mistakes, "column-scan");
    addRow(fromAbove, mistakes, "row-walk");
    mistakes.insert(WalkMistake::FromBelow);
    addRow(id, mistakes, "row-walk");
}

} // namespace

/// Defects are those of programs that were not written for them.
class TestProgramDefects : public QObject {
    Q_OBJECT

private slots:
    void aRightProgramIsRight_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("id");
        QTest::addColumn<Mistakes>("mistakes");
        addRow("", {}, "column-scan");
        addRow("from above", {}, "row-walk");
        addRow("from below", {WalkMistake::FromBelow}, "row-walk");
    }
    void aRightProgramIsRight()
    {
        QFETCH(QString, method);
        QFETCH(Mistakes, mistakes);
        for (const Scene &scene : sheetOf(method))
            QCOMPARE(studentPicture(scene, linesOf(method), mistakes).colours,
                     pictureOf(scene).colours);
    }

    void theSheetNamesTheMistakeOfAProgram_data()
    {
        using M = WalkMistake;
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("id");
        QTest::addColumn<Mistakes>("mistakes");
        addOfEdges("no-edge-pre-step", {M::NoEdgePreStep});
        addOfEdges("colours-without-edge-pre-step", {M::NoEdgeColourPreStep});
        addOfEdges("divisor-minus-one", {M::EdgeDivisorMinusOne});
        addOfEdges("divisor-plus-one", {M::EdgeDivisorPlusOne});
        addOfEdges("unsorted-colours", {M::UnsortedColours});
        addOfEdges("whole-slopes", {M::WholeSlopes});
        addOfEdges("whole-edge-colours", {M::WholeEdgeColours});
        addOfEdges("whole-edge-steps", {M::WholeSlopes, M::WholeEdgeColours});
        addOfEdges("whole-colours", {M::WholeEdgeColours, M::WholePreSteps, M::WholeSteps});
        addOfEdges("whole-increments",
                   {M::WholeSlopes, M::WholeEdgeColours, M::WholePreSteps, M::WholeSteps});
        addOfSpans("whole-colour-steps", {M::WholeSteps});
        addOfSpans("whole-colour-rates", {M::WholePreSteps, M::WholeSteps});
        addOfSpans("colour-divisor-plus-one", {M::SpanDivisorPlusOne});
        addOfSpans("colours-between-samples", {M::ColoursBetweenSamples});
        addOfEnds("last-span-missing", "first-span-missing", {M::LastSpanMissing});
        addOfEnds("first-span-missing", "last-span-missing", {M::FirstSpanMissing});
        addOfEnds("open-at-last-vertex", "open-at-first-vertex", {M::OpenAtLastVertex});
        addOfEnds("open-at-first-vertex", "open-at-last-vertex", {M::OpenAtFirstVertex});
        addOfEnds("middle-span-missing", "middle-floor-span-missing", {M::SecondHalfAfterCeiling});
        addOfEnds("middle-floor-span-missing", "middle-span-missing",
                  {M::FirstHalfTruncated, M::SecondHalfAfterFloor});
        addOfEnds("open-at-middle-vertex", "open-at-middle-vertex", {M::SecondHalfAfterFloor});
        addOfEnds("middle-span-truncated", "middle-span-truncated-from-above",
                  {M::FirstHalfTruncated});
        addOfEnds("first-half-missing", "second-half-behind-middle-missing", {M::NoFirstHalf});
        addOfEnds("second-half-missing", "first-half-and-middle-missing", {M::NoSecondHalf});
        addOfEdges("no-pre-step-behind-middle", {M::SecondHalfWithoutPreStep});
        addOfEdges("loops-truncated", {M::LoopsTruncated});
        addOfEdges("floor-slopes", {M::WholeSlopes, M::DividesDown});
        addOfEdges("floor-edge-colours", {M::WholeEdgeColours, M::DividesDown});
        addOfEdges("floor-edge-steps", {M::WholeSlopes, M::WholeEdgeColours, M::DividesDown});
        addOfEdges("floor-colours",
                   {M::WholeEdgeColours, M::WholePreSteps, M::WholeSteps, M::DividesDown});
        addOfEdges(
            "floor-increments",
            {M::WholeSlopes, M::WholeEdgeColours, M::WholePreSteps, M::WholeSteps, M::DividesDown});
        addOfSpans("floor-colour-steps", {M::WholeSteps, M::DividesDown});
        addOfSpans("floor-colour-rates", {M::WholePreSteps, M::WholeSteps, M::DividesDown});
        addOfSpans("whole-span-levels", {M::WholeSpanLevels});
        addOfSpans("middle-above-lost", {M::LongEdgeAlwaysUpper});
        addOfSpans("middle-below-lost", {M::LongEdgeAlwaysLower});
        addOfEdges("whole-levels", {M::WholeEdgeLevels, M::WholeSpanLevels});
    }
    void theSheetNamesTheMistakeOfAProgram()
    {
        QFETCH(QString, method);
        QFETCH(QString, id);
        QFETCH(Mistakes, mistakes);
        DefectPictures &pictures = defectPicturesOf(method);
        std::vector<FoundPicture> found;
        for (const Scene &scene : pictures.scenes())
            found.push_back({found.size(), studentPicture(scene, linesOf(method), mistakes)});

        const Diagnosis diagnosis = *diagnose(pictures, found);

        // Samples on a vertex alone may be missing of a right program, too.
        QVERIFY(diagnosis.verdict != DiagnosisVerdict::Right);
        QVERIFY2(diagnosis.isExplained(), qPrintable(textOf(diagnosis)));
        // A pair may draw the same always: what a stored level loses, a step rounded down does.
        const auto alone
            = std::ranges::count_if(diagnosis.candidates, [](const DiagnosisCandidate &candidate) {
                  return candidate.defects.size() == 1;
              });
        QVERIFY2(alone == 1, qPrintable(textOf(diagnosis)));
        QCOMPARE(diagnosis.candidates.front().defects.front().id, id);
        for (const FoundPicture &each : found) {
            const Scene &scene = pictures.scenes()[each.scene];
            if (each.picture.colours != pictureOf(scene).colours)
                QVERIFY(partingStepOf(scene, diagnosis.candidates.front().defects));
        }
    }

    void aProgramInDoubleHasTheDefectInDouble_data()
    {
        using M = WalkMistake;
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("id");
        QTest::addColumn<Mistakes>("mistakes");
        addOfEdges("no-edge-pre-step", {M::NoEdgePreStep});
        addOfEdges("colours-without-edge-pre-step", {M::NoEdgeColourPreStep});
        addOfEdges("whole-slopes", {M::WholeSlopes});
        addOfEdges("whole-edge-steps", {M::WholeSlopes, M::WholeEdgeColours});
        addOfEdges("whole-colours", {M::WholeEdgeColours, M::WholePreSteps, M::WholeSteps});
        addOfSpans("whole-colour-rates", {M::WholePreSteps, M::WholeSteps});
        addOfSpans("colour-divisor-plus-one", {M::SpanDivisorPlusOne});
    }
    void aProgramInDoubleHasTheDefectInDouble()
    {
        QFETCH(QString, method);
        QFETCH(QString, id);
        QFETCH(Mistakes, mistakes);
        for (Scene scene : sheetOf(method)) {
            const Picture picture = studentPictureInDouble(scene, linesOf(method), mistakes);
            scene.settings.arithmetic = Arithmetic::Float64;
            const std::vector<Defect> defects = defectsFor(scene);
            const auto defect = std::ranges::find(defects, id, &Defect::id);
            QVERIFY(defect != defects.end());
            QCOMPARE(picture.colours, pictureWith(scene, std::span(&*defect, 1)).colours);
        }
    }

    void theDefaultSceneIsDrawnAsTheDefectDrawsIt_data()
    {
        theSheetNamesTheMistakeOfAProgram_data();
    }
    void theDefaultSceneIsDrawnAsTheDefectDrawsIt()
    {
        QFETCH(QString, method);
        QFETCH(QString, id);
        QFETCH(Mistakes, mistakes);
        const Scene scene = defaultScene(method);
        const Picture picture = studentPicture(scene, linesOf(method), mistakes);
        std::vector<Defect> defects = defectsFor(scene);
        const auto defect = std::ranges::find(defects, id, &Defect::id);
        QVERIFY(defect != defects.end());
        QCOMPARE(picture.colours, pictureWith(scene, std::span(&*defect, 1)).colours);
    }

    void eachEndOfTheRowsHasItsOwnWords()
    {
        const std::vector<Defect> all = defectsFor(defaultScene(QStringLiteral("row-walk")));
        const auto words = [&](const char *id) {
            const auto defect = std::ranges::find(all, QLatin1String(id), &Defect::id);
            return defect != all.end() ? defect->forAssistant : QString();
        };
        QVERIFY(words("no-edge-pre-step").contains(QStringLiteral("(y₀ − ⌊y₀⌋)·m")));
        QVERIFY(words("no-edge-pre-step").contains(QStringLiteral("from the greatest y down")));
        QVERIFY(words("no-edge-pre-step-from-below").contains(QStringLiteral("(⌈y₀⌉ − y₀)·m")));
        QVERIFY(words("no-edge-pre-step-from-below").contains(QStringLiteral("the least y up")));
        QVERIFY(words("whole-slopes").contains(QStringLiteral("from the greatest y down")));
        QVERIFY(!words("whole-colour-rates").contains(QStringLiteral("gone through")));
    }

    void aRedrawingPartsWhereItsFirstPixelDiffers()
    {
        const Scene scene = defaultScene(QStringLiteral("column-scan"));
        const std::vector<Defect> all = defectsFor(scene);
        const auto partingText = [&](const char *id) {
            const auto defect = std::ranges::find(all, QLatin1String(id), &Defect::id);
            const auto step = partingStepOf(scene, std::span(&*defect, 1));
            return step ? step->heading + QStringLiteral(": ") + step->text : QString();
        };
        QCOMPARE(partingText("last-sample-missing"),
                 QStringLiteral("Pixel (4, 5): (4, 5) is left out"));
        QCOMPARE(partingText("ends-outward"),
                 QStringLiteral("Column 5, first half: (5, 5) is drawn, which should not be"));
        QCOMPARE(partingText("upside-down"), QString()); // nothing is wrong in its run
    }
};

QTEST_GUILESS_MAIN(TestProgramDefects)
#include "tst_programdefects.moc"
