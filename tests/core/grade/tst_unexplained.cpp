// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/pictures/picturediff.h"
#include "tests/support/scanning.h"
#include "tests/support/scenes/probescenes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_unexplained {

using namespace pixelplumb;

namespace {

std::vector<Submission> submissionsOf(const std::vector<Scene> &scenes,
                                      const std::vector<Defect> &defects)
{
    std::vector<Submission> submissions;
    for (const Scene &scene : scenes)
        submissions.push_back({scene, pictureWith(scene, defects)});
    return submissions;
}

bool isAmong(const Diagnosis &diagnosis, const QString &id)
{
    return std::ranges::any_of(diagnosis.candidates, [&](const DiagnosisCandidate &candidate) {
        return candidate.defects.size() == 1 && candidate.defects.front().id == id;
    });
}

Defect defectNamed(const Scene &scene, const QString &id)
{
    const std::vector<Defect> all = defectsFor(scene);
    const auto found = std::ranges::find(all, id, &Defect::id);
    return found != all.end() ? *found : Defect{};
}

} // namespace

/// What is told of pictures that no set of defects of the scenes' own method explains.
class TestUnexplained : public QObject {
    Q_OBJECT

private slots:
    void aMistakeOfAnotherMethodIsNamedByIt_data()
    {
        QTest::addColumn<QString>("asked");
        QTest::addColumn<QString>("drawn");
        QTest::addColumn<QString>("mistake");
        QTest::addRow("columns asked, rows drawn")
            << u"column-scan"_s << u"row-walk"_s << u"whole-slopes"_s;
        QTest::addRow("columns asked, edges tested")
            << u"column-scan"_s << u"edge-equations"_s << u"edge-functions-cut"_s;
        QTest::addRow("edges asked, columns drawn")
            << u"edge-equations"_s << u"column-scan"_s << u"whole-slopes"_s;
    }
    void aMistakeOfAnotherMethodIsNamedByIt()
    {
        QFETCH(QString, asked);
        QFETCH(QString, drawn);
        QFETCH(QString, mistake);
        Scene scene = sceneWith({coloured({LatticePoint{5 * 256 + 100, 5 * 256 + 37},
                                           {30 * 256 + 11, 8 * 256 + 90},
                                           {12 * 256 + 201, 33 * 256 + 5}})},
                                asked.toLatin1().constData());
        Scene byOther = scene;
        byOther.method = drawn.toStdString();
        const Picture picture = pictureWith(byOther, std::vector{defectNamed(byOther, mistake)});
        QVERIFY(differingPixels(pictureOf(scene), picture) > 0);

        const auto diagnosis = diagnose(std::vector{Submission{scene, picture}});

        QVERIFY(diagnosis->isExplained());
        const auto isTold = [&](const DiagnosisCandidate &candidate) {
            return candidate.ids() == QStringList{u"drawn-by-"_s + drawn, mistake};
        };
        QVERIFY(std::ranges::any_of(diagnosis->candidates, isTold));
    }

    void aMistakeOfAnotherMethodIsNamedUpToRounding()
    {
        const Scene scene = sceneWith({triangleAt(2, 3, 39, 11, 13, 38)});
        Scene byRows = scene;
        byRows.method = "row-walk";
        const std::vector<Defect> both = {defectNamed(byRows, u"whole-interpolated-edges"_s),
                                          defectNamed(byRows, u"last-span-missing"_s)};
        Scene rounded = byRows;
        rounded.settings.arithmetic = Arithmetic::Float32;
        const Picture exact = pictureWith(byRows, both);
        const Picture inFloats = pictureWith(rounded, both);
        Picture picture = exact;
        std::size_t place = 0;
        while (place < exact.size() && isSameAt(exact, inFloats, place))
            ++place;
        QVERIFY(place < exact.size());
        picture.colours[place] = inFloats.colours[place];
        picture.covered[place] = inFloats.covered[place];
        const std::vector submissions{Submission{scene, picture}};

        const auto diagnosis = diagnose(submissions);

        QVERIFY(diagnosis->isExplained());
        QCOMPARE(diagnosis->candidates.front().ids().front(), u"drawn-by-row-walk"_s);
        QVERIFY(diagnosis->candidates.front().undecidable > 0);
        QVERIFY(!diagnose(submissions, {}, {Leeway::Strict})->isExplained());
    }

    void whatNoDefectExplainsHasItsNearestOnes()
    {
        const std::vector<Scene> scenes = probeScenes();
        const Defect defect = defectNamed(scenes.front(), u"unsorted-colours"_s);
        std::vector<Submission> submissions = submissionsOf(scenes, {defect});
        submissions.front().picture.colours[5] = {{1, 2, 3}}; // a colour that no program would
                                                              // write
        const Diagnosis diagnosis = *diagnose(submissions);
        QCOMPARE(diagnosis.verdict, DiagnosisVerdict::Wrong);
        QVERIFY(!diagnosis.isExplained());
        QVERIFY(diagnosis.candidates.size() <= 5);
        QCOMPARE(diagnosis.candidates.front().distance, std::int64_t(1));
        QVERIFY(isAmong(diagnosis, defect.id));
    }

    void aPairIsNoNearerForWhatItDoesNotNeed()
    {
        const std::vector<Scene> scenes = probeScenes();
        std::vector<Submission> submissions
            = submissionsOf(scenes, {defectNamed(scenes.front(), u"upside-down"_s)});
        submissions.front().picture.colours[5] = {{1, 2, 3}};
        const Diagnosis diagnosis = *diagnose(submissions);
        QVERIFY(!diagnosis.isExplained());
        for (const DiagnosisCandidate &candidate : diagnosis.candidates) {
            const bool hasPart = candidate.defects.size() == 2
                && std::ranges::any_of(candidate.defects, [](const Defect &defect) {
                                     return defect.id == u"upside-down"_s;
                                 });
            QVERIFY(!hasPart); // one pixel remains with it, and with it and another
        }
    }

    void twoMistakesDoNotMeanThatNothingIsDrawn()
    {
        const Scene scene = sceneWith({triangleAt(5, 5, 30, 8, 12, 33)});
        const auto diagnosis = diagnose(std::vector{Submission{scene, emptyPicture(scene.frame)}});
        for (const DiagnosisCandidate &candidate : diagnosis->candidates)
            QVERIFY2(candidate.defects.size() < 2, qPrintable(candidate.ids().join(u' ')));
        QCOMPARE(diagnosis->places.size(), std::size_t(1));
        QVERIFY(diagnosis->places.front().front().contains(u"missing"_s));
    }

    void whatLeavesMoreThanATenthIsNotNear_data()
    {
        QTest::addColumn<int>("spoiled"); // pixels of every hundred that differ
        QTest::addColumn<bool>("isNear");
        QTest::addRow("a twentieth") << 5 << true;
        QTest::addRow("a fifth") << 20 << false;
    }
    void whatLeavesMoreThanATenthIsNotNear()
    {
        QFETCH(int, spoiled);
        QFETCH(bool, isNear);
        const Scene scene = sceneWith({triangleAt(5, 5, 30, 8, 12, 33)});
        Picture picture
            = pictureWith(scene, std::vector{defectNamed(scene, u"unsorted-colours"_s)});
        const std::int64_t differing = differingPixels(pictureOf(scene), picture);
        std::int64_t left = differing * spoiled / 100;
        for (std::size_t place = 0; left > 0; place += 7) {
            if (picture.covered[place % picture.size()] == 0)
                continue;
            picture.colours[place % picture.size()] = {{std::uint8_t(place), 2, 3}};
            --left;
        }

        const auto diagnosis = diagnose(std::vector{Submission{scene, picture}});

        QVERIFY(!diagnosis->isExplained());
        QCOMPARE(!diagnosis->candidates.empty(), isNear);
    }
};

PIXELPLUMB_TEST(TestUnexplained)

} // namespace tst_unexplained

#include "tst_unexplained.moc"
