// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/programrun.h"
#include "tests/support/programs/processes.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/programs/submissions.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>
#include <unistd.h>
#include <utime.h>

#include <csignal>
#include <ctime>

namespace tst_withoutsandbox {

using namespace pixelplumb;

namespace {

/// An environment with this folder for temporary files; without bwrap if `tools` is None.
enum class Tools { All, None };
QProcessEnvironment environment(const QString &temporary, Tools tools)
{
    QProcessEnvironment result = QProcessEnvironment::systemEnvironment();
    result.insert(u"TMPDIR"_s, temporary);
    if (tools == Tools::None)
        result.insert(u"PATH"_s, u"/nowhere"_s);
    return result;
}

/// Runs our program where there is no sandbox.
ProgramRun runWithout(const QStringList &arguments)
{
    QProcess process;
    process.setProcessEnvironment(environment(QDir::tempPath(), Tools::None));
    process.start(program(), arguments);
    process.waitForFinished(300'000);
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

constexpr const char *said = "no sandbox (bubblewrap (bwrap) is not installed)";

} // namespace

/// Foreign programs without a sandbox: every run says so, and what holds nevertheless; and ending
/// us leaves nothing behind, with or without a sandbox.
class TestWithoutSandbox : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        chmod(QFile::encodeName(m_folder->path()).constData(), 0755);
    }

    /// A bwrap found by a relative path could be the program's own.
    void noSandboxIsTakenFromARelativePlace()
    {
        const QString taken = m_folder->filePath(u"taken"_s);
        QFile bwrap(m_folder->filePath(u"bwrap"_s));
        QVERIFY(bwrap.open(QIODevice::WriteOnly));
        bwrap.write("#!/bin/sh\necho x > '" + QFile::encodeName(taken) + "'\n");
        bwrap.close();
        bwrap.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        QProcess process;
        QProcessEnvironment relative = environment(QDir::tempPath(), Tools::None);
        relative.insert(u"PATH"_s, u".:/nowhere"_s);
        process.setProcessEnvironment(relative);
        process.setWorkingDirectory(m_folder->path());
        process.start(program(), {"try", "--scene", defaultScene(), "/bin/true"});
        QVERIFY(process.waitForFinished(300'000));
        QVERIFY(!QFile::exists(taken));
        const QByteArray told = process.readAllStandardOutput() + process.readAllStandardError();
        QVERIFY2(told.contains(said), told.constData());
    }

    void everyCommandThatRunsAProgramSaysSo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const QString scene = defaultScene();
        const QString nothing = u"program:/bin/true"_s;
        QTest::newRow("try") << QStringList{"try", "--scene", scene, "/bin/true"};
        QTest::newRow("counterexample") << QStringList{"counterexample", "column-scan", nothing};
        QTest::newRow("invariants") << QStringList{"invariants", nothing};
    }
    void everyCommandThatRunsAProgramSaysSo()
    {
        QFETCH(QStringList, arguments);
        const ProgramRun without = runWithout(arguments);
        QVERIFY2((without.output + without.messages).contains(said), without.output.constData());
        if (sandboxLack().isEmpty()) {
            const ProgramRun with = run(arguments);
            QVERIFY2(!(with.output + with.messages).contains("no sandbox"),
                     with.output.constData());
        }
    }

    void whatDrewIsSaidToHaveHadNoneInTextAndInJson()
    {
        const QString drawn = path("drawn.ppm");
        QCOMPARE(run({"render", defaultScene(), "-o", drawn}).exitCode, 0);
        const QStringList tried{"try", "--scene", defaultScene(), "/bin/cat", drawn};
        QVERIFY(runWithout(tried).output.contains(said));
        const QJsonObject report
            = QJsonDocument::fromJson(runWithout(tried + QStringList{"--json"}).output).object();
        QVERIFY(report[u"right"_s].toBool());
        QVERIFY(report[u"noSandbox"_s].toString().startsWith(QLatin1String(said)));

        QVERIFY(writeTo(path("column.txt"), "#\n"));
        const QStringList asked{"counterexample", "column-scan", "--json",
                                "program:/bin/cat " + path("column.txt")};
        const ProgramRun searched = runWithout(asked);
        QVERIFY2((searched.output + searched.messages).contains(said), searched.messages);
    }

    void everyFileOfResultsSaysSo()
    {
        QVERIFY(writeTo(path("subs/ada/draw"), "#!/bin/sh\nexit 3\n"));
        chmod(QFile::encodeName(path("subs/ada")).constData(), 0755);
        chmod(QFile::encodeName(path("subs/ada/draw")).constData(), 0755);
        QVERIFY(writeTo(
            path("assignment.json"),
            "{ \"pixelplumbAssignment\": 1, \"name\": \"one\", \"program\": { \"seconds\": 2 },"
            " \"scenes\": [ { \"name\": \"small\", \"scene\": \""
                + QFile::encodeName(defaultScene()) + "\" } ] }"));
        const QStringList graded{"grade", path("subs"), "--assignment", path("assignment.json"),
                                 "-o"};

        const ProgramRun text = runWithout(graded + QStringList{path("text")});
        const ProgramRun json = runWithout(graded + QStringList{path("json"), "--json"});

        QCOMPARE(text.exitCode, 0);
        QVERIFY2(text.output.contains("1 submission ran in no sandbox"), text.output.constData());
        QVERIFY(QJsonDocument::fromJson(json.output)[u"noSandbox"_s].toString().contains(
            QLatin1String(said)));
        const auto files = filesIn(path("text"));
        for (const char *name : {"results.json", "index.html", "junit.xml"})
            QVERIFY2(files[QLatin1String(name)].contains(said), name);
        QVERIFY(files[u"grades.csv"_s].contains(",sandbox,reason"));
        QVERIFY(files[u"grades.csv"_s].contains(",no,")); // and no reason
        int ofSubmission = 0;
        for (auto file = files.begin(); file != files.end(); ++file) {
            const bool isOfAda
                = file.key().startsWith(u"gradescope/"_s) || file.key().startsWith(u"grades/"_s);
            ofSubmission += isOfAda && file->contains("bwrap) is not installed") ? 1 : 0;
        }
        QCOMPARE(ofSubmission, 2);

        // With a sandbox nothing is said; a fresh folder leaves out earlier results.
        if (!sandboxLack().isEmpty())
            return;
        QCOMPARE(run(graded + QStringList{path("with")}).exitCode, 0);
        for (const QByteArray &content : filesIn(path("with")))
            QVERIFY(!content.contains("no sandbox"));
        QVERIFY(filesIn(path("with"))[u"grades.csv"_s].contains(",yes"));
    }

    void aSignalToAllIsRefused()
    {
        const auto student = studentProgramOf(
            {u"python3"_s, u"-c"_s,
             QStringLiteral("import os\n" // signal 0 is sent to nobody: it only tests permission
                            "try: os.kill(-1, 0)\n"
                            "except PermissionError: print('refused')\n")});
        QCOMPARE(runProgram(*student, {}, {}, {}, Confinement::LimitsAlone).output,
                 QByteArray("refused\n"));
    }

    void aProgramThatKillsItsSupervisorIsReportedAndEnded()
    {
        const QByteArray seconds = unusualSeconds();
        const QString script = u"(setsid sleep %1 &); kill -KILL $PPID; sleep %1; sleep 0.2"_s.arg(
            QString::fromLatin1(seconds));
        QProcess process;
        process.setProcessEnvironment(environment(u"/tmp"_s, Tools::None));
        const QStringList tried{"try", "--time",  "2",  "--scene", defaultScene(),
                                "--",  "/bin/sh", "-c", script};
        if (geteuid() == 0)
            process.start(u"/usr/bin/setpriv"_s,
                          QStringList{"--reuid=54321", "--regid=54321", "--clear-groups", program()}
                              + tried);
        else
            process.start(program(), tried);
        QVERIFY(process.waitForFinished(120'000));
        const QByteArray output = process.readAllStandardOutput();
        if (output.isEmpty())
            QSKIP("Another user cannot run our program where it lies.");

        QVERIFY2(output.contains("what watched over it was killed"), output.constData());
        QCOMPARE(processesWith(seconds), 0);
    }

    void whoeverEndsUsNothingIsLeft_data()
    {
        QTest::addColumn<int>("signal");
        QTest::addColumn<bool>("isGrading");
        QTest::addColumn<bool>("hasTools");
        for (const auto &[name, signal] :
             {std::pair("INT", SIGINT), std::pair("TERM", SIGTERM), std::pair("KILL", SIGKILL)}) {
            for (const bool isGrading : {false, true}) {
                for (const bool hasTools : {true, false})
                    QTest::addRow("%s of %s %s", name, isGrading ? "grade" : "try",
                                  hasTools ? "as it is" : "without a sandbox")
                        << signal << isGrading << hasTools;
            }
        }
    }
    void whoeverEndsUsNothingIsLeft()
    {
        QFETCH(int, signal);
        QFETCH(bool, isGrading);
        QFETCH(bool, hasTools);
        const QByteArray seconds = unusualSeconds();
        QVERIFY(
            writeTo(path("subs/ada/draw"), "#!/bin/sh\ntouch left; exec sleep " + seconds + "\n"));
        chmod(QFile::encodeName(path("subs/ada")).constData(), 0755);
        chmod(QFile::encodeName(path("subs/ada/draw")).constData(), 0755);
        QVERIFY(writeTo(
            path("assignment.json"),
            "{ \"pixelplumbAssignment\": 1, \"name\": \"one\", \"program\": { \"seconds\": 2 },"
            " \"scenes\": [ { \"name\": \"small\", \"scene\": \""
                + QFile::encodeName(defaultScene()) + "\" } ] }"));
        QVERIFY(QDir(m_folder->path()).mkdir(u"temporary"_s));
        chmod(QFile::encodeName(path("temporary")).constData(), 01777);
        QProcess process;
        process.setProcessEnvironment(
            environment(path("temporary"), hasTools ? Tools::All : Tools::None));
        process.start(program(),
                      isGrading
                          ? QStringList{"grade", path("subs"), "--assignment",
                                        path("assignment.json"), "-o", path("results")}
                          : QStringList{"try", "--scene", defaultScene(), path("subs/ada/draw")});
        QTRY_VERIFY_WITH_TIMEOUT(processesWith(seconds) > 0, 60'000);

        kill(pid_t(process.processId()), signal);

        QVERIFY(process.waitForFinished(60'000));
        QTRY_COMPARE_WITH_TIMEOUT(processesWith(seconds), 0, 30'000);
        const QDir left(path("temporary"));
        QTRY_COMPARE_WITH_TIMEOUT(left.entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
                                  QStringList(), 30'000);
    }

    /// The folder is made by who removes it: nobody can be ended in between.
    void aSignalAsTheFolderIsMadeLeavesNothing()
    {
        const QDir temporary(m_folder->path());
        const auto inIt
            = [&temporary] { return temporary.entryList(QDir::AllEntries | QDir::NoDotAndDotDot); };
        chmod(QFile::encodeName(m_folder->path()).constData(), 01777);
        for (int run = 0; run < 12; ++run) {
            QProcess process;
            process.setProcessEnvironment(environment(m_folder->path(), Tools::None));
            process.start(program(), {"try", "--scene", defaultScene(), "/bin/sleep", "1"});
            QVERIFY(process.waitForStarted());
            while (process.state() == QProcess::Running && inIt().isEmpty())
                process.waitForFinished(0);
            kill(pid_t(process.processId()), SIGTERM);
            QVERIFY(process.waitForFinished(60'000));
        }
        QTRY_COMPARE_WITH_TIMEOUT(inIt(), QStringList(), 30'000);
    }

    /// Removing a folder may take long. Nobody waits for it, and nobody is said to have been
    /// killed.
    void aFolderThatTakesLongToRemoveIsRemovedByItself()
    {
        const QString script = u"import os\n"
                               "for i in range(NAME):\n"
                               "    os.mkdir('d'); os.chdir('d')\n"_s.replace(u"NAME"_s, u"3000"_s);
        const ProgramRun tried
            = runWithout({"try", "--scene", defaultScene(), "--", "python3", "-c", script});

        QVERIFY2(!tried.output.contains("was killed"), tried.output.constData());
        QVERIFY2(!tried.output.contains("could not be ended"), tried.output.constData());
    }

    void whatWasLeftIsRemovedByTheNext()
    {
        const QString left = path("pixelplumb-program-AAAAAA");
        const QString young = path("pixelplumb-program-BBBBBB");
        QVERIFY(writeTo(left + "/deep/file", "x") && writeTo(young + "/file", "x"));
        QVERIFY(QFile::link(u"/etc"_s, left + "/deep/link"));
        const utimbuf hourAgo = {time(nullptr) - 3600, time(nullptr) - 3600};
        utime(QFile::encodeName(left).constData(), &hourAgo);
        QProcess process;
        process.setProcessEnvironment(environment(m_folder->path(), Tools::None));

        process.start(program(), {"try", "--scene", defaultScene(), "/bin/true"});

        QVERIFY(process.waitForFinished(60'000));
        QVERIFY(!QFileInfo::exists(left));
        QVERIFY(QFileInfo::exists(young)); // some process may just have created it
        QVERIFY(QFileInfo::exists(u"/etc/passwd"_s));
    }

private:
    QString path(const QString &name) const { return m_folder->filePath(name); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

PIXELPLUMB_TEST(TestWithoutSandbox)

} // namespace tst_withoutsandbox

#include "tst_withoutsandbox.moc"
