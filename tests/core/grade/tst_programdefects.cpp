// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/diagnosis.h"
#include "core/methods/method.h"
#include "core/scene/scenefile.h"
#include "tests/support/casestorun.h"
#include "tests/support/programs/mistakenprograms.h"
#include "tests/support/scenes/probescenes.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>
#include <set>

Q_DECLARE_METATYPE(pixelplumb::MistakenProgram)

namespace tst_programdefects {

using namespace pixelplumb;

namespace {

Scene defaultScene(const QString &method)
{
    const auto reading = readSceneFile(resource(u"/scenes/default.json"_s));
    Scene scene = reading ? reading->scene : Scene();
    scene.method = method.toStdString();
    return scene;
}

/// Triangles with two vertices above each other, given in either order.
Scene verticalEdges()
{
    Scene scene = defaultScene(u"column-scan"_s);
    const auto triangle = [](const LatticePoint &a, const LatticePoint &b, const LatticePoint &c) {
        return Triangle{{{{a, {{250, 40, 10}}}, {b, {{20, 200, 90}}}, {c, {{60, 30, 240}}}}}};
    };
    scene.triangles = {triangle(latticePixel(22, 30), latticePixel(3, 11), latticePixel(22, 4)),
                       triangle(latticePixel(26, 5), latticePixel(44, 9), latticePixel(44, 41))};
    return scene;
}

/// The defect pictures of a method, kept for all programs of a class.
DefectPictures &defectPicturesOf(const QString &method)
{
    static DefectPictures ofColumns(probeSheet(u"column-scan"_s));
    static DefectPictures ofRows(probeSheet(u"row-walk"_s));
    return method == u"row-walk"_s ? ofRows : ofColumns;
}

QString textOf(const Diagnosis &diagnosis)
{
    QStringList sets;
    for (const DiagnosisCandidate &candidate : diagnosis.candidates) {
        QStringList ids;
        for (const Defect &defect : candidate.defects)
            ids += defect.id;
        sets += ids.join(u'+') + u" (%1)"_s.arg(candidate.distance);
    }
    return sets.join(u' ');
}

void addRows(const std::vector<MistakenProgram> &programs)
{
    QTest::addColumn<MistakenProgram>("program");
    for (const MistakenProgram &program : programs)
        QTest::addRow("%s, %s", qPrintable(program.method), qPrintable(program.id)) << program;
}

/// The scene's defect of that id must draw the picture.
void compareWithDefect(const Picture &picture, const Scene &scene, const QString &id)
{
    const std::vector<Defect> defects = defectsFor(scene);
    const auto defect = std::ranges::find(defects, id, &Defect::id);
    QVERIFY(defect != defects.end());
    QCOMPARE(picture.colours, pictureWith(scene, std::span(&*defect, 1)).colours);
}

} // namespace

/// The defects match programs that were not written for them.
class TestProgramDefects : public QObject {
    Q_OBJECT

private slots:
    void aRightProgramIsRight()
    {
        for (const auto &[method, lines] :
             {std::pair("column-scan", WalkLines::Columns), std::pair("row-walk", WalkLines::Rows),
              std::pair("row-walk", WalkLines::RowsFromBelow)}) {
            const std::vector<Scene> scenes = probeSheet(QString::fromLatin1(method));
            const std::vector<Picture> pictures = studentPictures(scenes, lines, {});
            for (std::size_t i = 0; i < pictures.size(); ++i)
                QCOMPARE(pictures[i].colours, pictureOf(scenes[i]).colours);
        }
    }

    void theSheetNamesTheMistakeOfAProgram_data()
    {
        addRows(casesToRun(mistakenPrograms(), &MistakenProgram::group));
    }
    void theSheetNamesTheMistakeOfAProgram()
    {
        QFETCH(MistakenProgram, program);
        DefectPictures &pictures = defectPicturesOf(program.method);
        std::vector<FoundPicture> found;
        for (Picture &picture : studentPictures(pictures.scenes(), program.lines, program.mistakes))
            found.push_back({found.size(), std::move(picture)});

        const Diagnosis diagnosis = *diagnose(pictures, found);

        // A right program may also leave out samples that lie on vertices only.
        QVERIFY(diagnosis.verdict != DiagnosisVerdict::Right);
        QVERIFY2(diagnosis.isExplained(), qPrintable(textOf(diagnosis)));
        // A pair may always draw the same: a stored level loses what a step rounded down loses.
        const auto alone
            = std::ranges::count_if(diagnosis.candidates, [](const DiagnosisCandidate &candidate) {
                  return candidate.defects.size() == 1;
              });
        QVERIFY2(alone == 1, qPrintable(textOf(diagnosis)));
        QCOMPARE(diagnosis.candidates.front().defects.front().id, program.id);
        for (const FoundPicture &each : found) {
            const Scene &scene = pictures.scenes()[each.scene];
            if (each.picture.colours != pictureOf(scene).colours)
                QVERIFY(partingStepOf(scene, diagnosis.candidates.front().defects));
        }
    }

    void aProgramInDoubleHasTheDefectInDouble_data()
    {
        // With unsorted vertices, spans begin outside the frame, where a program adds up what the
        // walk reaches in one step.
        const QStringList ids = {u"no-edge-pre-step"_s,       u"whole-slopes"_s,
                                 u"whole-edge-steps"_s,       u"whole-colours"_s,
                                 u"whole-colour-rates"_s,     u"whole-places"_s,
                                 u"colour-divisor-samples"_s, u"colour-divisor-plus-one"_s,
                                 u"long-edge-begun-again"_s,  u"edge-pre-step-backward"_s,
                                 u"second-edge-carried-on"_s, u"edges-stepped-first"_s,
                                 u"extra-first-sample"_s,     u"colours-without-edge-pre-step"_s};
        std::vector<MistakenProgram> programs = mistakenPrograms();
        std::erase_if(programs, [&](const MistakenProgram &program) {
            return !ids.contains(QString(program.id).remove(u"-from-below"_s));
        });
        addRows(programs);
    }
    void aProgramInDoubleHasTheDefectInDouble()
    {
        QFETCH(MistakenProgram, program);
        std::vector<Scene> scenes = probeSheet(program.method);
        const std::vector<Picture> pictures
            = studentPictures(scenes, program.lines, program.mistakes, WalkNumbers::Double);
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            scenes[i].settings.arithmetic = Arithmetic::Float64;
            compareWithDefect(pictures[i], scenes[i], program.id);
        }
    }

    void theDefaultSceneIsDrawnAsTheDefectDrawsIt_data()
    {
        theSheetNamesTheMistakeOfAProgram_data();
    }
    void theDefaultSceneIsDrawnAsTheDefectDrawsIt()
    {
        QFETCH(MistakenProgram, program);
        const std::vector<Scene> scenes = {defaultScene(program.method)};
        for (const Picture &picture : studentPictures(scenes, program.lines, program.mistakes))
            compareWithDefect(picture, scenes.front(), program.id);
    }

    void eachEndOfTheRowsHasItsOwnWords()
    {
        const std::vector<Defect> all = defectsFor(defaultScene(u"row-walk"_s));
        const auto words = [&](const char *id) {
            const auto defect = std::ranges::find(all, QLatin1String(id), &Defect::id);
            return defect != all.end() ? defect->forAssistant : QString();
        };
        QVERIFY(words("no-edge-pre-step").contains(u"(y₀ − ⌊y₀⌋)·m"_s));
        QVERIFY(words("no-edge-pre-step").contains(u"from the greatest y down"_s));
        QVERIFY(words("no-edge-pre-step-from-below").contains(u"(⌈y₀⌉ − y₀)·m"_s));
        QVERIFY(words("no-edge-pre-step-from-below").contains(u"the least y up"_s));
        QVERIFY(words("whole-slopes").contains(u"from the greatest y down"_s));
        QVERIFY(!words("whole-colour-rates").contains(u"gone through"_s));
        QVERIFY(
            words("edge-pre-step-of-fraction").contains(u"by ⌈y₀⌉ − y₀ in place of y₀ − ⌊y₀⌋."_s));
        QVERIFY(words("edge-pre-step-of-fraction-from-below")
                    .contains(u"by y₀ − ⌊y₀⌋ in place of ⌈y₀⌉ − y₀."_s));
        QVERIFY(words("colour-pre-step-of-fraction")
                    .contains(u"by x_L − ⌊x_L⌋ in place of ⌈x_L⌉ − x_L."_s));
        // The missing half is the same from either end.
        for (const char *id : {"first-half-missing", "first-half-and-middle-missing"})
            QVERIFY(words(id).contains(u"half with the lesser y is not drawn"_s));
        for (const char *id : {"second-half-missing", "second-half-behind-middle-missing"})
            QVERIFY(words(id).contains(u"half with the greater y is not drawn"_s));
    }

    void noSentenceHasAPlaceThatIsNotFilled()
    {
        for (const char *method : {"column-scan", "row-walk"}) {
            Scene scene = defaultScene(QString::fromLatin1(method));
            scene.triangles = verticalEdges().triangles;
            for (const Defect &defect : defectsFor(scene)) {
                QVERIFY2(!defect.forStudent.contains(u'%'), qPrintable(defect.forStudent));
                QVERIFY2(!defect.forAssistant.contains(u'%'), qPrintable(defect.forAssistant));
            }
        }
    }

    void noTwoDefectsHaveOneId()
    {
        for (const char *method : {"column-scan", "row-walk", "edge-equations",
                                   "barycentric-rectangle", "line-bresenham"}) {
            for (const Scene &scene : probeSheet(QString::fromLatin1(method))) {
                std::set<QString> ids;
                for (const Defect &defect : defectsFor(scene))
                    QVERIFY2(ids.insert(defect.id).second, qPrintable(defect.id));
            }
        }
    }

    void howAFlatEndIsDrawnIsToldBesideAMistakeAlone_data()
    {
        QTest::addColumn<QString>("choice");
        QTest::addColumn<QString>("id");
        for (const QString id : {"divisor-plus-one", "divisor-minus-one", "unsorted-colours"}) {
            for (const QString choice : {"equal-as-given", "equal-descending",
                                         "flat-end-from-vertices", "flat-end-from-edges"}) {
                const bool isSeen = choice.startsWith(u'e') || id != u"unsorted-colours"_s;
                if (isSeen)
                    QTest::addRow("%s, %s", qPrintable(choice), qPrintable(id)) << choice << id;
            }
        }
    }
    void howAFlatEndIsDrawnIsToldBesideAMistakeAlone()
    {
        QFETCH(QString, choice);
        QFETCH(QString, id);
        const Scene scene = verticalEdges();
        const auto drawn = [&scene](const QStringList &mistakes) {
            return studentPictures(std::span(&scene, 1), WalkLines::Columns, mistakes).at(0);
        };
        QCOMPARE(drawn({choice}).colours, pictureOf(scene).colours);

        const auto diagnosis = diagnose(std::vector{Submission{scene, drawn({id, choice})}});

        QVERIFY2(diagnosis->isExplained(), qPrintable(textOf(*diagnosis)));
        const QStringList both{id, choice};
        QVERIFY2(std::ranges::any_of(
                     diagnosis->candidates,
                     [&](const DiagnosisCandidate &candidate) { return candidate.ids() == both; }),
                 qPrintable(textOf(*diagnosis)));
        QVERIFY2(std::ranges::none_of(diagnosis->candidates,
                                      [](const DiagnosisCandidate &candidate) {
                                          return candidate.defects.size() == 1;
                                      }),
                 qPrintable(textOf(*diagnosis)));
    }

    void aDefectPartsAtItsFirstWrongNumberOrPixel()
    {
        const Scene scene = defaultScene(u"column-scan"_s);
        const std::vector<Defect> all = defectsFor(scene);
        const auto partingText = [&](const char *id) {
            const auto defect = std::ranges::find(all, QLatin1String(id), &Defect::id);
            const auto step = partingStepOf(scene, std::span(&*defect, 1));
            return step ? step->heading + u": "_s + step->text : QString();
        };
        QCOMPARE(partingText("last-sample-missing"), u"Pixel (4, 5): (4, 5) is left out"_s);
        QCOMPARE(partingText("ends-outward"), u"Column 5, first half: ⌈y_B⌉ is 5, should be 6"_s);
        QCOMPARE(partingText("upside-down"), QString()); // nothing is wrong in its run
    }
};

PIXELPLUMB_TEST(TestProgramDefects)

} // namespace tst_programdefects

#include "tst_programdefects.moc"
