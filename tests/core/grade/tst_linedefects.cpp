// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/diagnosis.h"
#include "core/scan/linebugs.h"
#include "core/scene/scenefile.h"
#include "tests/support/programs/mistakenprograms.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_linedefects {

using namespace pixelplumb;

namespace {

Scene sheet()
{
    const auto reading = readSceneFile(resource(u"/probes/line-bresenham-1.json"_s));
    return reading ? reading->scene : Scene();
}

/// What bresenham.py draws of a scene, with these mistakes.
Picture drawn(const Scene &scene, const char *start, const char *tie,
              const QStringList &mistakes = {})
{
    const std::vector<Picture> pictures
        = drawnByStudent(u"bresenham"_s, {QString::fromLatin1(start), QString::fromLatin1(tie)},
                         mistakes, std::span(&scene, 1));
    return pictures.empty() ? Picture() : pictures.front();
}

} // namespace

/// The line defects match a program that was not written for them.
class TestLineDefects : public QObject {
    Q_OBJECT

private slots:
    void aRightProgramIsRight()
    {
        QCOMPARE(drawn(sheet(), "left", "crosses").colours, pictureOf(sheet()).colours);
    }

    void theSheetNamesTheMistakeOfAProgram_data()
    {
        QTest::addColumn<QString>("mistake");
        QTest::addColumn<QString>("start");
        QTest::addColumn<QString>("id");
        const auto add = [](const QString &mistake, const char *start, const QString &id) {
            QTest::newRow(qPrintable(id)) << mistake << QString::fromLatin1(start) << id;
        };
        for (const ProgramMistake &mistake : mistakesOf(u"bresenham"_s)) {
            const QString id = mistake.ids.front();
            if (mistake.kind != u"left"_s)
                add(id, "given", id);
            if (mistake.kind != u"given"_s)
                add(id, "left", mistake.kind == u"both"_s ? u"sorted-"_s + id : id);
        }
    }
    void theSheetNamesTheMistakeOfAProgram()
    {
        QFETCH(QString, mistake);
        QFETCH(QString, start);
        QFETCH(QString, id);
        const Scene scene = sheet();
        const std::vector<Submission> submissions
            = {{scene, drawn(scene, qPrintable(start), "crosses", {mistake})}};

        const Diagnosis diagnosis = *diagnose(submissions);

        QCOMPARE(nameOf(diagnosis.verdict), u"wrong"_s);
        QVERIFY(diagnosis.isExplained());
        QCOMPARE(diagnosis.candidates.front().defects.size(), std::size_t(1));
        QCOMPARE(diagnosis.candidates.front().defects.front().id, id);
        QVERIFY(partingStepOf(scene, diagnosis.candidates.front().defects));
    }

    void twoMistakesOfALineAreNamedTogether_data()
    {
        QTest::addColumn<QString>("start");
        QTest::addColumn<QStringList>("mistakes");
        const auto add = [](const char *start, const QStringList &mistakes) {
            QTest::newRow(qPrintable(mistakes.join(u' ')))
                << QString::fromLatin1(start) << mistakes;
        };
        add("given", {u"decision-from-zero"_s, u"one-pixel-too-many"_s});
        add("given", {u"decision-stays-by-dy"_s, u"line-colours-by-pixels"_s});
        add("given", {u"steps-across-backward"_s, u"line-colours-ahead"_s});
    }
    void twoMistakesOfALineAreNamedTogether()
    {
        QFETCH(QString, start);
        QFETCH(QStringList, mistakes);
        const Scene scene = sheet();
        const std::vector<Submission> submissions
            = {{scene, drawn(scene, qPrintable(start), "crosses", mistakes)}};

        const Diagnosis diagnosis = *diagnose(submissions);

        QVERIFY(diagnosis.isExplained());
        QCOMPARE(diagnosis.candidates.front().ids(), mistakes);
    }

    void mistakesOfOneDecisionAreNotBothInAProgram()
    {
        const LineBugs first{.first = DecisionTerm::Rise, .start = LineStart::FirstEnd};
        const LineBugs other{.first = DecisionTerm::Sum, .start = LineStart::FirstEnd};
        const LineBugs stay{.stay = DecisionTerm::Rise, .start = LineStart::FirstEnd};
        const LineBugs sorted{.stay = DecisionTerm::Rise, .start = LineStart::LeastAlong};
        QVERIFY(!together(first, other));
        QVERIFY(!together(first, sorted)); // steps begin at one end
        const auto both = together(first, stay);
        QVERIFY(both
                && *both
                    == (LineBugs{.first = DecisionTerm::Rise,
                                 .stay = DecisionTerm::Rise,
                                 .start = LineStart::FirstEnd}));
        // Cut rows hide what the steps do.
        QVERIFY(!together(first, {.rounding = AcrossRounding::Down}));
    }

    void whereTheDecisionIsZeroEitherPixelIsRight_data()
    {
        QTest::addColumn<bool>("isSorted");
        QTest::addColumn<bool>("stays");
        QTest::newRow("p > 0 from the left end") << true << true;
        QTest::newRow("p > 0 from the first end") << false << true;
        QTest::newRow("p >= 0 from the first end") << false << false;
    }
    void whereTheDecisionIsZeroEitherPixelIsRight()
    {
        QFETCH(bool, isSorted);
        QFETCH(bool, stays);
        Scene scene = sheet();
        Shape backward; // 2Δy = Δx: every second step is a tie
        backward.vertices
            = {{latticePixel(46, 40), {{255, 0, 0}}}, {latticePixel(36, 45), {{0, 0, 255}}}};
        scene.shapes.push_back(backward);
        const Picture picture
            = drawn(scene, isSorted ? "left" : "given", stays ? "stays" : "crosses");
        QVERIFY(picture.colours != pictureOf(scene).colours);
        const std::vector<Submission> submissions = {{scene, picture}};

        const Diagnosis diagnosis = *diagnose(submissions);

        QCOMPARE(nameOf(diagnosis.verdict), u"undecidable"_s);
        if (isSorted)
            QCOMPARE(diagnosis.candidates.front().rightAlone(), QStringList(u"stay-at-zero"_s));
        // A diagnosis without leeway calls it wrong.
        const Diagnosis strict = *diagnose(submissions, {}, {Leeway::Strict});
        QCOMPARE(nameOf(strict.verdict), u"wrong"_s);
        if (isSorted) {
            QCOMPARE(strict.candidates.front().ids(), QStringList(u"stay-at-zero"_s));
            QCOMPARE(strict.candidates.front().sentences(&Defect::forStudent).size(), 1);
        }
    }

    void aTieWithAMistakeIsFoundButNotReported()
    {
        const Scene scene = sheet();
        const std::vector<Submission> submissions
            = {{scene, drawn(scene, "left", "stays", {u"least-pixel-missing"_s})}};

        const Diagnosis diagnosis = *diagnose(submissions);

        QCOMPARE(nameOf(diagnosis.verdict), u"wrong"_s);
        QVERIFY(diagnosis.isExplained());
        const DiagnosisCandidate &named = diagnosis.candidates.front();
        QCOMPARE(named.ids(), QStringList({u"stay-at-zero"_s, u"least-pixel-missing"_s}));
        QCOMPARE(named.rightAlone(), QStringList(u"stay-at-zero"_s));
        QCOMPARE(named.sentences(&Defect::forStudent).size(), 1);
    }
};

PIXELPLUMB_TEST(TestLineDefects)

} // namespace tst_linedefects

#include "tst_linedefects.moc"
