// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileaccess.h"
#include "core/scene/inputrecord.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

#include <filesystem>
#include <vector>

namespace tst_inputsandoutputs {

using namespace pixelplumb;

namespace {

/// What a command reads, by its name in the folder of a test.
const QByteArray scene = R"({ "pixelplumb": 1, "frame": { "width": 8, "height": 8 },
    "camera": { "eye": [0, 0, 4], "fieldOfView": 40, "near": 1, "far": 10 },
    "materials": { "a": { "texture": "texture.png" } },
    "primitives": [ { "triangle": [[0, 0], [7, 0], [0, 5]],
                      "colors": ["#ff0000", "#00ff00", "#0000ff"] },
                    { "mesh": "mesh.obj", "material": "a" } ] })";
const QByteArray mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const QByteArray assignment = R"({ "pixelplumbAssignment": 1, "name": "One",
    "scenes": [ { "name": "one", "scene": "scene.json" } ] })";
const QByteArray studentProgram = "#!/bin/sh\nexit 1\n";

const QStringList &inputNames()
{
    static const QStringList names
        = {"scene.json", "texture.png", "mesh.obj", "assignment.json", "program.sh", "picture.png"};
    return names;
}

/// A command that writes a file, by the words after which its name stands, and what it reads.
struct WritingCommand {
    QStringList words;
    QString suffix; ///< of what it writes
    QStringList inputs;
};

const std::vector<WritingCommand> &writingCommands()
{
    const QStringList ofScene = {"scene.json", "texture.png", "mesh.obj"};
    static const std::vector<WritingCommand> all
        = {{{"render", "scene.json"}, "png", ofScene},
           {{"render", "scene.json"}, "ppm", ofScene},
           {{"trace", "scene.json"}, "csv", ofScene},
           {{"trace", "scene.json", "--format", "json"}, "json", ofScene},
           {{"compare", "scene.json", "--methods", "column-scan,truth"}, "png", ofScene},
           {{"diff", "scene.json", "picture.png"}, "png", ofScene + QStringList("picture.png")},
           {{"diff", "picture.png", "scene.json"}, "bmp", ofScene + QStringList("picture.png")},
           {{"lab", "scene.json", "--family", "own-scene", "--contender", "column-scan:float32"},
            "txt",
            ofScene},
           {{"counterexample", "column-scan", "program:./program.sh"}, "json", {"program.sh"}},
           {{"counterexample", "program:sh program.sh", "column-scan"}, "json", {"program.sh"}}};
    return all;
}

enum class Way { Symlink, Hardlink };

} // namespace

/// Whatever a command reads it never writes, by any name.
class TestInputsAndOutputs : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    QString path(const QString &name) const { return m_folder->filePath(name); }
    QByteArray contentOf(const QString &name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be read");
    }
    QList<QByteArray> inputs() const
    {
        QList<QByteArray> contents;
        for (const QString &name : inputNames())
            contents += contentOf(name);
        return contents;
    }
    bool alias(const QString &input, const QString &name, Way way) const
    {
        QFile::remove(path(name));
        if (way == Way::Symlink)
            return QFile::link(path(input), path(name));
        std::error_code error;
        std::filesystem::create_hard_link(path(input).toStdString(), path(name).toStdString(),
                                          error);
        return !error;
    }
    /// In the folder, as a person there would.
    ProgramRun runHere(const QStringList &arguments, const QString &shell = {}) const
    {
        QProcess process;
        process.setWorkingDirectory(m_folder->path());
        process.setStandardInputFile(QProcess::nullDevice());
        if (shell.isEmpty())
            process.start(program(), arguments);
        else
            process.start(QStringLiteral("/bin/sh"),
                          QStringList{QStringLiteral("-c"), shell, program()} + arguments);
        if (!process.waitForFinished(600'000))
            return {-1, {}, "did not end"};
        return {process.exitCode(), process.readAllStandardOutput(),
                process.readAllStandardError()};
    }

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(!writeFile(path("scene.json"), scene));
        QVERIFY(!writeFile(path("mesh.obj"), mesh));
        QVERIFY(!writeFile(path("assignment.json"), assignment));
        QVERIFY(!writeFile(path("program.sh"), studentProgram));
        QVERIFY(QFile::setPermissions(path("program.sh"),
                                      QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        QImage texture(4, 4, QImage::Format_RGB32);
        texture.fill(Qt::gray);
        QVERIFY(texture.save(path("texture.png")));
        QImage picture(8, 8, QImage::Format_RGB32);
        picture.fill(Qt::black);
        QVERIFY(picture.save(path("picture.png")));
        QVERIFY(QDir().mkpath(path("subs/ann")));
    }

    void theSceneIsDrawn()
    {
        QCOMPARE(runHere({"render", "scene.json", "-o", "out.png"}).exitCode, 0);
        QVERIFY(QFile::exists(path("out.png")));
    }

    void noInputIsReplaced_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QString>("suffix");
        QTest::addColumn<QString>("input");
        QTest::addColumn<Way>("way");
        for (const WritingCommand &command : writingCommands()) {
            for (const QString &input : command.inputs) {
                for (const Way way : {Way::Symlink, Way::Hardlink})
                    QTest::addRow("%s over %s, %s, %s", qPrintable(command.words.join(u' ')),
                                  qPrintable(input), qPrintable(command.suffix),
                                  way == Way::Symlink ? "symlink" : "hardlink")
                        << command.words << command.suffix << input << way;
            }
        }
    }
    void noInputIsReplaced()
    {
        QFETCH(QStringList, words);
        QFETCH(QString, suffix);
        QFETCH(QString, input);
        QFETCH(Way, way);
        const QString output = QStringLiteral("alias.") + suffix;
        QVERIFY(alias(input, output, way));
        const QList<QByteArray> before = inputs();

        const ProgramRun run = runHere(words + QStringList{"-o", output});

        QCOMPARE(inputs(), before);
        QVERIFY2(run.messages.contains("is the input, which it would replace"),
                 run.messages.constData());
        QCOMPARE(run.exitCode, 2);
    }

    void anInputsOwnNameIsNoOutput_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("the texture") << QStringList{"render", "scene.json", "-o", "texture.png"};
        QTest::newRow("by another path")
            << QStringList{"render", "scene.json", "-o", "subs/../texture.png"};
        QTest::newRow("the scene")
            << QStringList{"trace", "scene.json", "--format", "json", "-o", "scene.json"};
        QTest::newRow("the scene in its folder")
            << QStringList{"trace", "scene.json", "--format", "json", "-o", "."};
        QTest::newRow("the picture")
            << QStringList{"diff", "picture.png", "picture.png", "-o", "picture.png"};
        QTest::newRow("the program") << QStringList{"counterexample", "column-scan",
                                                    "program:./program.sh", "-o", "program.sh"};
        QTest::newRow("what a program's words name") << QStringList{
            "counterexample", "column-scan", "program:sh program.sh", "-o", "program.sh"};
    }
    void anInputsOwnNameIsNoOutput()
    {
        QFETCH(QStringList, arguments);
        const QList<QByteArray> before = inputs();

        const ProgramRun run = runHere(arguments);

        QCOMPARE(inputs(), before);
        QVERIFY2(run.messages.contains("is the input, which it would replace"),
                 run.messages.constData());
        QCOMPARE(run.exitCode, 2);
    }

    void whatAProgramIsShownIsNotReplaced_data()
    {
        QTest::addColumn<QString>("output");
        QTest::newRow("a module beside it") << "own/helper.py";
        QTest::newRow("below it") << "own/tables/sines.txt";
        QTest::newRow("by a link") << "link.json";
    }
    void whatAProgramIsShownIsNotReplaced()
    {
        QFETCH(QString, output);
        QVERIFY(QDir().mkpath(path("own/tables")));
        QVERIFY(QFile::copy(path("program.sh"), path("own/program.sh")));
        QVERIFY(!writeFile(path("own/helper.py"), "help"));
        QVERIFY(!writeFile(path("own/tables/sines.txt"), "0 1 0 -1"));
        QVERIFY(QFile::link(path("own/helper.py"), path("link.json")));
        const QByteArray before = contentOf(output);

        const ProgramRun run
            = runHere({"counterexample", "column-scan", "program:own/program.sh", "-o", output});

        QCOMPARE(contentOf(output), before);
        QVERIFY2(run.messages.contains("lies in a folder that is shown to a program"),
                 run.messages.constData());
        QCOMPARE(run.exitCode, 2);
        QVERIFY(!isInput(path(output))); // of this process
    }

    void standardOutputDoesNotChangeWhatAProgramIsShown_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("what is there") << QByteArray("help");
        QTest::newRow("nothing yet") << QByteArray();
    }
    void standardOutputDoesNotChangeWhatAProgramIsShown()
    {
        QFETCH(QByteArray, content);
        QVERIFY(QDir().mkpath(path("own")));
        QVERIFY(QFile::copy(path("program.sh"), path("own/program.sh")));
        QVERIFY(!writeFile(path("own/helper.py"), content));

        const ProgramRun run = runHere({"try", "own/program.sh", "--scene", "scene.json"},
                                       "\"$0\" \"$@\" >> own/helper.py");

        QCOMPARE(contentOf("own/helper.py") == content, !content.isEmpty());
        QCOMPARE(run.messages.contains("standard output: is the input"), !content.isEmpty());
    }

    void gradingDoesNotChangeASubmissionByStandardOutput()
    {
        QVERIFY(!writeFile(path("subs/ann/one.txt"), "picture"));
        const ProgramRun run
            = runHere({"grade", "subs", "--assignment", "assignment.json", "-o", "results"},
                      "\"$0\" \"$@\" >> subs/ann/one.txt");
        QCOMPARE(contentOf("subs/ann/one.txt"), QByteArray("picture"));
        QVERIFY2(run.messages.contains("standard output: is the input"), run.messages.constData());
        QCOMPARE(run.exitCode, 2);
    }

    void aPipeThatNobodyReadsIsNotWaitedForAndOneThatIsReadIsWritten()
    {
        QCOMPARE(::mkfifo(QFile::encodeName(path("pipe.ppm")).constData(), 0600), 0);

        const ProgramRun unread = runHere({"render", "scene.json", "-o", "pipe.ppm"});
        QVERIFY2(unread.messages.contains("nobody reads the pipe"), unread.messages.constData());
        QCOMPARE(unread.exitCode, 2);

        const ProgramRun read
            = runHere({"render", "scene.json", "-o", "pipe.ppm"},
                      "cat pipe.ppm > copy.ppm & until [ -e copy.ppm ]; do sleep 0.1; done;"
                      " \"$0\" \"$@\"; code=$?; wait; exit $code");
        QCOMPARE(read.exitCode, 0);
        QVERIFY(contentOf("copy.ppm").startsWith("P6\n8 8\n"));
        QCOMPARE(contentOf("copy.ppm").size(), 11 + 8 * 8 * 3);
    }

    void aSheetOfProbesDoesNotReplaceItsScene_data()
    {
        QTest::addColumn<QString>("input");
        QTest::newRow("scene") << QStringLiteral("scene.json");
        QTest::newRow("texture") << QStringLiteral("texture.png");
    }
    void aSheetOfProbesDoesNotReplaceItsScene()
    {
        QFETCH(QString, input);
        QVERIFY(alias(input, QStringLiteral("column-scan-1.json"), Way::Hardlink));
        const QList<QByteArray> before = inputs();

        const ProgramRun run
            = runHere({"probes", "scene.json", "--method", "column-scan", "-o", "."});

        QCOMPARE(inputs(), before);
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray()); // before the search
    }

    void oneScenesPictureIsNotAnothersTexture()
    {
        QVERIFY(!writeFile(path("texture.json"), R"({ "pixelplumb": 1,
            "frame": { "width": 8, "height": 8 }, "primitives": [] })"));
        const QList<QByteArray> before = inputs();

        const ProgramRun run = runHere({"render", "texture.json", "scene.json", "-o", "."});

        QCOMPARE(inputs(), before);
        QCOMPARE(run.exitCode, 2);
        QVERIFY(QFile::exists(path("scene.png"))); // which nobody reads
    }

    void redirectionDoesNotChangeWhatAnInputRefersTo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("input");
        for (const char *input : {"texture.png", "mesh.obj"}) {
            QTest::addRow("trace, %s", input)
                << QStringList{"trace", "scene.json"} << QString::fromLatin1(input);
            QTest::addRow("two scenes, %s", input)
                << QStringList{"render", "plain.json", "scene.json", "--ascii"}
                << QString::fromLatin1(input);
        }
        QTest::newRow("program") << QStringList{"counterexample", "column-scan",
                                                "program:./program.sh"}
                                 << QStringLiteral("program.sh");
        QTest::newRow("assignment")
            << QStringList{"grade", "subs", "--assignment", "assignment.json", "-o", "results"}
            << QStringLiteral("assignment.json");
    }
    void redirectionDoesNotChangeWhatAnInputRefersTo()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, input);
        QVERIFY(!writeFile(path("plain.json"),
                           "{ \"pixelplumb\": 1, "
                           "\"frame\": { \"width\": 8, \"height\": 8 }, \"primitives\": [ "
                           "{ \"triangle\": [[0, 0], [7, 0], [0, 5]], \"colors\": [\"#ff0000\", "
                           "\"#00ff00\", \"#0000ff\"] } ] }"));
        const QList<QByteArray> before = inputs();

        const ProgramRun run = runHere(arguments, QStringLiteral("\"$0\" \"$@\" >> ") + input);

        QCOMPARE(inputs(), before);
        QCOMPARE(run.exitCode, 2);
    }

    void aDashIsStandardOutputOrRefused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("exitCode");
        const auto row = [](const QStringList &arguments, int exitCode) {
            QTest::newRow(qPrintable(arguments.join(u' '))) << arguments << exitCode;
        };
        row({"render", "scene.json", "-o", "-"}, 0);
        row({"trace", "scene.json", "-o", "-"}, 0);
        row({"lab", "scene.json", "--family", "own-scene", "--contender", "column-scan:float32",
             "-o", "-"},
            0);
        row({"compare", "scene.json", "--methods", "column-scan,truth", "-o", "-"}, 2);
        row({"diff", "picture.png", "picture.png", "-o", "-"}, 2);
        row({"counterexample", "column-scan", "truth:open", "-o", "-"}, 2);
        row({"probes", "--candidates", "1", "-o", "-"}, 2);
        row({"grade", "subs", "--assignment", "assignment.json", "-o", "-"}, 2);
        row({"grade", "-", "--assignment", "assignment.json", "-o", "results"}, 2);
        row({"grade", "--merge", "-", "-o", "results"}, 2);
    }
    void aDashIsStandardOutputOrRefused()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, exitCode);
        for (const bool hasFolder : {false, true}) {
            if (hasFolder)
                QVERIFY(QDir().mkpath(path("-")));

            const ProgramRun run = runHere(arguments);

            QVERIFY2(run.exitCode == exitCode, run.messages.constData());
            QCOMPARE(!run.output.isEmpty(), exitCode == 0);
            QCOMPARE(QFile::exists(path("-")), hasFolder);
            QVERIFY(!hasFolder || QDir(path("-")).isEmpty());
        }
    }

    void aFullDiskIsSaid_data()
    {
        QTest::addColumn<QStringList>("words");
        for (const WritingCommand &command : writingCommands()) {
            if (!command.words.join(u' ').contains(QStringLiteral("program:")))
                QTest::newRow(qPrintable(command.words.join(u' ') + u' ' + command.suffix))
                    << command.words;
        }
        QTest::newRow("counterexample")
            << QStringList{"counterexample", "column-scan", "truth:open"};
    }
    void aFullDiskIsSaid()
    {
        QFETCH(QStringList, words);

        const ProgramRun run = runHere(words + QStringList{"-o", "/dev/full"});

        QCOMPARE(run.exitCode, 2);
        QVERIFY2(run.messages.contains("/dev/full: cannot be written: No space left on device"),
                 run.messages.constData());
    }

    void whatIsNoLongerThereIsNoInput()
    {
        const InputRecord record;
        const QString input = path("input"), output = path("output");
        QVERIFY(!writeFile(input, "a"));
        QVERIFY(readFile(input).isOk());
        QVERIFY(isInput(input));
        QVERIFY(writeFile(input, "b"));
        QVERIFY(!writeFile(input, "b", WrittenAs::Document));
        QVERIFY(isInput(input)); // another file by the same name

        // Its number is free for the next file.
        QVERIFY(QFile::remove(input));
        for (int i = 0; i < 4; ++i)
            QVERIFY(!writeFile(output, "c"));
    }

    void aCommandKnowsItsOwnInputsAlone()
    {
        const QString input = path("input");
        QVERIFY(!writeFile(input, "a"));
        {
            const InputRecord record;
            const InputRecord another;
            QVERIFY(readFile(input).isOk());
        }
        QVERIFY(!isInput(input));
        QVERIFY(!writeFile(input, "b"));
    }
};

PIXELPLUMB_TEST(TestInputsAndOutputs)

} // namespace tst_inputsandoutputs

#include "tst_inputsandoutputs.moc"
