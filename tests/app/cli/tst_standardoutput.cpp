// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileaccess.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <vector>

namespace tst_standardoutput {

using namespace pixelplumb;

namespace {

/// Each command that reads a file, in each way in which it writes: %1 is what it reads.
const std::vector<QStringList> &commandLines()
{
    static const std::vector<QStringList> lines
        = {{"trace", "%1"},
           {"trace", "%1", "-o", "-"},
           {"trace", "%1", "-o", "/dev/stdout"},
           {"trace", "%1", "--level", "pixel", "--format", "json"},
           {"trace", "%1", "--level", "setup", "--format", "text"},
           {"pixel", "%1", "27", "19"},
           {"pixel", "%1", "27", "19", "--json"},
           {"compare", "%1", "--methods", "column-scan:float32,truth"},
           {"compare", "%1", "--methods", "column-scan,truth", "--json"},
           {"render", "%1", "--ascii"},
           {"render", "%1", "-o", "-"},
           {"lab", "%1", "--family", "own-scene", "--contender", "column-scan:float32"},
           {"plan", "%1"},
           {"motion", "%1"},
           {"probes", "%1", "--candidates", "1"},
           {"check", "%1"},
           {"check", "%1", "--json"}};
    return lines;
}

/// Which of the program's own outputs leads to the file that it reads.
enum class Stream { Output, Messages, Both };

const std::vector<std::pair<const char *, Stream>> &streams()
{
    static const std::vector<std::pair<const char *, Stream>> all
        = {{">>", Stream::Output}, {"2>>", Stream::Messages}, {">> 2>&1", Stream::Both}};
    return all;
}

} // namespace

/// What a shell may do with standard output.
class TestStandardOutput : public QObject {
    Q_OBJECT

private slots:
    void everyCommandThatReadsAFileIsTried()
    {
        QStringList tried;
        for (const QStringList &line : commandLines())
            tried.append(line.front());
        const QString help = QString::fromUtf8(run({"--help"}).output);
        const QString list = help.section(QStringLiteral("Commands:\n"), 1).section("\n\n", 0, 0);
        int reading = 0;
        for (const QString &row : list.split(u'\n')) {
            const QString command = row.simplified().section(u' ', 0, 0);
            const QString usage
                = QString::fromUtf8(run({command, "--help"}).output).section(u'\n', 0, 0);
            if (!usage.contains(QStringLiteral("SCENE"))
                && !usage.contains(QStringLiteral("CASES")))
                continue;
            QVERIFY2(tried.contains(command), qPrintable(command));
            ++reading;
        }
        QVERIFY(reading >= 5);
    }

    void aFileThatIsReadIsNotWrittenTo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("input");
        QTest::addColumn<Stream>("stream");
        for (const QStringList &line : commandLines()) {
            for (const char *input : {"input.json", "symlink", "hardlink", "-"}) {
                for (const auto &[name, stream] : streams())
                    QTest::addRow("%s %s %s", qPrintable(line.join(u' ')), name, input)
                        << line << QString::fromLatin1(input) << stream;
            }
        }
    }
    void aFileThatIsReadIsNotWrittenTo()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, input);
        QFETCH(Stream, stream);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("input.json"));
        const QByteArray before = contentFor(arguments);
        QVERIFY(!writeFile(file, before));
        QVERIFY(QFile::link(file, folder.filePath(QStringLiteral("symlink"))));
        std::filesystem::create_hard_link(
            file.toStdString(), folder.filePath(QStringLiteral("hardlink")).toStdString());
        arguments.replaceInStrings(QStringLiteral("%1"),
                                   input == QStringLiteral("-") ? input : folder.filePath(input));

        QProcess process;
        process.setStandardInputFile(file);
        if (stream != Stream::Messages)
            process.setStandardOutputFile(file, QIODevice::Append);
        if (stream != Stream::Output)
            process.setStandardErrorFile(file, QIODevice::Append);
        process.start(program(), arguments);
        QVERIFY(process.waitForFinished());

        QCOMPARE(*readFile(file), before);
        QCOMPARE(process.exitCode(), 2);
        if (stream == Stream::Output)
            QVERIFY(process.readAllStandardError().contains(
                "is the input, which it would replace; expected another file"));
    }

    void aFileOpenedForReadingAndWritingIsNotWrittenToEither()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("input.json"));
        QVERIFY(QFile::copy(defaultScene(), file));
        const QByteArray before = *readFile(file);

        QProcess shell;
        shell.start("/bin/sh", {"-c", "\"$0\" trace \"$1\" 1<>\"$1\"", program(), file});
        QVERIFY(shell.waitForFinished());

        QCOMPARE(*readFile(file), before);
        QCOMPARE(shell.exitCode(), 2);
    }

    void mayBeAFileBesideTheInput()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("trace.csv"));

        QProcess process;
        process.setStandardInputFile(defaultScene());
        process.setStandardOutputFile(file);
        process.start(program(), {"trace", "-"});
        QVERIFY(process.waitForFinished());

        QCOMPARE(process.exitCode(), 0);
        QCOMPARE(*readFile(file), run({"trace", defaultScene()}).output);
    }

    void isSaidOnceToBeFull_data()
    {
        QTest::addColumn<QStringList>("arguments");
        for (const QStringList &line : commandLines())
            QTest::newRow(qPrintable(line.join(u' '))) << line;
        QTest::newRow("methods") << QStringList{"methods"};
        QTest::newRow("help") << QStringList{"--help"};
    }
    void isSaidOnceToBeFull()
    {
        QFETCH(QStringList, arguments);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("input.json"));
        QVERIFY(!writeFile(file, contentFor(arguments)));
        arguments.replaceInStrings(QStringLiteral("%1"), file);

        QProcess process;
        process.setStandardOutputFile(QStringLiteral("/dev/full"));
        process.start(program(), arguments);
        QVERIFY(process.waitForFinished());

        QCOMPARE(process.exitCode(), 2);
        const QByteArray messages = process.readAllStandardError();
        QVERIFY2(messages.contains("cannot be written: No space left on device"),
                 messages.constData());
        QCOMPARE(messages.count('\n'), qsizetype(1));
    }

private:
    /// A scene, or a file of cases.
    static QByteArray contentFor(const QStringList &arguments)
    {
        if (arguments.front() == QStringLiteral("motion"))
            return *readFile(sceneFile(QStringLiteral("moving-sliver.json")));
        if (arguments.front() != QStringLiteral("check"))
            return *readFile(defaultScene());
        return "{\"version\": 1, \"cases\": [{\"id\": \"small\", \"kind\": \"triangle\", "
               "\"scale\": 1, "
               "\"vertices\": [[0, 0], [4, 0], [0, 4]], \"canvas\": [6, 6], \"origin\": [0, 0], "
               "\"expected\": {\"closed\": {\"count\": 15}}}]}";
    }
};

PIXELPLUMB_TEST(TestStandardOutput)

} // namespace tst_standardoutput

#include "tst_standardoutput.moc"
