// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnosis.h"
#include "core/scene/scenefile.h"
#include "tests/support/programrun.h"
#include "tests/support/scanning.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace pixelplumb;

namespace {

Triangle coloured(const std::array<LatticePoint, 3> &points)
{
    return {{{{points[0], {{250, 40, 10}}},
              {points[1], {{20, 200, 90}}},
              {points[2], {{60, 30, 240}}}}}};
}

Scene sceneWith(std::vector<Triangle> triangles, const char *method = "column-scan")
{
    Scene scene;
    scene.frame.width = 40;
    scene.frame.height = 40;
    scene.method = method;
    scene.triangles = std::move(triangles);
    return scene;
}

/// Three triangles that part what one does not, two of them in one scene with a shared edge.
std::vector<Scene> probes(const char *method = "column-scan")
{
    const auto at = [](std::int64_t x, std::int64_t y) { return LatticePoint{x * 128, y * 128}; };
    return {sceneWith({coloured({at(71, 73), at(27, 13), at(50, 12)})}, method),
            sceneWith({coloured({at(8, 60), at(58, 66), at(50, 16)}),
                       coloured({at(58, 66), at(50, 16), at(75, 20)})},
                      method),
            // A square of two: edges along rows, columns and the diagonal pass through samples.
            sceneWith({coloured({at(58, 72), at(24, 66), at(58, 40)}),
                       coloured({at(10, 10), at(40, 10), at(10, 40)}),
                       coloured({at(40, 40), at(40, 10), at(10, 40)})},
                      method)};
}

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

/// The bug is named by the picture that it draws.
class TestDiagnosis : public QObject {
    Q_OBJECT

private slots:
    void aRightPictureIsRight()
    {
        const Diagnosis diagnosis = *diagnose(submissionsOf(probes(), {}));
        QCOMPARE(diagnosis.verdict, DiagnosisVerdict::Right);
        QVERIFY(diagnosis.candidates.empty());
    }

    void everyDefectIsAmongThoseThatAreNamed_data()
    {
        QTest::addColumn<QString>("method");
        for (const char *method :
             {"column-scan", "row-walk", "edge-equations", "barycentric-rectangle"})
            QTest::newRow(method) << QString::fromLatin1(method);
    }
    void everyDefectIsAmongThoseThatAreNamed()
    {
        QFETCH(QString, method);
        const std::vector<Scene> scenes = probes(method.toLatin1().constData());
        std::vector<Defect> defects;
        for (const Scene &scene : scenes) {
            for (const Defect &defect : defectsFor(scene)) {
                const bool isKnown
                    = std::ranges::find(defects, defect.id, &Defect::id) != defects.end();
                if (!isKnown && !defect.standsAlone)
                    defects.push_back(defect);
            }
        }
        int seen = 0;
        int unique = 0;
        for (const Defect &defect : defects) {
            const std::vector<Submission> submissions = submissionsOf(scenes, {defect});
            const Diagnosis diagnosis = *diagnose(submissions);
            if (diagnosis.verdict == DiagnosisVerdict::Right)
                continue; // it does not show on these scenes
            ++seen;
            QVERIFY2(diagnosis.isExplained(), qPrintable(defect.id));
            QVERIFY2(isAmong(diagnosis, defect.id), qPrintable(defect.id));
            unique += int(diagnosis.candidates.size() == 1);
        }
        qInfo("%s: %d defects, %d seen, %d unique", qPrintable(method), int(defects.size()), seen,
              unique);
        QVERIFY(defects.size() >= 28);
        // Arithmetic that is exact enough at this size shows nothing, and rightly so.
        QVERIFY(seen >= int(defects.size()) - 6);
        QVERIFY(unique * 10 >= seen * 8);
    }

    void twoDefectsTogetherAreFound()
    {
        const std::vector<Scene> scenes = probes();
        const std::vector<Defect> pair
            = {defectNamed(scenes.front(), QStringLiteral("no-colour-pre-step")),
               defectNamed(scenes.front(), QStringLiteral("half-pixel-down"))};
        const Diagnosis diagnosis = *diagnose(submissionsOf(scenes, pair));
        QVERIFY(diagnosis.isExplained());
        const bool isFound
            = std::ranges::any_of(diagnosis.candidates, [&](const DiagnosisCandidate &candidate) {
                  return candidate.defects.size() == 2 && candidate.defects[0].id == pair[0].id
                      && candidate.defects[1].id == pair[1].id;
              });
        QVERIFY(isFound);
        // No single one explains it.
        QVERIFY(std::ranges::none_of(diagnosis.candidates, [](const DiagnosisCandidate &candidate) {
            return candidate.defects.size() == 1;
        }));
    }

    void whatNoDefectExplainsHasItsNearestOnes()
    {
        const std::vector<Scene> scenes = probes();
        const Defect defect = defectNamed(scenes.front(), QStringLiteral("unsorted-colours"));
        std::vector<Submission> submissions = submissionsOf(scenes, {defect});
        submissions.front().picture.colours[5] = {{1, 2, 3}}; // a pixel that nobody would write
        const Diagnosis diagnosis = *diagnose(submissions);
        QCOMPARE(diagnosis.verdict, DiagnosisVerdict::Wrong);
        QVERIFY(!diagnosis.isExplained());
        QVERIFY(diagnosis.candidates.size() <= 5);
        QCOMPARE(diagnosis.candidates.front().distance, std::int64_t(1));
        QVERIFY(isAmong(diagnosis, defect.id));
    }

    void whatDiffersOnEdgesAloneIsUndecidable()
    {
        Scene scene = sceneWith({triangleAt(5, 5, 30, 5, 5, 30)});
        Submission submission{scene, pictureOf(scene)};
        const std::size_t onEdge = submission.picture.placeOf(12, 40 - 1 - 5);
        submission.picture.colours[onEdge] = scene.frame.background;
        submission.picture.covered[onEdge] = 0;
        const Diagnosis diagnosis = *diagnose(std::vector{submission});
        QCOMPARE(diagnosis.verdict, DiagnosisVerdict::Undecidable);
        QCOMPARE(diagnosis.differing, std::int64_t(1));
    }

    void theOrderOfTheScenesDoesNotMatter()
    {
        Scene whole = sceneWith({triangleAt(2, 2, 19, 4, 7, 13)});
        Scene between = sceneWith({coloured({LatticePoint{640, 704}, {4928, 1152}, {2112, 3456}})});
        const std::vector<Defect> pair
            = {defectNamed(between, QStringLiteral("vertices-truncated")),
               defectNamed(between, QStringLiteral("upside-down"))};
        std::vector<Submission> submissions = submissionsOf({whole, between}, pair);
        for (int order = 0; order < 2; ++order) {
            const Diagnosis diagnosis = *diagnose(submissions);
            QVERIFY(diagnosis.isExplained());
            QCOMPARE(diagnosis.candidates.front().defects.size(), 2U);
            QCOMPARE(diagnosis.candidates.front().defects[0].id, pair[0].id);
            std::ranges::reverse(submissions);
        }
    }

    void aPairIsNoNearerForWhatItDoesNotNeed()
    {
        const std::vector<Scene> scenes = probes();
        std::vector<Submission> submissions
            = submissionsOf(scenes, {defectNamed(scenes.front(), QStringLiteral("upside-down"))});
        submissions.front().picture.colours[5] = {{1, 2, 3}};
        const Diagnosis diagnosis = *diagnose(submissions);
        QVERIFY(!diagnosis.isExplained());
        for (const DiagnosisCandidate &candidate : diagnosis.candidates) {
            const bool hasPart = candidate.defects.size() == 2
                && std::ranges::any_of(candidate.defects, [](const Defect &defect) {
                                     return defect.id == QStringLiteral("upside-down");
                                 });
            QVERIFY(!hasPart); // one pixel is left with it, and with it and another
        }
    }

    void theStepWhereTheRunsPartIsTold()
    {
        const Scene scene = probes().front();
        const auto stepWith = [&](const char *id) {
            return partingStepOf(
                scene, withDefects(scene, std::vector{defectNamed(scene, QLatin1String(id))}));
        };
        const auto colour = stepWith("no-colour-pre-step");
        QVERIFY(colour.has_value());
        QVERIFY2(colour->heading.startsWith(QStringLiteral("Column")), qPrintable(colour->heading));
        QVERIFY2(colour->text.startsWith(QStringLiteral("first R is ")), qPrintable(colour->text));
        const auto place = stepWith("vertices-truncated");
        QVERIFY(place.has_value());
        QCOMPARE(place->step, std::size_t(0));
        QVERIFY2(place->text.startsWith(QStringLiteral("x₀ is 13, should be 13")),
                 qPrintable(place->text));
        QVERIFY(!partingStepOf(scene, scene).has_value());
    }

    void aDiagnosisCanBeEnded()
    {
        const std::vector<Scene> scenes = probes();
        const Defect defect = defectNamed(scenes.front(), QStringLiteral("flat-first"));
        int heard = 0;
        QVERIFY(!diagnose(submissionsOf(scenes, {defect}),
                          [&heard](const JobProgress &) { return ++heard < 7; }));
        QCOMPARE(heard, 7);
    }

    void theCommandNamesTheBug()
    {
        const QTemporaryDir folder;
        QStringList arguments = {QStringLiteral("diagnose"), QStringLiteral("--json")};
        int number = 0;
        for (const Scene &scene : probes()) {
            const QString file = folder.filePath(QStringLiteral("%1.json").arg(number));
            const QString picture = folder.filePath(QStringLiteral("%1.png").arg(number++));
            QVERIFY(!writeSceneFile(file, scene));
            const ProgramRun drawn
                = run({QStringLiteral("render"), file, QStringLiteral("-o"), picture,
                       QStringLiteral("--variant"), QStringLiteral("unsorted-colours")});
            QCOMPARE(drawn.exitCode, 0);
            arguments += {QStringLiteral("--scene"), file, picture};
        }
        const ProgramRun result = run(arguments);
        QCOMPARE(result.exitCode, 1);
        const QJsonDocument json = QJsonDocument::fromJson(result.output);
        QCOMPARE(json[QStringLiteral("verdict")].toString(), QStringLiteral("wrong"));
        const QJsonArray candidates = json[QStringLiteral("candidates")].toArray();
        QCOMPARE(candidates.size(), 1);
        const QJsonObject candidate = candidates.first().toObject();
        QCOMPARE(candidate[QStringLiteral("distance")].toInt(-1), 0);
        QCOMPARE(candidate[QStringLiteral("defects")].toArray(),
                 QJsonArray({QStringLiteral("unsorted-colours")}));
        QVERIFY(candidate[QStringLiteral("parts")].isObject());
    }

    void theCommandWantsAsManyScenesAsPictures()
    {
        const ProgramRun result
            = run({QStringLiteral("diagnose"), QStringLiteral("a.png"), QStringLiteral("b.png"),
                   QStringLiteral("--scene"), defaultScene()});
        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains("1 scenes and 2 pictures"), result.messages.constData());
    }
};

QTEST_GUILESS_MAIN(TestDiagnosis)
#include "tst_diagnosis.moc"
