// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/defectivescene.h"
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/scan/redrawing.h"
#include "core/methods/method.h"
#include "core/runs/scenerun.h"
#include "tests/support/scenes/probescenes.h"
#include "tests/support/scenes/shapeexamples.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QMap>
#include <QTest>

#include <algorithm>

namespace tst_mixedmethods {

using namespace pixelplumb;

namespace {

/// One scene for each kind of primitive that a method draws; frames of three sizes.
std::vector<Scene> scenesOfAllMethods()
{
    std::vector<Scene> scenes;
    const auto add = [&](Scene scene, const QString &method) {
        scene.method = method.toStdString();
        const auto turn = int(scenes.size() % 3);
        scene.frame.width = 7 + turn;
        scene.frame.height = 9 - 2 * turn;
        const auto &rules = methodNamed(method)->fillRules;
        if (!rules.empty() && !methodNamed(method)->supports(scene.settings.fillRule))
            scene.settings.fillRule = rules.front();
        if (objectionTo(scene).isEmpty())
            scenes.push_back(scene);
    };
    for (const Method &method : methods()) {
        if (method.draws(PrimitiveKind::Triangle))
            add(sceneWith({coloured({latticePixel(1, 1), latticePixel(6, 1), latticePixel(1, 5)}),
                           coloured({latticePixel(6, 1), latticePixel(6, 4), latticePixel(1, 5)})}),
                method.id);
        for (const ShapeExample &example : shapeExamples()) {
            if (method.draws(example.shape))
                add(sceneOf(example.shape, "column-scan", {}), method.id);
        }
    }
    return scenes;
}

/// What a defect does, worded coarsely so that there are few kinds.
QString kindOf(const Defect &defect)
{
    QString kind = QString::number(int(defect.stage())) + u' ' + defect.choice;
    if (defect.standsAlone)
        kind += u" alone"_s;
    if (defect.stage() == DefectStage::Drawing && !defect.redrawing)
        kind += u" lines"_s;
    if (const Redrawing *redrawing = defect.redrawing.get()) {
        kind += redrawing->walk ? u" walk"_s : QString();
        kind += redrawing->edgeTest ? u" test"_s : QString();
        kind += redrawing->bytes.isRight() ? QString() : u" bytes"_s;
        kind += u" %1%2%3"_s.arg(int(redrawing->overflow))
                    .arg(int(redrawing->repainting))
                    .arg(int(redrawing->box));
    }
    return kind;
}

/// Up to two defects of each kind that the scenes can have.
std::vector<std::size_t> someOfEachKind(const std::vector<Defect> &defects)
{
    QMap<QString, int> counts;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < defects.size(); ++i) {
        if (counts[kindOf(defects[i])]++ < 2)
            places.push_back(i);
    }
    return places;
}

/// A picture that nothing draws.
Picture noise(const FrameSpec &frame)
{
    Picture picture = emptyPicture(frame);
    for (std::size_t i = 0; i < picture.size(); ++i) {
        picture.covered[i] = i % 3 == 0 ? 1 : 0;
        if (picture.covered[i] != 0)
            picture.colours[i] = {{std::uint8_t(17 * i), std::uint8_t(91 * i), 7}};
    }
    return picture;
}

QStringList setsOf(const Diagnosis &diagnosis)
{
    QStringList sets;
    for (const DiagnosisCandidate &candidate : diagnosis.candidates)
        sets += candidate.ids().join(u" and "_s);
    return sets;
}

/// The ways in which the programs with these defects find their samples.
QString waysOf(const std::vector<Defect> &defects)
{
    QStringList ways;
    for (const Defect &defect : defects) {
        if (defect.stage() == DefectStage::Drawing && !defect.redrawing)
            ways += u"lines"_s;
        if (defect.redrawing && defect.redrawing->walk)
            ways += u"walk"_s;
        if (defect.redrawing && defect.redrawing->edgeTest)
            ways += u"test"_s;
    }
    ways.removeDuplicates();
    return ways.join(u' ');
}

/// A scene each for a column walk, a row walk, an edge test, and a line.
std::vector<Scene> scenesOfOneProgram()
{
    constexpr Lattice quarter = unitsPerPixel / 4;
    std::vector<Scene> scenes;
    for (const char *method : {"column-scan", "row-walk", "edge-equations"})
        scenes.push_back(sceneWith({coloured({LatticePoint{5 * quarter, 6 * quarter},
                                              {43 * quarter, 13 * quarter},
                                              {18 * quarter, 33 * quarter}})},
                                   method));
    scenes.push_back(sceneOf(lineAt(2, 1, 10, 4), "line-bresenham", {}));
    for (Scene &scene : scenes) {
        scene.frame.width = 12;
        scene.frame.height = 9;
    }
    return scenes;
}

} // namespace

/// One program's pictures of scenes drawn by different methods, judged together.
class TestMixedMethods : public QObject {
    Q_OBJECT

private slots:
    void everyTwoKindsOfDefectsAreTogetherOrAreNot()
    {
        DefectPictures pictures(scenesOfAllMethods());
        const std::vector<Defect> &defects = pictures.defects();
        const std::vector<std::size_t> places = someOfEachKind(defects);
        QVERIFY(places.size() > 40);
        std::size_t together = 0;
        for (const std::size_t first : places) {
            for (const std::size_t second : places) {
                const bool areTogether = canBeTogether(defects[first], defects[second]);
                QCOMPARE(canBeTogether(defects[second], defects[first]), areTogether);
                if (first >= second || !areTogether)
                    continue;
                ++together;
                for (std::size_t scene = 0; scene < pictures.scenes().size(); ++scene) {
                    const DefectSet both{first, second};
                    const auto picture = pictures.picture(scene, both);
                    if (pictures.ownDefectsIn(both, scene).empty())
                        QVERIFY(picture == pictures.picture(scene, {})
                                || *picture == *pictures.picture(scene, {}));
                }
            }
        }
        QVERIFY(together > 100);
    }

    void noProgramWalksEdgesAndTestsThem()
    {
        std::vector<Defect> walks = defectsFor(probeScenes("row-walk").back());
        std::vector<Defect> tests = defectsFor(probeScenes("edge-equations").back());
        std::erase_if(walks,
                      [](const Defect &each) { return !each.redrawing || !each.redrawing->walk; });
        std::erase_if(
            tests, [](const Defect &each) { return !each.redrawing || !each.redrawing->edgeTest; });
        QVERIFY(!walks.empty() && !tests.empty());
        for (const Defect &walk : walks) {
            QVERIFY(!canBeTogether(walk, tests.front()));
            QVERIFY(!canBeTogether(tests.front(), walk));
        }
    }

    void everyMixOfMethodsIsSearchedToItsEnd()
    {
        QMap<QString, Scene> byWays;
        for (const Scene &scene : scenesOfAllMethods())
            byWays.insert(waysOf(defectsFor(scene)), scene);
        const QList<Scene> scenes = byWays.values();
        QCOMPARE(byWays.keys(), QStringList({"", "lines", "test", "walk"}));
        for (qsizetype i = 0; i < scenes.size(); ++i) {
            for (qsizetype j = 0; j < i; ++j) {
                const std::array submissions = {Submission{scenes[i], noise(scenes[i].frame)},
                                                Submission{scenes[j], noise(scenes[j].frame)}};
                const auto diagnosis
                    = diagnose(submissions, {}, {Leeway::Edges, Arithmetic::Exact});
                QVERIFY(diagnosis && !diagnosis->failure);
                QCOMPARE(nameOf(diagnosis->verdict), u"wrong"_s);
            }
        }
    }

    void aDefectOfOneMethodIsNamedAmongOthers_data()
    {
        QTest::addColumn<int>("scene");
        QTest::addColumn<QString>("id");
        QTest::newRow("a variant of a walk") << 0 << u"no-edge-pre-step"_s;
        QTest::newRow("a walk of ours") << 1 << u"whole-slopes"_s;
        QTest::newRow("an edge test of ours") << 2 << u"slack-of-half-a-pixel"_s;
        QTest::newRow("a line's end") << 3 << u"last-pixel-missing"_s;
    }
    void aDefectOfOneMethodIsNamedAmongOthers()
    {
        QFETCH(int, scene);
        QFETCH(QString, id);
        std::vector<Submission> submissions;
        for (const Scene &each : scenesOfOneProgram())
            submissions.push_back({each, pictureOf(each)});
        const std::vector<Defect> all = defectsFor(submissions[std::size_t(scene)].scene);
        const auto defect = std::ranges::find(all, id, &Defect::id);
        QVERIFY(defect != all.end());
        // Put in wherever it can be: it is one program.
        for (Submission &each : submissions) {
            const auto own = ownDefects(defectsFor(each.scene), std::span(&*defect, 1));
            each.picture = pictureWith(each.scene, own);
        }

        const auto diagnosis = diagnose(submissions);

        QVERIFY(diagnosis && diagnosis->isExplained());
        QVERIFY2(setsOf(*diagnosis).contains(id), qPrintable(setsOf(*diagnosis).join(u", "_s)));
    }
};

PIXELPLUMB_TEST(TestMixedMethods)

} // namespace tst_mixedmethods

#include "tst_mixedmethods.moc"
