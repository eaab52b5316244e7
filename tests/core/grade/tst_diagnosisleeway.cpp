// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/pictures/picturediff.h"
#include "tests/support/casestorun.h"
#include "tests/support/programs/mistakenprograms.h"
#include "tests/support/scanning.h"
#include "tests/support/scenes/probescenes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_diagnosisleeway {

using namespace pixelplumb;

namespace {

Defect defectNamed(const Scene &scene, const char *id)
{
    const std::vector<Defect> all = defectsFor(scene);
    const auto found = std::ranges::find(all, QLatin1String(id), &Defect::id);
    return found != all.end() ? *found : Defect{};
}

std::vector<Defect> defectsNamed(const Scene &scene, const QByteArrayList &ids)
{
    std::vector<Defect> defects;
    for (const QByteArray &id : ids)
        defects.push_back(defectNamed(scene, id));
    return defects;
}

Scene computedIn(Scene scene, Arithmetic arithmetic)
{
    scene.settings.arithmetic = arithmetic;
    return scene;
}

/// What programs draw that compute in this arithmetic, one defect each.
std::vector<Submission> submissionsIn(Arithmetic arithmetic, const std::vector<Scene> &scenes,
                                      const QByteArrayList &ids)
{
    std::vector<Submission> submissions;
    for (const Scene &scene : scenes)
        submissions.push_back(
            {scene, pictureWith(computedIn(scene, arithmetic), defectsNamed(scenes.front(), ids))});
    return submissions;
}

/// Removes the first sample that lies on an edge of the scene and is drawn last in its column: a
/// right program may leave it out.
void dropTie(const Scene &scene, Picture &picture)
{
    const auto ties = tiesOf(scene);
    for (std::size_t place = 0; place < ties.size(); ++place) {
        if (ties[place] == 0 || picture.covered[place] == 0)
            continue;
        picture.covered[place] = 0;
        picture.colours[place] = scene.frame.background;
        return;
    }
}

Scene triangleWithTies()
{
    return sceneWith({coloured({latticePixel(4, 30), latticePixel(29, 35), latticePixel(29, 5)})});
}

QString idsOf(const DiagnosisCandidate &candidate)
{
    return candidate.ids().join(QLatin1String(" and "));
}

QStringList idsOf(const Diagnosis &diagnosis)
{
    QStringList ids;
    for (const DiagnosisCandidate &candidate : diagnosis.candidates)
        ids += idsOf(candidate);
    return ids;
}

} // namespace

/// A program with a defect may round, and decide samples on edges, as right programs do.
class TestDiagnosisLeeway : public QObject {
    Q_OBJECT

private slots:
    void aTieMovesWithThePicture_data()
    {
        QTest::addColumn<QByteArray>("id");
        for (const char *id : {"channels-bgr-in-place-of-rgb", "left-and-right-exchanged",
                               "shifted-by-1-to-the-right", "encoded-as-srgb-once-too-often"})
            QTest::newRow(id) << QByteArray(id);
    }
    void aTieMovesWithThePicture()
    {
        QFETCH(QByteArray, id);
        const Scene scene = triangleWithTies();
        Picture drawn = pictureOf(scene);
        dropTie(scene, drawn);
        const Defect defect = defectNamed(scene, id);
        const Picture found = changed(drawn, defect.changePicture, scene.frame.background);
        const auto diagnosis = diagnose(std::vector{Submission{scene, found}});
        QCOMPARE(diagnosis->verdict, DiagnosisVerdict::Wrong);
        QVERIFY(diagnosis->isExplained());
        const DiagnosisCandidate &first = diagnosis->candidates.front();
        QCOMPARE(idsOf(first), QString::fromLatin1(id));
        QCOMPARE(first.distance, std::int64_t(0));
        QCOMPARE(first.undecidable, std::int64_t(1));
    }

    void aDefectThatMovesEdgesHasTiesOfItsOwn()
    {
        const Scene scene = sceneWith({coloured({LatticePoint{4 * 256 + 128, 30 * 256 + 128},
                                                 LatticePoint{29 * 256 + 128, 35 * 256 + 128},
                                                 LatticePoint{29 * 256 + 128, 5 * 256 + 128}})});
        const Defect moved = defectNamed(scene, "half-pixel-down");
        const Scene defective = withDefects(scene, std::span(&moved, 1));
        Submission submission{scene, pictureOf(defective)};
        dropTie(defective, submission.picture);
        const auto diagnosis = diagnose(std::vector{submission});
        // For vertices between pixels, truncating gives the same.
        QVERIFY(idsOf(*diagnosis).contains(u"half-pixel-down"_s));
        QCOMPARE(diagnosis->candidates.front().distance, std::int64_t(0));
        QCOMPARE(diagnosis->candidates.front().undecidable, std::int64_t(1));
    }

    void whatEqualsThePicturesComesFirstAndAlone()
    {
        const auto scenes = probeScenes();
        const auto diagnosis
            = diagnose(submissionsIn(Arithmetic::Exact, scenes, {"last-sample-missing"}));
        QVERIFY(std::ranges::all_of(diagnosis->candidates, [](const DiagnosisCandidate &candidate) {
            return candidate.undecidable == 0;
        }));
        QVERIFY(idsOf(*diagnosis).contains(u"last-sample-missing"_s));
    }

    void aStudentsProgramInDoubleIsNamed_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QStringList>("mistakes");
        std::vector<MistakenProgram> programs = mistakenPrograms();
        std::erase_if(programs, [](const MistakenProgram &program) {
            return program.method != u"column-scan"_s;
        });
        for (const MistakenProgram &program : casesToRun(programs, &MistakenProgram::group))
            QTest::newRow(qPrintable(program.id)) << program.id << program.mistakes;
    }
    void aStudentsProgramInDoubleIsNamed()
    {
        QFETCH(QString, id);
        QFETCH(QStringList, mistakes);
        static DefectPictures pictures(probeSheet(u"column-scan"_s));
        std::vector<FoundPicture> found;
        for (Picture &picture :
             studentPictures(pictures.scenes(), WalkLines::Columns, mistakes, WalkNumbers::Double))
            found.push_back({found.size(), std::move(picture)});
        const auto diagnosis = diagnose(pictures, found);
        if (diagnosis->verdict == DiagnosisVerdict::Undecidable)
            return; // a right program may also leave out samples that lie on vertices only
        // A truncated quotient of colours jumps where it is whole: no bound holds for it.
        const QStringList cut
            = {u"floor-colour-steps"_s, u"whole-colours"_s, u"floor-colours"_s, u"whole-levels"_s};
        const bool isCut = id.endsWith(u"-colour-rates"_s) || cut.contains(id);
        QVERIFY2(diagnosis->isExplained() || isCut, qPrintable(idsOf(*diagnosis).join(u' ')));
        QCOMPARE(idsOf(diagnosis->candidates.front()), id);
    }

    void arithmeticIsBesideTwoDefects_data()
    {
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::newRow("float64") << Arithmetic::Float64;
        QTest::newRow("float32") << Arithmetic::Float32;
    }
    void arithmeticIsBesideTwoDefects()
    {
        QFETCH(Arithmetic, arithmetic);
        const auto scenes = probeScenes();
        const std::vector<QByteArrayList> pairs
            = {{"no-colour-pre-step", "half-pixel-down"},
               {"no-edge-pre-step", "last-sample-missing"},
               {"vertices-truncated", "upside-down"},
               {"ends-nearest", "channels-bgr-in-place-of-rgb"}};
        for (const QByteArrayList &pair : casesToRun(pairs)) {
            const auto diagnosis = diagnose(submissionsIn(arithmetic, scenes, pair));
            const QString told = idsOf(*diagnosis).join(u' ');
            QVERIFY2(diagnosis->isExplained(), qPrintable(pair.join(' ')));
            QVERIFY2(idsOf(*diagnosis).contains(QString::fromLatin1(pair.join(" and "))),
                     qPrintable(told));
            QVERIFY2(!told.contains(u"arithmetic"_s), qPrintable(told));
        }
    }

    void whatIsNotAllowedForIsTold()
    {
        const auto scenes = probeScenes();
        const QByteArrayList pair{"unsorted-colours", "half-pixel-down"};
        const auto submissions = submissionsIn(Arithmetic::Float32, scenes, pair);
        const auto strict = diagnose(submissions, {}, {Leeway::Strict});
        QVERIFY(strict->isExplained());
        const DiagnosisCandidate &told = strict->candidates.front();
        QCOMPARE(idsOf(told), "arithmetic-float32 and unsorted-colours and half-pixel-down");
        QVERIFY(told.arithmetic == Arithmetic::Float32);
        QCOMPARE(idsOf(diagnose(submissions)->candidates.front()),
                 "unsorted-colours and half-pixel-down");

        const auto fixed
            = diagnose(submissionsIn(Arithmetic::Fixed16, scenes, {"unsorted-colours"}));
        QVERIFY(fixed->isExplained());
        QVERIFY(fixed->candidates.front().ids().contains(u"unsorted-colours"_s));
    }

    void theStepIsTheDefectsNotTheArithmetics()
    {
        const Scene scene = probeScenes().front();
        const auto plain = partingStepOf(scene, defectsNamed(scene, {"no-colour-pre-step"}));
        QVERIFY(plain.has_value());
        for (const char *arithmetic : {"arithmetic-float32", "arithmetic-float64"}) {
            const auto step
                = partingStepOf(scene, defectsNamed(scene, {arithmetic, "no-colour-pre-step"}));
            QVERIFY(step.has_value());
            QCOMPARE(step->step, plain->step);
            QCOMPARE(step->heading, plain->heading);
            QVERIFY2(!step->text.contains(u"off by"_s), qPrintable(step->text));
        }
    }

    void anEmptyCanvasOfAnotherBackgroundHasAllItsNames()
    {
        const Scene scene = triangleWithTies();
        Picture white = pictureOf(scene);
        std::ranges::fill(white.colours, Colour{{255, 255, 255}});
        std::ranges::fill(white.covered, std::uint8_t(1));
        const auto diagnosis = diagnose(std::vector{Submission{scene, white}});
        const QStringList told = idsOf(*diagnosis);
        QVERIFY2(told.contains(u"nothing-drawn and drawn-on-white"_s), qPrintable(told.join(u',')));
        QVERIFY(told.contains(u"drawn-in-white-alone and drawn-on-white"_s));
        for (const DiagnosisCandidate &candidate : diagnosis->candidates) {
            QStringList sentences = candidate.sentences(&Defect::forStudent);
            QCOMPARE(sentences.removeDuplicates(), 0);
            for (const QString &sentence : candidate.sentences(&Defect::forAssistant))
                QVERIFY2(!sentence.contains(u"is right"_s), qPrintable(sentence));
        }
    }

    void roundingDoesNotExcuseAPartOfWhichNothingIsSeen()
    {
        const Scene scene = triangleWithTies();
        DefectPictures pictures({scene});
        const auto placeOf = [&](const char *id) {
            const std::vector<Defect> &all = pictures.defects();
            return std::size_t(std::ranges::find(all, QLatin1String(id), &Defect::id)
                               - all.begin());
        };
        const auto pair
            = std::minmax({placeOf("colour-divisor-samples"), placeOf("open-at-lower-bound")});
        const DefectSet set{pair.first, pair.second};
        // All samples on lower bounds are drawn.
        const std::vector<FoundPicture> without
            = {{0, *pictures.picture(0, {placeOf("colour-divisor-samples")})}};
        const std::vector<FoundPicture> with = {{0, *pictures.picture(0, set)}};

        PictureMatcher matcher(pictures, without, Margin{});
        QVERIFY(matcher.distance(set) > 0);
        QVERIFY(!matcher.allowedMatch(set));
        QVERIFY(PictureMatcher(pictures, with, Margin{}).allowedMatch(set));
    }

    void nothingDrawnIsNotDiagnosedWherePixelsAreDrawn()
    {
        const Scene scene = triangleWithTies();
        DefectPictures pictures({scene});
        const std::vector<Defect> &all = pictures.defects();
        const auto nothing = std::ranges::find(all, QLatin1String("nothing-drawn"), &Defect::id);
        const DefectSet set{std::size_t(nothing - all.begin())};
        Picture found = *pictures.picture(0, set);
        const std::vector<FoundPicture> blank = {{0, found}};
        QVERIFY(!PictureMatcher(pictures, blank, Margin{}).isDrawnAllTheSame(set));
        const Picture right = pictureOf(scene);
        const auto drawn = std::size_t(std::ranges::find(right.covered, 1) - right.covered.begin());
        found.covered[drawn] = 1;
        found.colours[drawn] = Colour{{1, 2, 3}};
        const std::vector<FoundPicture> dotted = {{0, found}};

        QVERIFY(PictureMatcher(pictures, dotted, Margin{}).isDrawnAllTheSame(set));
        const auto diagnosis = diagnose(std::vector{Submission{scene, found}});
        for (const DiagnosisCandidate &candidate : diagnosis->candidates)
            QVERIFY2(!candidate.ids().contains(u"nothing-drawn"_s), qPrintable(idsOf(candidate)));
    }

    /// Without the level top edge's row: what leaves out the level bottom edge's row, too, which no
    /// rounding moves, does not explain it.
    void aLevelEdgeIsNotMovedByRounding()
    {
        Scene scene;
        scene.triangles = {triangleAt(8, 5, 36, 5, 19, 24), triangleAt(27, 43, 59, 43, 50, 21)};
        Picture picture = pictureOf(scene);
        const auto line = int(pictureLine(scene.frame, 43));
        for (int x = 0; x < picture.width; ++x) {
            picture.covered[picture.placeOf(x, line)] = 0;
            picture.colours[picture.placeOf(x, line)] = scene.frame.background;
        }
        const Submission submission{scene, picture};
        const auto diagnosis = diagnose(std::span(&submission, 1));
        for (const DiagnosisCandidate &candidate : diagnosis->candidates) {
            const bool hasOpenEnds = candidate.ids().contains(u"open-at-bounds"_s);
            QVERIFY2(!hasOpenEnds || candidate.distance > 0,
                     qPrintable(candidate.ids().join(u' ')));
        }
    }

    void onePixelIsOne()
    {
        QCOMPARE(pixelsText(1), "1 pixel");
        QCOMPARE(undecidableText(1),
                 "but for 1 pixel that rounding or a sample on an edge may decide");
        QCOMPARE(undecidableText(0), "");
    }
};

PIXELPLUMB_TEST(TestDiagnosisLeeway)

} // namespace tst_diagnosisleeway

#include "tst_diagnosisleeway.moc"
