// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/fileaccess.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/sanitized.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <vector>

namespace tst_transcripts {

using namespace pixelplumb;

namespace {

/// A command of a transcript: what stands above it, and its lines for the shell.
struct Command {
    QStringList comment;
    QStringList lines;
};

const QStringList slowSanitized
    = {"check", "compare", "counterexample", "diagnose", "diff", "effect-faults", "lab"};

const QString begin = u"  $ "_s;
const QString continued = u"  > "_s;

/// The commands, without what they printed.
std::vector<Command> commandsOf(const QString &transcript)
{
    std::vector<Command> commands;
    QStringList comment;
    for (const QString &line : transcript.split(u'\n')) {
        if (line.startsWith(begin)) {
            commands.push_back({comment, {line.sliced(begin.size())}});
            comment.clear();
        } else if (line.startsWith(continued) && !commands.empty() && comment.isEmpty()) {
            commands.back().lines += line.sliced(continued.size());
        } else if (!line.startsWith(u"  "_s)) {
            comment += line;
        }
    }
    // The empty line at the file's end is the last comment.
    commands.push_back({comment, {}});
    return commands;
}

/// What a command printed, indented: standard output, standard error after "! ", and the exit code
/// in brackets where it is not 0.
QStringList shownResult(const ProgramRun &result)
{
    QStringList shown;
    const auto add = [&](const QByteArray &text, const QString &mark) {
        QStringList lines = QString::fromUtf8(text).split(u'\n');
        if (lines.back().isEmpty())
            lines.removeLast();
        else
            lines.back() += u" (no newline)"_s;
        for (const QString &line : lines)
            shown += (u"  "_s + mark + line);
    };
    add(result.output, {});
    add(result.messages, u"! "_s);
    if (result.exitCode != 0)
        shown += u"  [%1]"_s.arg(result.exitCode);
    return shown;
}

/// By the shell, in this folder.
ProgramRun runInShell(const QString &folder, const QString &script)
{
    QProcess shell;
    shell.setWorkingDirectory(folder);
    shell.setStandardInputFile(QProcess::nullDevice());
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(u"PATH"_s,
                       QFileInfo(program()).path() + u':' + environment.value(u"PATH"_s));
    shell.setProcessEnvironment(environment);
    shell.start(u"/bin/sh"_s, {u"-c"_s, script});
    if (!shell.waitForFinished(300'000) || shell.exitStatus() != QProcess::NormalExit)
        return {-1, {}, "did not end by itself\n"};
    return {shell.exitCode(), shell.readAllStandardOutput(), shell.readAllStandardError()};
}

/// The transcript as it is when its commands are run now, from the first to the last in one folder,
/// where scenes, assignments and probes are those of resources/, and data is tests/data.
QString runAgain(const QString &transcript)
{
    const QTemporaryDir folder;
    for (const char *name : {"scenes", "assignments", "probes"})
        QFile::link(resource(u'/' + QString::fromLatin1(name)), folder.filePath(name));
    QFile::link(testData({}), folder.filePath(u"data"_s));
    QStringList lines;
    for (const Command &command : commandsOf(transcript)) {
        lines += command.comment;
        if (command.lines.isEmpty())
            continue;
        lines += begin + command.lines.join(u'\n' + continued);
        lines += shownResult(runInShell(folder.path(), command.lines.join(u'\n')));
    }
    return lines.join(u'\n');
}

} // namespace

/// What the program prints, word for word: the files of tests/data/transcripts are what a person
/// saw who typed these commands, and are run again. PIXELPLUMB_RECORD=1 in the environment writes
/// what they print now into the files, to be read before it is committed.
class TestTranscripts : public QObject {
    Q_OBJECT

private slots:
    void saysWhatItSaid_data()
    {
        QTest::addColumn<QString>("file");
        const QDir folder(testData(u"transcripts"_s));
        for (const QString &name : folder.entryList({u"*.txt"_s}))
            QTest::newRow(qPrintable(name)) << folder.filePath(name);
    }
    void saysWhatItSaid()
    {
        QFETCH(QString, file);
        if (isSanitized && slowSanitized.contains(QFileInfo(file).baseName()))
            QSKIP("It takes minutes with sanitizers; other tests run the same code with them.");
        QFile transcript(file);
        QVERIFY(transcript.open(QIODevice::ReadOnly));
        const QString recorded = QString::fromUtf8(transcript.readAll());
        QVERIFY(commandsOf(recorded).size() > 1);

        const QString now = runAgain(recorded);

        if (qEnvironmentVariableIsSet("PIXELPLUMB_RECORD"))
            QVERIFY(!writeFile(file, now.toUtf8()));
        else if (now != recorded)
            QFAIL(qPrintable(firstDifference(recorded.split(u'\n'), now.split(u'\n'))));
    }

    void whatIsRunAgainIsWhatWasPrinted()
    {
        QCOMPARE(runAgain(u"A sentence.\n"
                          "  $ printf 'a\\nb'; echo c >&2; exit 3\n"
                          "  something else\n"
                          "\n"
                          "  $ cat <<END\n"
                          "  > one\n"
                          "  > END\n"_s),
                 u"A sentence.\n"
                 "  $ printf 'a\\nb'; echo c >&2; exit 3\n"
                 "  a\n"
                 "  b (no newline)\n"
                 "  ! c\n"
                 "  [3]\n"
                 "\n"
                 "  $ cat <<END\n"
                 "  > one\n"
                 "  > END\n"
                 "  one\n"_s);
    }

private:
    /// With the command that printed it.
    static QString firstDifference(const QStringList &recorded, const QStringList &now)
    {
        QString command;
        for (qsizetype i = 0; i < qMax(recorded.size(), now.size()); ++i) {
            const QString was = recorded.value(i, u"(the end)"_s);
            const QString is = now.value(i, u"(the end)"_s);
            if (was != is)
                return u"line %1, of %2\nrecorded: %3\nnow:      %4"_s.arg(
                    QString::number(i + 1), command.trimmed(), was, is);
            if (was.startsWith(begin))
                command = was;
        }
        return {};
    }
};

PIXELPLUMB_TEST(TestTranscripts)

} // namespace tst_transcripts

#include "tst_transcripts.moc"
