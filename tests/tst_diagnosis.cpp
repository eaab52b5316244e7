// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/counterexample.h"
#include "core/grade/diagnosis.h"
#include "core/grade/invariants.h"
#include "core/grade/probesheet.h"
#include "core/scene/fileaccess.h"
#include "core/scene/scenefile.h"
#include "tests/support/programrun.h"
#include "tests/support/scanning.h"

#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
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
        DefectPictures pictures(scenes);
        for (const Defect &defect : defects) {
            std::vector<FoundPicture> found;
            for (const Scene &scene : scenes)
                found.push_back({found.size(), pictureWith(scene, std::span(&defect, 1))});
            const Diagnosis diagnosis = *diagnose(pictures, found);
            if (diagnosis.verdict == DiagnosisVerdict::Right)
                continue; // it does not show on these scenes
            ++seen;
            QVERIFY2(diagnosis.isExplained(), qPrintable(defect.id));
            QVERIFY2(isAmong(diagnosis, defect.id), qPrintable(defect.id));
            unique += int(diagnosis.candidates.size() == 1);
        }
        qInfo("%s: %d defects, %d seen, %d unique", qPrintable(method), int(defects.size()), seen,
              unique);
        // Arithmetic that is exact enough at this size shows nothing, and rightly so.
        QVERIFY(seen >= int(defects.size()) - 6);
        QVERIFY(unique * 10 >= seen * 8);
    }

    void theProbeSheetTellsAllDefectsApart_data()
    {
        QTest::addColumn<int>("fewest");
        QTest::newRow("column-scan") << 80;
        QTest::newRow("row-walk") << 90;
        QTest::newRow("edge-equations") << 48;
        QTest::newRow("barycentric-rectangle") << 48;
        QTest::newRow("line-bresenham") << 30;
    }
    void theProbeSheetTellsAllDefectsApart()
    {
        QFETCH(int, fewest);
        const QString method = QString::fromLatin1(QTest::currentDataTag());
        const QDir folder(QStringLiteral(PIXELPLUMB_RESOURCES "/probes"));
        std::vector<Scene> scenes;
        for (const QString &name : folder.entryList({method + QStringLiteral("-*.json")})) {
            const auto reading = readSceneFile(folder.filePath(name));
            QVERIFY2(bool(reading), qPrintable(name));
            QCOMPARE(reading->scene.method, method.toStdString());
            scenes.push_back(reading->scene);
        }
        QVERIFY(scenes.size() >= 1 && scenes.size() <= 3);
        const ProbeResult result = probe(scenes);
        QStringList alike;
        for (const AlikeDefects &group : result.alike) {
            for (const Defect &defect : group.defects)
                alike += defect.id;
        }
        QVERIFY2(alike.isEmpty(), qPrintable(alike.join(u' ')));
        QCOMPARE(result.distinct(), result.defects + 1);
        // Far shifts are many, and no kinds of their own.
        const std::vector<Defect> defects = defectsFor(scenes.front());
        QVERIFY(std::ranges::count(defects, false, &Defect::standsAlone) >= fewest);
    }

    void theSearchFindsTheSheetAgain()
    {
        const QTemporaryDir folder;
        const QString name = QStringLiteral("/row-walk-1.json");
        const ProgramRun result
            = run({QStringLiteral("probes"), QStringLiteral("--method"), QStringLiteral("row-walk"),
                   QStringLiteral("-o"), folder.path(), QStringLiteral("--json")});
        QCOMPARE(result.exitCode, 0);
        const QJsonDocument json = QJsonDocument::fromJson(result.output);
        QVERIFY(json[QStringLiteral("alike")].toArray().isEmpty());
        QCOMPARE(json[QStringLiteral("distinct")].toInt(),
                 json[QStringLiteral("defects")].toInt() + 1);
        QCOMPARE(*readFile(folder.path() + name),
                 *readFile(QStringLiteral(PIXELPLUMB_RESOURCES "/probes") + name));
    }

    void oneTriangleLeavesDefectsAlike()
    {
        const std::vector<Scene> scenes = {sceneWith({triangleAt(5, 5, 30, 5, 5, 30)})};
        const ProbeResult result = probe(scenes);
        QVERIFY(!result.alike.empty());
        QVERIFY(result.alike.front().equalRight);
        // Of one triangle alone nothing is toggled: what is gone through again is the same.
        QVERIFY(std::ranges::any_of(result.alike.front().defects, [](const Defect &defect) {
            return defect.id == QStringLiteral("parity");
        }));
        QVERIFY(result.distinct() < result.defects + 1);
        QVERIFY(result.distinct() > 20);
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

    void aCounterExampleIsFoundAndShrunk_data()
    {
        QTest::addColumn<QString>("one");
        QTest::addColumn<QString>("other");
        QTest::addColumn<int>("largest"); // px
        const auto row = [](const char *one, const char *other, int largest) {
            QTest::addRow("%s, %s", one, other)
                << QString::fromLatin1(one) << QString::fromLatin1(other) << largest;
        };
        row("column-scan:float32", "truth", 64);
        row("column-scan:exact:open", "column-scan:exact:closed", 4);
        row("no-colour-pre-step", "column-scan", 9);
        row("truth", "divisor-plus-one", 9);
        row("parity", "column-scan", 9);
        row("line-bresenham", "one-step-short", 4);
        row("line-bresenham", "line-dda", 9);
    }
    void aCounterExampleIsFoundAndShrunk()
    {
        QFETCH(QString, one);
        QFETCH(QString, other);
        QFETCH(int, largest);
        const QTemporaryDir folder;
        const QStringList arguments = {QStringLiteral("counterexample"),
                                       one,
                                       other,
                                       QStringLiteral("-o"),
                                       folder.filePath(QStringLiteral("c.json")),
                                       QStringLiteral("--json")};

        const ProgramRun result = run(arguments);

        QCOMPARE(result.exitCode, 1);
        const QJsonDocument json = QJsonDocument::fromJson(result.output);
        QVERIFY(!json[QStringLiteral("pixels")].toArray().isEmpty());
        const auto reading = readSceneFile(folder.filePath(QStringLiteral("c.json")));
        QVERIFY(bool(reading));
        QVERIFY(reading->scene.frame.width * reading->scene.frame.height <= largest);
        QCOMPARE(run(arguments).output, result.output);
    }

    void nothingShrinksAnyMore()
    {
        Scene conventions;
        const Method &method = *methodNamed(QStringLiteral("column-scan"));
        const PictureSource right = sourceOf(Contender{&method, conventions.settings});
        const PictureSource wrong
            = sourceOf(QStringLiteral("divisor-plus-one"), {&method, conventions.settings});
        const CounterSearch search = findCounterExample(right, wrong, conventions, 3);
        QVERIFY(search.found.has_value());
        QVERIFY(tryScene(right, wrong, search.found->scene).example.has_value());
        QCOMPARE(shrunk(*search.found, right, wrong).scene, search.found->scene);
        QCOMPARE(tryScene(right, right, search.found->scene).outcome, SceneOutcome::Same);
    }

    void invariantsFindMostDefectsAndNothingElse_data()
    {
        QTest::addColumn<int>("missed"); // at most
        QTest::newRow("column-scan") << 2;
        QTest::newRow("row-walk") << 4;
        QTest::newRow("edge-equations") << 2;
        QTest::newRow("barycentric-rectangle") << 2;
    }
    void invariantsFindMostDefectsAndNothingElse()
    {
        QFETCH(int, missed);
        const QByteArray name = QTest::currentDataTag();
        Scene conventions;
        conventions.method = name.toStdString();
        const Contender method{methodNamed(QString::fromLatin1(name)), {}};
        constexpr int pairs = 60;
        QVERIFY(checkInvariants(sourceOf(method), conventions, 1, pairs).broken.empty());
        QStringList unseen;
        for (const Defect &defect : defectsFor(probes(name.constData()).back())) {
            if (!defect.standsAlone
                && checkInvariants(sourceOf(defect.id, method), conventions, 1, pairs)
                       .broken.empty())
                unseen += defect.id;
        }
        QVERIFY2(unseen.size() <= missed, qPrintable(unseen.join(u' ')));
    }

    void aRightProgramBesideATriangleWithoutAreaIsNotCalledWrong()
    {
        Scene scene = probes("column-scan").front();
        scene.triangles.insert(
            scene.triangles.begin(),
            coloured({latticePixel(1, 1), latticePixel(2, 2), latticePixel(3, 3)}));
        Scene rounded = scene;
        rounded.settings.arithmetic = Arithmetic::Float32;
        const Picture found = pictureOf(rounded);
        QVERIFY(differingPixels(pictureOf(scene), found) > 0);
        const auto diagnosis = diagnose(std::vector{Submission{scene, found}});
        QCOMPARE(diagnosis->verdict, DiagnosisVerdict::Undecidable);
    }

    void aShiftIsNamedOfScenesWithSeveralBackgrounds()
    {
        const Scene black = sceneWith(
            {coloured({latticePixel(4, 5), latticePixel(30, 9), latticePixel(12, 30)})});
        Scene white = black;
        white.frame.background = {{255, 255, 255}};
        std::vector<Submission> submissions;
        for (const Scene &scene : {black, white}) {
            const auto defects = defectsFor(scene);
            const auto shift = std::ranges::find(defects, "shifted-by-1-to-the-right", &Defect::id);
            QVERIFY(shift != defects.end());
            submissions.push_back({scene, pictureWith(scene, std::span(&*shift, 1))});
        }
        const auto diagnosis = diagnose(submissions);
        QVERIFY(diagnosis->isExplained());
        QCOMPARE(diagnosis->candidates.front().defects.front().id, "shifted-by-1-to-the-right");
    }

    void aBoxIsFilledOfASliverWithoutSamples()
    {
        const Scene scene
            = sceneWith({coloured({LatticePoint{2 * unitsPerPixel + 64, 2 * unitsPerPixel + 80},
                                   LatticePoint{9 * unitsPerPixel + 64, 5 * unitsPerPixel + 70},
                                   LatticePoint{9 * unitsPerPixel + 66, 5 * unitsPerPixel + 71}})},
                        "edge-equations");
        const Picture right = pictureOf(scene);
        QCOMPARE(std::ranges::count(right.covered, 1), 0);
        const auto defects = defectsFor(scene);
        const auto filled = std::ranges::find(defects, "box-filled", &Defect::id);
        QVERIFY(filled != defects.end());
        const Picture picture = pictureWith(scene, std::span(&*filled, 1));
        QCOMPARE(std::ranges::count(picture.covered, 1), 7 * 3); // x 3 … 9, y 3 … 5
    }

    void whatRoundingBreaksIsToldApart_data()
    {
        QTest::addColumn<QString>("drawer");
        QTest::addColumn<QString>("tolerance");
        QTest::addColumn<QString>("invariant");
        QTest::addColumn<bool>("mayBeRounding");
        const auto row = [](const char *drawer, const char *tolerance, const char *invariant,
                            bool mayBeRounding) {
            QTest::addRow("%s, %s: %s", drawer, tolerance, invariant)
                << drawer << tolerance << invariant << mayBeRounding;
        };
        row("column-scan:float32", "float32", "count", true); // a sample on an edge
        row("edge-equations:float32", "float32", "order", true);
        row("edge-equations:float32", "exact", "order", false); // a byte, beside an edge
        row("unsorted-colours", "float32", "corners", false); // on an edge, but in another colour
        row("first-half-missing", "float32", "count", false);
        row("unsorted-colours", "float32", "order", false);
    }
    void whatRoundingBreaksIsToldApart()
    {
        QFETCH(QString, drawer);
        QFETCH(QString, tolerance);
        QFETCH(QString, invariant);
        QFETCH(bool, mayBeRounding);
        const QStringList words
            = {QStringLiteral("invariants"), drawer, QStringLiteral("--tolerance"), tolerance};

        const ProgramRun json = run(words + QStringList{QStringLiteral("--json")});
        const ProgramRun text = run(words);

        QCOMPARE(json.exitCode, 1);
        QCOMPARE(text.exitCode, 1);
        const QJsonArray broken
            = QJsonDocument::fromJson(json.output)[QStringLiteral("broken")].toArray();
        const auto found = std::ranges::find_if(broken, [&](const QJsonValue &each) {
            return each[QStringLiteral("invariant")] == invariant;
        });
        QVERIFY2(found != broken.end(), json.output.constData());
        QCOMPARE((*found)[QStringLiteral("mayBeRounding")].toBool(), mayBeRounding);
        const QString lines = QString::fromUtf8(text.output)
                                  .section(QStringLiteral("broken  %1: ").arg(invariant), 1)
                                  .section(u'\n', 1, 2);
        QCOMPARE(
            lines.contains(QStringLiteral("that the rounding of %1 leaves open").arg(tolerance)),
            mayBeRounding);
    }

    void whoDrawsNothingIsNotCalledRight()
    {
        const PictureSource nobody{
            QStringLiteral("nobody"), [](const Scene &) {
                return Result<Picture>(InputError{{}, QStringLiteral("is away"), {}});
            }};
        const Contender right{methodNamed(QStringLiteral("column-scan")), {}};
        const Scene conventions;

        const CounterSearch search = findCounterExample(nobody, sourceOf(right), conventions, 1);
        const InvariantReport report = checkInvariants(nobody, conventions, 1, 60);

        QVERIFY(!search.found);
        QCOMPARE(search.compared, 0);
        QCOMPARE(search.undrawn, 100); // and then it is enough
        QCOMPARE(search.firstUndrawn->source, QStringLiteral("nobody"));
        QCOMPARE(report.firstUndrawn->why.message(), QStringLiteral("is away"));
        QCOMPARE(report.checked, 0);
        QVERIFY(report.undrawn > 10);
    }

    void aCounterExampleTellsTheStepOfWhatNoKernelDraws()
    {
        const ProgramRun result
            = run({QStringLiteral("counterexample"), QStringLiteral("column-scan"),
                   QStringLiteral("last-sample-missing")});
        QCOMPARE(result.exitCode, 1);
        QVERIFY2(result.output.contains("with last-sample-missing parts at step 4, Pixel (0, 1): "
                                        "(0, 1) is left out"),
                 result.output);
    }

    void aProgramHasItsCounterExample()
    {
        if (QStandardPaths::findExecutable(QStringLiteral("python3")).isEmpty())
            QSKIP("python3 is not there");
        // A raster of nothing: each triangle that covers a sample is one.
        const QString program
            = QStringLiteral("program:python3 -c \"import json, sys; f = json.load(sys.stdin)"
                             "['frame']; print(('.' * f['width'] + chr(10)) * f['height'], "
                             "end='')\"");
        const ProgramRun result = run({QStringLiteral("counterexample"), program,
                                       QStringLiteral("column-scan"), QStringLiteral("--json")});
        QVERIFY2(result.exitCode == 1, result.messages.constData());
        const QJsonDocument json = QJsonDocument::fromJson(result.output);
        QVERIFY(json[QStringLiteral("pixels")].toArray().size() >= 1);
        QCOMPARE(
            json[QStringLiteral("scene")][QStringLiteral("frame")][QStringLiteral("width")].toInt(),
            2);
        // Plain lines are no JSON: it draws nothing then, and nothing can be compared.
        for (const QString &command :
             {QStringLiteral("counterexample"), QStringLiteral("invariants")}) {
            QStringList words
                = {command, program, QStringLiteral("--input"), QStringLiteral("lines")};
            if (command == QStringLiteral("counterexample"))
                words.insert(2, QStringLiteral("column-scan"));
            const ProgramRun undrawn = run(words);
            QCOMPARE(undrawn.exitCode, 1);
            QVERIFY2(undrawn.messages.contains("exit code 1: json.decoder.JSONDecodeError"),
                     undrawn.messages.constData());
            QCOMPARE(
                run(words + QStringList{QStringLiteral("--time"), QStringLiteral("0")}).exitCode,
                2);
        }
    }

    void defectsAreThoseOfAProgramThatIsNotOurs_data()
    {
        QTest::addColumn<QString>("mode");
        QTest::newRow("") << QString();
        QTest::newRow("ends-truncated") << QStringLiteral("floor");
        QTest::newRow("ends-upward") << QStringLiteral("ceil");
        QTest::newRow("colour-divisor-plus-one") << QStringLiteral("plus");
        QTest::newRow("colours-without-edge-pre-step") << QStringLiteral("late");
    }
    void defectsAreThoseOfAProgramThatIsNotOurs()
    {
        QFETCH(QString, mode);
        if (QStandardPaths::findExecutable(QStringLiteral("python3")).isEmpty())
            QSKIP("python3 is not there");
        QStringList words = {QStringLiteral("try"), QStringLiteral("--json")};
        for (const char *number : {"1", "2", "3"})
            words += {QStringLiteral("--scene"),
                      QStringLiteral(PIXELPLUMB_RESOURCES "/probes/column-scan-%1.json")
                          .arg(QLatin1String(number))};
        const QString id = QString::fromLatin1(QTest::currentDataTag());

        const ProgramRun tried = run(
            words
            + QStringList{
                QStringLiteral("--"), QStringLiteral("python3"),
                QStringLiteral(PIXELPLUMB_RESOURCES "/../tests/data/student/columnscan.py"), mode});

        const QJsonDocument json = QJsonDocument::fromJson(tried.output);
        QCOMPARE(json[QStringLiteral("right")].toBool(), id.isEmpty());
        const QJsonArray candidates
            = json[QStringLiteral("diagnosis")][QStringLiteral("candidates")].toArray();
        QCOMPARE(candidates.isEmpty(), id.isEmpty());
        if (id.isEmpty())
            return;
        const QJsonObject first = candidates.first().toObject();
        QCOMPARE(first[QStringLiteral("distance")].toInt(-1), 0);
        QCOMPARE(first[QStringLiteral("defects")].toArray(), QJsonArray({id}));
        // Which step of the right run its picture parts from, though no run of ours has it.
        QVERIFY(first[QStringLiteral("parts")][QStringLiteral("step")].toInt() > 0);
        QVERIFY(!first[QStringLiteral("parts")][QStringLiteral("how")].toString().isEmpty());
    }

    void whereNoneIsFoundItSaysHowManyWereTried()
    {
        const ProgramRun result = run({QStringLiteral("counterexample"),
                                       QStringLiteral("column-scan"), QStringLiteral("truth")});
        QCOMPARE(result.exitCode, 0);
        QVERIFY2(result.output.contains("draw the same in 10081 scenes"),
                 result.output.constData());
        const ProgramRun unknown
            = run({QStringLiteral("counterexample"), QStringLiteral("no-color-pre-step"),
                   QStringLiteral("truth")});
        QCOMPARE(unknown.exitCode, 2);
        QVERIFY2(unknown.messages.contains("did you mean no-colour-pre-step"),
                 unknown.messages.constData());
        QVERIFY2(unknown.messages.contains("probes --list --method column-scan"),
                 unknown.messages.constData());
        QVERIFY2(unknown.messages.size() < 400, unknown.messages.constData());
    }

    void theDefectsOfAMethodAreListed()
    {
        const ProgramRun listed = run({QStringLiteral("probes"), QStringLiteral("--list"),
                                       QStringLiteral("--method"), QStringLiteral("row-walk")});
        QCOMPARE(listed.exitCode, 0);
        for (const Scene &scene : probes()) {
            if (scene.method != "row-walk")
                continue;
            for (const Defect &defect : defectsFor(scene))
                QVERIFY2(listed.output.contains('\n' + defect.id.toUtf8() + ' ')
                             || listed.output.startsWith(defect.id.toUtf8() + ' '),
                         qPrintable(defect.id));
        }
        QVERIFY(listed.output.contains("\nunsorted-colours "));
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

    void nobodyIsJudgedByAMethodThatDrawsNothingOfTheScene_data()
    {
        QTest::addColumn<QStringList>("words");
        const QStringList method = {QStringLiteral("--scene"), defaultScene(),
                                    QStringLiteral("--method"), QStringLiteral("line-bresenham")};
        QTest::newRow("diagnose") << QStringList{QStringLiteral("diagnose"), QStringLiteral("-")}
                + method;
        QTest::newRow("try") << QStringList{QStringLiteral("try"), QStringLiteral("true")} + method;
    }
    void nobodyIsJudgedByAMethodThatDrawsNothingOfTheScene()
    {
        QFETCH(QStringList, words);
        const ProgramRun result = run(words, "..\n");
        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains("method “line-bresenham” draws none of the primitives"),
                 result.messages.constData());
    }

    void aRasterWithAnotherCharacterIsToldWithItsPlace()
    {
        const ProgramRun result = run({QStringLiteral("diagnose"), QStringLiteral("-"),
                                       QStringLiteral("--scene"), defaultScene()},
                                      "#.#\n#?#\n");
        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains("line 2, column 2: “?”; expected # or ."),
                 result.messages.constData());
    }
};

QTEST_GUILESS_MAIN(TestDiagnosis)
#include "tst_diagnosis.moc"
