// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/diagnosis.h"
#include "core/scene/scenefile.h"
#include "tests/support/programs/studentline.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_linedefects {

using namespace pixelplumb;

namespace {

Scene sheet()
{
    const auto reading = readSceneFile(resource(QStringLiteral("/probes/line-bresenham-1.json")));
    return reading ? reading->scene : Scene();
}

} // namespace

/// The line defects match a program that was not written for them.
class TestLineDefects : public QObject {
    Q_OBJECT

private slots:
    void aRightProgramIsRight()
    {
        QCOMPARE(studentPicture(sheet(), LineMistake::None, LineEnds::LeftFirst).colours,
                 pictureOf(sheet()).colours);
    }

    void theSheetNamesTheMistakeOfAProgram_data()
    {
        QTest::addColumn<int>("mistake");
        QTest::addColumn<bool>("isSorted");
        const auto row = [](const char *id, LineMistake mistake) {
            QTest::newRow(id) << int(mistake) << true;
        };
        const auto decision = [](const char *id, LineMistake mistake) {
            QTest::newRow(id) << int(mistake) << false;
            QTest::addRow("sorted-%s", id) << int(mistake) << true;
        };
        decision("decision-without-dx", LineMistake::TwiceRiseFirst);
        decision("decision-from-difference", LineMistake::DifferenceFirst);
        decision("decision-from-zero", LineMistake::ZeroFirst);
        decision("decision-without-dy", LineMistake::MinusDxFirst);
        decision("decision-of-exchanged-differences", LineMistake::ExchangedFirst);
        decision("decision-stays-by-dy", LineMistake::OneRise);
        decision("decision-crosses-by-dx", LineMistake::OneRun);
        decision("decision-crosses-by-difference", LineMistake::OneDifference);
        decision("decision-never-lowered", LineMistake::NeverLowered);
        decision("decision-lowered-alone", LineMistake::LoweredAlone);
        decision("decision-of-wrong-sign", LineMistake::WrongSign);
        decision("decision-from-twice-difference", LineMistake::TwiceDifferenceFirst);
        decision("decision-steps-halved", LineMistake::HalvedSteps);
        decision("decision-steps-exchanged", LineMistake::ExchangedSteps);
        decision("decision-stepped-twice", LineMistake::SteppedTwice);
        decision("decision-stepped-before-test", LineMistake::SteppedBefore);
        decision("decision-set-back", LineMistake::SetBack);
        decision("one-pixel-too-many", LineMistake::OnePast);
        decision("steps-across-backward", LineMistake::WrongWay);
        decision("line-colours-by-pixels", LineMistake::DividedByPixels);
        decision("line-colours-ahead", LineMistake::OneAhead);
        decision("steepness-inverted", LineMistake::SteepnessInverted);
        decision("line-slope-whole", LineMistake::WholeSlope);
        QTest::newRow("descending-lines-lost") << int(LineMistake::UpwardLoop) << false;
        row("sorted-falling-lines-level", LineMistake::NeverDown);
        row("steep-lines-exchanged", LineMistake::NotExchangedBack);
        row("steep-lines-lost", LineMistake::NoSteepLines);
        QTest::newRow("falling-lines-level") << int(LineMistake::NeverDown) << false;
        row("first-pixel-missing", LineMistake::NoFirstPixel);
        row("least-pixel-missing", LineMistake::NoLeastPixel);
        row("last-pixel-missing", LineMistake::NoLastPixel);
    }
    void theSheetNamesTheMistakeOfAProgram()
    {
        QFETCH(int, mistake);
        QFETCH(bool, isSorted);
        const LineEnds ends = isSorted ? LineEnds::LeftFirst : LineEnds::AsGiven;
        const Scene scene = sheet();
        const std::vector<Submission> submissions
            = {{scene, studentPicture(scene, LineMistake(mistake), ends)}};

        const Diagnosis diagnosis = *diagnose(submissions);

        QCOMPARE(nameOf(diagnosis.verdict), QStringLiteral("wrong"));
        QVERIFY(diagnosis.isExplained());
        QCOMPARE(diagnosis.candidates.front().defects.size(), std::size_t(1));
        QCOMPARE(diagnosis.candidates.front().defects.front().id,
                 QString::fromLatin1(QTest::currentDataTag()));
        QVERIFY(partingStepOf(scene, diagnosis.candidates.front().defects));
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
        const Picture picture = studentPicture(scene, LineMistake::None,
                                               isSorted ? LineEnds::LeftFirst : LineEnds::AsGiven,
                                               stays ? LineTie::Stays : LineTie::StepsAcross);
        QVERIFY(picture.colours != pictureOf(scene).colours);
        const std::vector<Submission> submissions = {{scene, picture}};

        const Diagnosis diagnosis = *diagnose(submissions);

        QCOMPARE(nameOf(diagnosis.verdict), QStringLiteral("undecidable"));
        if (isSorted)
            QCOMPARE(diagnosis.candidates.front().rightAlone(),
                     QStringList(QStringLiteral("stay-at-zero")));
        // A diagnosis without leeway calls it wrong.
        const Diagnosis strict = *diagnose(submissions, {}, {Leeway::Strict});
        QCOMPARE(nameOf(strict.verdict), QStringLiteral("wrong"));
        if (isSorted) {
            QCOMPARE(strict.candidates.front().ids(), QStringList(QStringLiteral("stay-at-zero")));
            QCOMPARE(strict.candidates.front().sentences(&Defect::forStudent).size(), 1);
        }
    }

    void aTieWithAMistakeIsFoundButNotReported()
    {
        const Scene scene = sheet();
        const std::vector<Submission> submissions
            = {{scene,
                studentPicture(scene, LineMistake::NoLeastPixel, LineEnds::LeftFirst,
                               LineTie::Stays)}};

        const Diagnosis diagnosis = *diagnose(submissions);

        QCOMPARE(nameOf(diagnosis.verdict), QStringLiteral("wrong"));
        QVERIFY(diagnosis.isExplained());
        const DiagnosisCandidate &named = diagnosis.candidates.front();
        QCOMPARE(
            named.ids(),
            QStringList({QStringLiteral("stay-at-zero"), QStringLiteral("least-pixel-missing")}));
        QCOMPARE(named.rightAlone(), QStringList(QStringLiteral("stay-at-zero")));
        QCOMPARE(named.sentences(&Defect::forStudent).size(), 1);
    }
};

PIXELPLUMB_TEST(TestLineDefects)

} // namespace tst_linedefects

#include "tst_linedefects.moc"
