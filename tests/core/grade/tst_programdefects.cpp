// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnosis.h"
#include "core/methods/method.h"
#include "core/scene/scenefile.h"
#include "tests/support/casestorun.h"
#include "tests/support/mistakenprograms.h"
#include "tests/support/probescenes.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_programdefects {

using namespace pixelplumb;

namespace {

using Mistakes = std::set<WalkMistake>;

Scene defaultScene(const QString &method)
{
    const auto reading = readSceneFile(resource(QStringLiteral("/scenes/default.json")));
    Scene scene = reading ? reading->scene : Scene();
    scene.method = method.toStdString();
    return scene;
}

/// Triangles with two vertices above each other, given in either order.
Scene verticalEdges()
{
    Scene scene = defaultScene(QStringLiteral("column-scan"));
    const auto triangle = [](const LatticePoint &a, const LatticePoint &b, const LatticePoint &c) {
        return Triangle{{{{a, {{250, 40, 10}}}, {b, {{20, 200, 90}}}, {c, {{60, 30, 240}}}}}};
    };
    scene.triangles = {triangle(latticePixel(22, 30), latticePixel(3, 11), latticePixel(22, 4)),
                       triangle(latticePixel(26, 5), latticePixel(44, 9), latticePixel(44, 41))};
    return scene;
}

WalkLines linesOf(const QString &method)
{
    return method == QStringLiteral("row-walk") ? WalkLines::Rows : WalkLines::Columns;
}

/// The defect pictures of a method, kept for all programs of a class.
DefectPictures &defectPicturesOf(const QString &method)
{
    static DefectPictures ofColumns(probeSheet(QStringLiteral("column-scan")));
    static DefectPictures ofRows(probeSheet(QStringLiteral("row-walk")));
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

} // namespace

/// The defects match programs that were not written for them.
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
        for (const Scene &scene : probeSheet(method))
            QCOMPARE(studentPicture(scene, linesOf(method), mistakes).colours,
                     pictureOf(scene).colours);
    }

    void theSheetNamesTheMistakeOfAProgram_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("id");
        QTest::addColumn<Mistakes>("mistakes");
        for (const MistakenProgram &program :
             casesToRun(mistakenPrograms(), &MistakenProgram::group))
            QTest::addRow("%s, %s", qPrintable(program.method), qPrintable(program.id))
                << program.method << program.id << program.mistakes;
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

        // A right program may also leave out samples that lie on vertices only.
        QVERIFY(diagnosis.verdict != DiagnosisVerdict::Right);
        QVERIFY2(diagnosis.isExplained(), qPrintable(textOf(diagnosis)));
        // A pair may always draw the same: a stored level loses what a step rounded down loses.
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
        // With unsorted vertices, spans begin outside the frame, where a program adds up what the
        // walk reaches in one step.
        const QStringList ids = {QStringLiteral("no-edge-pre-step"),
                                 QStringLiteral("whole-slopes"),
                                 QStringLiteral("whole-edge-steps"),
                                 QStringLiteral("whole-colours"),
                                 QStringLiteral("whole-colour-rates"),
                                 QStringLiteral("whole-places"),
                                 QStringLiteral("colour-divisor-samples"),
                                 QStringLiteral("colour-divisor-plus-one"),
                                 QStringLiteral("long-edge-begun-again"),
                                 QStringLiteral("edge-pre-step-backward"),
                                 QStringLiteral("second-edge-carried-on"),
                                 QStringLiteral("edges-stepped-first"),
                                 QStringLiteral("extra-first-sample"),
                                 QStringLiteral("colours-without-edge-pre-step")};
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("id");
        QTest::addColumn<Mistakes>("mistakes");
        for (const MistakenProgram &program : mistakenPrograms()) {
            QString id = program.id;
            if (ids.contains(id.remove(QStringLiteral("-from-below"))))
                QTest::addRow("%s, %s", qPrintable(program.method), qPrintable(program.id))
                    << program.method << program.id << program.mistakes;
        }
    }
    void aProgramInDoubleHasTheDefectInDouble()
    {
        QFETCH(QString, method);
        QFETCH(QString, id);
        QFETCH(Mistakes, mistakes);
        for (Scene scene : probeSheet(method)) {
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
        QVERIFY(words("edge-pre-step-of-fraction")
                    .contains(QStringLiteral("by ⌈y₀⌉ − y₀ in place of y₀ − ⌊y₀⌋.")));
        QVERIFY(words("edge-pre-step-of-fraction-from-below")
                    .contains(QStringLiteral("by y₀ − ⌊y₀⌋ in place of ⌈y₀⌉ − y₀.")));
        QVERIFY(words("colour-pre-step-of-fraction")
                    .contains(QStringLiteral("by x_L − ⌊x_L⌋ in place of ⌈x_L⌉ − x_L.")));
        // The missing half is the same from either end.
        for (const char *id : {"first-half-missing", "first-half-and-middle-missing"})
            QVERIFY(words(id).contains(QStringLiteral("half with the lesser y is not drawn")));
        for (const char *id : {"second-half-missing", "second-half-behind-middle-missing"})
            QVERIFY(words(id).contains(QStringLiteral("half with the greater y is not drawn")));
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
        using M = WalkMistake;
        QTest::addColumn<QString>("choice");
        QTest::addColumn<QString>("id");
        QTest::addColumn<WalkMistake>("mistake");
        QTest::addColumn<WalkMistake>("made");
        const auto add = [](const char *id, M mistake) {
            for (const auto &[choice, made] :
                 {std::pair("equal-as-given", M::EqualAsGiven),
                  std::pair("equal-descending", M::EqualDescending),
                  std::pair("flat-end-from-vertices", M::FlatEndFromVertices),
                  std::pair("flat-end-from-edges", M::FlatEndFromEdges)}) {
                const bool isSeen = made == M::EqualAsGiven || made == M::EqualDescending
                    || mistake != M::UnsortedColours;
                if (isSeen)
                    QTest::addRow("%s, %s", choice, id)
                        << QString::fromLatin1(choice) << QString::fromLatin1(id) << mistake
                        << made;
            }
        };
        add("divisor-plus-one", M::EdgeDivisorPlusOne);
        add("divisor-minus-one", M::EdgeDivisorMinusOne);
        add("unsorted-colours", M::UnsortedColours);
    }
    void howAFlatEndIsDrawnIsToldBesideAMistakeAlone()
    {
        QFETCH(QString, choice);
        QFETCH(QString, id);
        QFETCH(WalkMistake, mistake);
        QFETCH(WalkMistake, made);
        const Scene scene = verticalEdges();
        const auto drawn = [&scene](const Mistakes &all) {
            return studentPicture(scene, WalkLines::Columns, all);
        };
        QCOMPARE(drawn({made}).colours, pictureOf(scene).colours);

        const auto diagnosis = diagnose(std::vector{Submission{scene, drawn({mistake, made})}});

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
                 QStringLiteral("Column 5, first half: (5, 5) is drawn but should not be"));
        QCOMPARE(partingText("upside-down"), QString()); // nothing is wrong in its run
    }
};

PIXELPLUMB_TEST(TestProgramDefects)

} // namespace tst_programdefects

#include "tst_programdefects.moc"
