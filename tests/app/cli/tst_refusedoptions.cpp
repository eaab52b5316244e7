// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileaccess.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace tst_refusedoptions {

using namespace pixelplumb;

/// What a command would pass over, or could not do at its end, it refuses at once.
class TestRefusedOptions : public QObject {
    Q_OBJECT

private slots:
    void nothingThatIsAskedForIsPassedOver_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QStringList &arguments, const char *message) {
            QTest::newRow(name) << arguments << QString::fromUtf8(message);
        };
        const QString scene = defaultScene();
        row("a word after the version", {"--version", "x"}, "--version: unexpected argument “x”");
        row("two words after help", {"--help", "trace", "x"}, "help: unexpected argument “x”");
        row("a layer twice", {"render", scene, "-o", "w.png", "--layers", "box,box"},
            "--layers: “box” is named twice; expected each layer once");
        row("a variant twice",
            {"render", scene, "--ascii", "--variant", "no-colour-pre-step,no-colour-pre-step"},
            "--variant: “no-colour-pre-step” is named twice; expected each variant once");
        row("variants that cancel each other",
            {"render", scene, "--ascii", "--variant", "divisor-plus-one,divisor-minus-one"},
            "--variant: the variants divisor-minus-one and divisor-plus-one cancel each other");
        row("a picture of no kind", {"render", scene, "-o", "w"},
            "-o w: the name does not say which kind of picture; expected a name that ends in .png");
        row("a picture without a name", {"render", scene, "-o", ""},
            "-o is empty; expected its file");
        row("differences of no kind", {"diff", scene, scene, "-o", "w"}, "-o w: the name does not");
        row("a raster as JSON", {"diff", scene, scene, "--ascii", "--json"},
            "--ascii and --json: a raster is no JSON; expected one of them");
        row("a list of defects in a folder", {"probes", "--list", "-o", "w"},
            "--list searches nothing, and there is nothing to write; expected it without -o");
        row("a list of defects by lot", {"probes", "--list", "--seed", "5"},
            "--list searches nothing, and no scenes are drawn by lot; expected it without --seed "
            "and --candidates");
        row("a seed of more than 64 bits", {"probes", "--seed", "99999999999999999999"},
            "--seed: “99999999999999999999” is no whole number of 64 bits; expected 0 … "
            "18446744073709551615");
        row("a picture of no name", {"diagnose", "", "--scene", scene},
            "PICTURE is empty: what a program drew of each scene");
        row("a scene of no name among others", {"render", scene, "", "--ascii"},
            "SCENE is empty: scene files (JSON), or - for standard input");
        row("a study of no scene", {"lab", ""}, "SCENE is empty: a scene file");
        row("a method of no name", {"methods", ""}, "NAME is empty: One method, whole");
        row("probes of no scene", {"probes", "", "--candidates", "1"},
            "SCENE is empty: a scene with the assignment's conventions");
        row("a pixel of no column", {"pixel", scene, "", "1"}, "is empty");
        row("a program of no name", {"try", "--scene", scene, ""}, "PROGRAM is empty");
        row("probes of circles", {"probes", "--method", "circle-midpoint"},
            "--method: method “circle-midpoint” draws circles and ellipses, of which there "
            "are no random scenes; expected a method that draws triangles or lines");
        row("one frame of all", {"motion", sceneFile("moving-sliver.json"), "--frame", "1"},
            "--frame: motion counts in all frames of the scene");
        row("methods of other primitives", {"counterexample", "column-scan", "line-bresenham"},
            "OTHER: “line-bresenham” draws lines, “column-scan” draws triangles; expected methods "
            "that draw the same primitives");
    }
    void nothingThatIsAskedForIsPassedOver()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, message);

        const ProgramRun result = run(arguments);

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(QString::fromUtf8(result.messages).contains(message), result.messages.constData());
        QCOMPARE(result.output, QByteArray());
        QVERIFY(!QFile::exists(QStringLiteral("w")));
    }

    void aPlaceThatTakesNoFileIsRefusedBeforeTheSearch_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("probes") << QStringList{"probes", "-o"};
        QTest::newRow("counterexample")
            << QStringList{"counterexample", "column-scan", "column-scan:float32", "-o"};
    }
    void aPlaceThatTakesNoFileIsRefusedBeforeTheSearch()
    {
        QFETCH(QStringList, arguments);
        const QTemporaryDir folder;
        const QString file = folder.filePath("file");
        QVERIFY(!writeFile(file, "here"));

        const ProgramRun result = run(arguments + QStringList{file + QStringLiteral("/there/")});

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains("/there/"), result.messages.constData());
        QCOMPARE(result.output, QByteArray());
    }

    void aFolderNeedsNoSlashAtItsEnd()
    {
        const QTemporaryDir folder;

        const ProgramRun probes
            = run({"probes", "--candidates", "8", "-o", folder.filePath("sheet")});
        const ProgramRun found
            = run({"counterexample", "column-scan", "truth:open", "-o", folder.path()});

        QCOMPARE(probes.exitCode, 0);
        QVERIFY(QFile::exists(folder.filePath("sheet/column-scan-1.json")));
        QCOMPARE(found.exitCode, 1);
        QVERIFY(QFile::exists(folder.filePath("counterexample.json")));
    }

    void whatASceneLeavesOpenIsAsTheMethodHasIt()
    {
        const QByteArray scene = R"({ "pixelplumb": 1, "frame": { "width": 8, "height": 8 },
            "primitives": [ { "triangle": [[1, 1], [6, 2], [3, 6]],
                              "colors": ["#ff0000", "#00ff00", "#0000ff"] } ] })";
        QByteArray named = scene;
        named.replace("\"primitives\"", "\"fillRule\": \"closed\", \"primitives\"");
        const QStringList words{"render", "-", "--ascii", "--method"};
        const QString method = QStringLiteral("barycentric-off-screen");

        QCOMPARE(run(words + QStringList{method}, scene).exitCode, 0);
        const ProgramRun refused = run(words + QStringList{method}, named);
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.messages.contains("closed"), refused.messages.constData());
    }
};

PIXELPLUMB_TEST(TestRefusedOptions)

} // namespace tst_refusedoptions

#include "tst_refusedoptions.moc"
