// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/showntext.h"
#include "core/grade/try/processtime.h"
#include "core/grade/try/programclock.h"
#include "core/grade/try/scenelines.h"
#include "core/grade/try/studentoutput.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/programs/processes.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QBuffer>
#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <unistd.h>

#include <csignal>
#include <thread>

namespace tst_programrun {

using namespace pixelplumb;
using namespace std::chrono_literals;

namespace {

StudentRun runShell(const QString &script, const ProgramLimits &limits = {},
                    const QByteArray &input = {})
{
    return runProgram(*studentProgramOf({u"sh"_s, u"-c"_s, script}), input, limits);
}

StudentRun runPython(const QString &script, const ProgramLimits &limits = {})
{
    return runProgram(*studentProgramOf({u"python3"_s, u"-c"_s, script}), {}, limits);
}

ProgramLimits within(std::chrono::milliseconds time)
{
    ProgramLimits limits;
    limits.time = time;
    return limits;
}

/// The first half of a PNG file.
QByteArray halfPicture()
{
    QImage image(4, 3, QImage::Format_RGB32);
    image.fill(Qt::red);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes.left(bytes.size() / 2);
}

Scene smallScene()
{
    Scene scene;
    scene.frame.width = 4;
    scene.frame.height = 3;
    return scene;
}

} // namespace

/// Foreign programs as child processes: what they may do and what they cannot.
class TestProgramRun : public QObject {
    Q_OBJECT

private slots:
    void aProgramGetsItsInputAndIsHeard()
    {
        const QByteArray input(1 << 20, 'x');

        const StudentRun run = runShell(u"cat; echo said >&2"_s, {}, input);

        QCOMPARE(run.end, ProgramEnd::Finished);
        QCOMPARE(run.output, input);
        QCOMPARE(run.messages, QByteArray("said\n"));
    }

    void howItEndedIsTold_data()
    {
        QTest::addColumn<QString>("script");
        QTest::addColumn<ProgramEnd>("end");
        QTest::addColumn<int>("code");
        const auto row = [](const char *name, const char *script, ProgramEnd end, int code) {
            QTest::newRow(name) << QString::fromLatin1(script) << end << code;
        };
        row("finished", "exit 0", ProgramEnd::Finished, 0);
        row("failed", "exit 3", ProgramEnd::Failed, 3);
        row("crashed", "kill -SEGV $$", ProgramEnd::Crashed, SIGSEGV);
        row("does not read its input", "exec 0<&-; exit 0", ProgramEnd::Finished, 0);
        row("closes its output and goes on", "exec 1>&- 2>&-; sleep 0.2; exit 4",
            ProgramEnd::Failed, 4);
        row("hangs", "sleep 1000", ProgramEnd::TimedOut, 0);
        row("hangs with closed output", "exec 1>&- 2>&-; sleep 1000", ProgramEnd::TimedOut, 0);
        row("does not let itself be ended", "trap '' TERM INT HUP; while :; do :; done",
            ProgramEnd::TimedOut, 0);
        row("stops itself", "kill -STOP $$", ProgramEnd::TimedOut, 0);
    }
    void howItEndedIsTold()
    {
        QFETCH(QString, script);
        QFETCH(ProgramEnd, end);
        QFETCH(int, code);
        // Programs that hang need a shorter wait than those that a busy machine delays.
        const auto time = end == ProgramEnd::TimedOut ? 300ms : 60'000ms;

        const StudentRun run = runShell(script, within(time), QByteArray(1 << 20, 'x'));

        QCOMPARE(nameOf(run.end), nameOf(end));
        QCOMPARE(run.code, code);
        QVERIFY(!run.told.isEmpty());
    }

    void aProgramThatComputesTooLongIsReported()
    {
        ProgramLimits limits = within(1000ms);
        QCOMPARE(limits.wallTime(), 4000ms);

        QCOMPARE(runShell(u"ulimit -t"_s, limits).output, QByteArray("1\n"));
        const StudentRun computing = runPython(u"while True: pass"_s, limits);
        QCOMPARE(nameOf(computing.end), u"timed out"_s);
        // However busy the machine is.
        QCOMPARE(
            computing.told,
            u"it was ended after 1 s of computing: a loop does not end, or takes far too long"_s);
        QVERIFY(!computing.isByClock);
        // One program ignores the kernel's signal; another only looks as if it had been ended by
        // it.
        const StudentRun deaf = runPython(u"import signal\nsignal.signal(signal.SIGXCPU, "
                                          "signal.SIG_IGN)\nwhile True: pass"_s,
                                          limits);
        QCOMPARE(
            deaf.told,
            u"it was ended after 1 s of computing: a loop does not end, or takes far too long"_s);
        // The launcher reports a signal as such an exit code, as shells do.
        QVERIFY(runShell(u"exit 152"_s, limits).told.startsWith("it crashed"));
        QVERIFY(runShell(u"kill -XCPU $$"_s, limits).told.startsWith("it crashed"));
        QCOMPARE(runShell(u"exit 255"_s, limits).told, u"it ended with exit code 255"_s);
        // A program that waits for others, as on a busy machine, has not computed.
        const StudentRun waiting = runShell(u"sleep 1.5; echo done"_s, limits);
        QCOMPARE(nameOf(waiting.end), u"finished"_s);
        const StudentRun hanging = runShell(u"sleep 1000"_s, within(100ms));
        QCOMPARE(hanging.told,
                 u"it was ended by the clock: for 0.4 s it was not seen to compute"_s);
        QVERIFY(hanging.isByClock);
    }

    void processesThatTogetherComputeTooLongAreReported()
    {
        ProgramLimits limits = within(1000ms);
        limits.clockTimes = 1;
        limits.timesInAll = 1;
        const StudentRun forking = runPython(u"import os\n"
                                             "for i in range(3):\n"
                                             "    if os.fork() == 0:\n"
                                             "        while True: pass\n"
                                             "while True: os.wait()"_s,
                                             limits);
        QCOMPARE(forking.told, u"it was ended after 1 s of computing in all its processes"_s);
        QVERIFY(forking.isInAll);
        QVERIFY(!forking.isByClock);
    }

    void whoComputesTooLongIsToldSoByAnyCount()
    {
        // The kernel's count in ticks may be ahead of the reported one: here by a fraction of a
        // second.
        const StudentRun ended = runPython(u"import os, signal, time\n"
                                           "while time.process_time() < 1.3: pass\n"
                                           "os.kill(os.getpid(), signal.SIGXCPU)"_s,
                                           within(2000ms));
        QCOMPARE(
            ended.told,
            u"it was ended after 2 s of computing: a loop does not end, or takes far too long"_s);
    }

    void theClockEndsProgramsThatOnlyWait()
    {
        using Clock = ProgramClock::Clock;
        const ProgramLimits limits = within(10'000ms);
        const Clock::time_point start;
        const auto lookedAt = [&](std::chrono::milliseconds eachWindow, int windows) {
            ProgramClock clock(limits, start);
            for (int i = 1; i <= windows; ++i) {
                if (const auto end = clock.look(i * eachWindow, clock.nextLook()))
                    return u"%1: %2"_s.arg(i).arg(end->told);
            }
            return u"goes on"_s;
        };
        QCOMPARE(ProgramClock(limits, start).nextLook(), start + 40s);
        // 1/64 of 10 s is 156 ms: a machine that also serves 250 others gives a program more.
        QCOMPARE(lookedAt(157ms, 15), u"goes on"_s);
        QCOMPARE(lookedAt(156ms, 15),
                 u"1: it was ended by the clock: for 40 s it was not seen to compute"_s);
        // The kernel does not end this, because no single process computes too long.
        QCOMPARE(lookedAt(40'000ms, 15),
                 u"4: it was ended after 160 s of computing in all its processes"_s);
        ProgramLimits less = limits;
        less.timesInAll = 1;
        QCOMPARE(ProgramClock(less, start).look(10'000ms, start + 40s)->told,
                 u"it was ended after 10 s of computing in all its processes"_s);
        QCOMPARE(lookedAt(157ms, 99), u"16: it was ended after 640 s by the clock"_s);

        ProgramClock clock(limits, start);
        QVERIFY(!clock.look(5'000ms, start + 40s));
        QCOMPARE(clock.nextLook(), start + 80s);
        const auto end = clock.look(5'000ms, start + 80s); // first it computed, then it waited
        QVERIFY(end && end->isByClock);
    }

    void whatDescendantsComputeIsCounted()
    {
        if (!QFile::exists(u"/proc/thread-self/children"_s))
            QSKIP("the kernel does not list children");
        QProcess shell; // its child computes, and so does a grandchild, which then ends
        shell.start(u"sh"_s,
                    {u"-c"_s,
                     u"(python3 -c 'import time\n"
                     "while time.process_time() < 0.2: pass'; echo; read x); echo"_s});
        QVERIFY(shell.waitForReadyRead());
        const auto computed = computedBy(pid_t(shell.processId()));
        QVERIFY2(computed >= 150ms && computed < 1000ms,
                 qPrintable(QString::number(computed.count())));
        shell.closeWriteChannel();
        QVERIFY(shell.waitForFinished());
    }

    void whatIsNoProgramIsNotStarted()
    {
        QTemporaryDir folder;
        const QString text = folder.filePath(u"text"_s);
        QVERIFY(!writeFile(text, "no program\n"));
        QVERIFY(!studentProgramOf({text}).isOk());
        QVERIFY(!studentProgramOf({u"/nowhere/at-all"_s}).isOk());
        QVERIFY(!studentProgramOf({}).isOk());

        QVERIFY(QFile::setPermissions(text, QFile::ReadOwner | QFile::ExeOwner | QFile::ExeOther));
        const StudentRun run = runProgram(*studentProgramOf({text}), {});

        QCOMPARE(nameOf(run.end), nameOf(ProgramEnd::NotStarted));
        QVERIFY2(run.told.contains(u"Exec format error"_s), qPrintable(run.told));
    }

    void namesMayBeOdd()
    {
        QTemporaryDir folder;
        const QString name = folder.filePath(u"a\nb \x1b[31m'\"$(c)"_s);
        QVERIFY(!writeFile(name, "#!/bin/sh\nprintf %s \"$1\"\n"));
        QVERIFY(QFile::setPermissions(
            name, QFile::ReadOwner | QFile::ExeOwner | QFile::ReadOther | QFile::ExeOther));

        const StudentRun run = runProgram(*studentProgramOf({name, u"; echo \n../x"_s}), {});

        QCOMPARE(run.output, QByteArray("; echo \n../x"));
    }

    void nothingOutlivesIt_data()
    {
        QTest::addColumn<QString>("script");
        QTest::newRow("in the background") << u"sleep %1 & exit 0"_s;
        QTest::newRow("in a session of its own, with its output open")
            << u"setsid sleep %1 & sleep 0.1; exit 0"_s;
        QTest::newRow("an orphan's orphan")
            << u"(setsid sh -c '(sleep %1 &) ; sleep %1' &) ; sleep 0.1; exit 0"_s;
        QTest::newRow("of one that hangs") << u"(setsid sleep %1 &); sleep %1"_s;
    }
    void nothingOutlivesIt()
    {
        QFETCH(QString, script);
        const QByteArray seconds = unusualSeconds();

        runShell(script.arg(QString::fromLatin1(seconds)), within(1000ms));

        QCOMPARE(processesWith(seconds), 0);
    }

    void aForkBombIsBounded()
    {
        const StudentRun run = runPython(u"import os, time\n"
                                         "made = 0\n"
                                         "try:\n"
                                         "    while made < 2000:\n"
                                         "        if os.fork() == 0:\n"
                                         "            time.sleep(1000)\n"
                                         "        made += 1\n"
                                         "except OSError:\n"
                                         "    print(made, os.getuid())\n"_s,
                                         within(60'000ms));

        QCOMPARE(run.end, ProgramEnd::Finished);
        const QList<QByteArray> words = run.output.trimmed().split(' ');
        QVERIFY2(words[0].toInt() > 0, run.output.constData());
        // Otherwise other users' processes are counted, too.
        const bool isCountedAlone = run.isSandboxed() && words.last() != "0";
        QVERIFY2(!isCountedAlone || words[0].toInt() < 64, run.output.constData());
    }

    void aForkBombThatGoesOnIsEnded()
    {
        const QByteArray seconds = unusualSeconds();
        const StudentRun run = runShell(
            u"b() { sleep %1 & b | b & }; b; sleep %1"_s.arg(QString::fromLatin1(seconds)),
            within(500ms));

        QVERIFY(run.end != ProgramEnd::Finished);
        QCOMPARE(processesWith(seconds), 0);
    }

    void floodsAreCut_data()
    {
        QTest::addColumn<QString>("script");
        QTest::newRow("output") << u"yes"_s;
        QTest::newRow("messages") << u"yes >&2"_s;
        QTest::newRow("both at once") << u"yes >&2 & yes"_s;
        QTest::newRow("four gigabytes") << u"head -c 4294967296 /dev/zero"_s;
    }
    void floodsAreCut()
    {
        QFETCH(QString, script);
        ProgramLimits limits = within(60'000ms);
        limits.output = 1 << 20;

        const StudentRun run = runShell(script, limits);

        QCOMPARE(nameOf(run.end), nameOf(ProgramEnd::Flooded));
        QVERIFY(run.output.size() <= limits.output);
        QVERIFY(run.messages.size() <= 1 << 16);
    }

    void memoryIsBounded()
    {
        ProgramLimits limits = within(60'000ms);
        limits.memory = 256 << 20;

        const StudentRun run = runPython(u"x = bytearray(1 << 30)\nprint(len(x))"_s, limits);

        QCOMPARE(nameOf(run.end), nameOf(ProgramEnd::Failed));
        QVERIFY2(run.messages.contains("MemoryError"), run.messages.constData());
    }

    void theLeastMemoryStartsAProgram()
    {
        ProgramLimits limits = within(60'000ms);
        limits.memory = std::int64_t(leastMegabytes) << 20;
        QCOMPARE(runShell(u"echo here"_s, limits).output, QByteArray("here\n"));
        // The launcher needs more than that: the program itself did not fail.
        limits.memory = 1 << 20;
        const StudentRun none = runShell(u"echo here"_s, limits);
        if (!none.isSandboxed())
            QSKIP("Without a sandbox there may be nothing between the limit and the program.");
        QCOMPARE(nameOf(none.end), nameOf(ProgramEnd::NotStarted));
        QVERIFY2(none.told.startsWith(u"it could not be started: "_s), qPrintable(none.told));
    }

    void filesAreBounded()
    {
        ProgramLimits limits = within(60'000ms);
        limits.files = 1 << 20;

        const StudentRun run
            = runShell(u"head -c 8388608 /dev/zero > a; for f in a b c; do cat a > $f; done; "
                       "stat -c %s a"_s,
                       limits);

        QVERIFY2(run.output.trimmed().toInt() <= 1 << 20, run.output.constData());
    }

    void itsFolderIsEmptyAndGoesWithIt()
    {
        const StudentRun run
            = runShell(u"ls -A; pwd; mkdir -p a/b; ln -s / a/root; touch a/b/c \"$(printf "
                       "'x\\ny')\"; chmod 0 a/b a"_s);

        const QString folder = QString::fromUtf8(run.output.trimmed());
        QCOMPARE(folder.count(u'\n'), 0);
        QVERIFY(QDir::isAbsolutePath(folder));
        QVERIFY(!QFileInfo::exists(folder));
        QVERIFY(QFileInfo::exists(u"/etc/passwd"_s));
    }

    void outsideItsFolderItWritesNothing()
    {
        QTemporaryDir folder;
        QVERIFY(QFile::setPermissions(folder.path(), QFile::Permissions(0x7777)));
        const QString kept = folder.filePath(u"kept"_s);
        QVERIFY(!writeFile(kept, "as it was"));
        QVERIFY(QFile::setPermissions(kept, QFile::Permissions(0x6666)));

        const StudentRun run
            = runShell(u"ln -s '%1' out; echo x > out/kept; echo x > '%1/kept'; echo x > "
                       "'%1/new'; rm -rf out/* '%1/kept'; echo done"_s.arg(folder.path()));

        QCOMPARE(run.output, QByteArray("done\n"));
        if (!run.isSandboxed())
            QSKIP("Without namespaces it may write wherever its user may.");
        QCOMPARE(*readFile(kept), QByteArray("as it was"));
        QVERIFY(!QFileInfo::exists(folder.filePath(u"new"_s)));
    }

    void itHasNoNetworkAndSeesNoOtherProcess()
    {
        const StudentRun run = runShell(
            u"grep -c : /proc/net/dev; kill -0 %1 2>/dev/null && echo seen; ls /run; env"_s.arg(
                getpid()));

        if (!run.isSandboxed())
            QSKIP("The system gives no namespaces.");
        const QList<QByteArray> lines = run.output.split('\n');
        QCOMPARE(lines.first(), QByteArray("1")); // the loopback device
        QVERIFY(!lines.contains("seen"));
        for (const QByteArray &line : lines.sliced(1))
            QVERIFY2(line.isEmpty() || line.contains('='), line.constData()); // environment
                                                                              // variables
        QVERIFY(!run.output.contains("QT_"));
    }

    void itCanBeCancelled()
    {
        std::stop_source source;
        const QByteArray seconds = unusualSeconds();
        std::jthread canceller([&source, &seconds] {
            while (processesWith(seconds) == 0)
                std::this_thread::sleep_for(10ms);
            source.request_stop();
        });

        const StudentRun run
            = runProgram(*studentProgramOf({u"sleep"_s, QString::fromLatin1(seconds)}), {},
                         within(60'000ms), source.get_token());

        QCOMPARE(nameOf(run.end), nameOf(ProgramEnd::Cancelled));
        QCOMPARE(processesWith(seconds), 0);
    }

    void severalRunAtOnce()
    {
        std::array<StudentRun, 8> runs;
        {
            std::vector<std::jthread> threads;
            for (std::size_t i = 0; i < runs.size(); ++i)
                threads.emplace_back([&runs, i] {
                    runs[i]
                        = runShell(u"cat; [ %1 -lt 4 ] || sleep 1000"_s.arg(i),
                                   within(i < 4 ? 60'000ms : 500ms), QByteArray::number(int(i)));
                });
        }
        for (std::size_t i = 0; i < runs.size(); ++i) {
            QCOMPARE(nameOf(runs[i].end),
                     nameOf(i < 4 ? ProgramEnd::Finished : ProgramEnd::TimedOut));
            QCOMPARE(runs[i].output, QByteArray::number(int(i)));
        }
    }

    void itsOutputIsNotTrusted_data()
    {
        QTest::addColumn<QByteArray>("output");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QByteArray &output, const char *message) {
            QTest::newRow(name) << output << QString::fromUtf8(message);
        };
        row("nothing", "", "it is empty");
        row("nonsense", "hello \x1b[31mworld\x07", "neither a picture nor lines");
        row("a gigantic picture", "P6 2000000000 2000000000 255\n",
            "a broken PPM: line 1: “2000000000” is no width from 1 to 65535");
        row("a large one", "P6 30000 30000 255\n", "a picture of 30000 × 30000 pixels");
        row("one of another size", "P3 1 1 255 0 0 0\n", "a picture of 1 × 1 pixels");
        row("half a picture", halfPicture(), "a broken PNG: read beyond end of data");
        row("no pixels", "P6 4 3 255\n",
            "a PPM that ends early, 36 of 36 bytes of pixels are missing");
        row("a header that ends early", "P6 4\n",
            "a PPM that ends early, in its header: it has no height");
        row("levels that end early", "P3 4 3 255 1 2 3\n",
            "a PPM that ends early, 33 of 36 levels are missing");
        row("a bitmap that ends early", "P1 4 3\n1010 0\n",
            "a PBM that ends early, 7 of 12 levels are missing");
        row("another raster", "##\n..\n", "a picture of 2 × 2 pixels");
        row("a ragged raster", "##\n.\n", "the output");
        row("a program", "#define x_width 30000\n#define x_height 30000\n",
            "neither a picture nor lines");
        row("a raster with a letter", "###d\n....\n", "line 1, column 4: “d”; expected # or .");
        row("a level that is none", "P3 4 3 255\n0 0 300\n", "line 2: no level from 0 to 255");
        row("a drawing", "<svg xmlns='http://www.w3.org/2000/svg' width='4' height='3'/>",
            "neither a picture nor lines");
        row("a line that is none", "column 1 2 3\ncolumn 1 2\n", "line 2 of the output");
        row("a NUL", QByteArray("pixel 1\0 1 2 3 4\n", 17), "line 1 of the output");
        row("a long line", "column 1 2 3" + QByteArray(1000, ' ') + "\n",
            "or triangle n, in at most 200 bytes");
        row("too many lines", QByteArray("row 0 0 1\n").repeated(4'194'305),
            "line 4194305 of the output: one more column, row or pixel; expected at most 4194304");
        row("too large a coordinate", "pixel 99999999999 0 1 2 3\n", "line 1 of the output");
    }
    void itsOutputIsNotTrusted()
    {
        QFETCH(QByteArray, output);
        QFETCH(QString, message);

        const Result<StudentOutput> read = readStudentOutput(output, smallScene());

        QVERIFY(!read.isOk());
        QVERIFY2(read.error().message().contains(message), qPrintable(read.error().message()));
        for (const QChar character : read.error().message())
            QVERIFY(character.category() != QChar::Other_Control);
    }

    void aLevelThatIsNoByteIsNotTakenForTheNearestOne()
    {
        const Scene scene = smallScene();
        const auto read
            = readStudentOutput("pixel 1 1 256 300 99999\npixel 2 1 -1 inf 255.4\n", scene);
        QVERIFY(read && read->picture);
        const auto colourAt = [&](int x) {
            return read->picture
                ->colours[read->picture->placeOf(x, int(pictureLine(scene.frame, 1)))];
        };
        QCOMPARE(colourAt(1), (Colour{{0, 44, 159}}));
        QCOMPARE(colourAt(2), (Colour{{255, 64, 255}})); // no byte is right for inf
    }

    void whatIsShownHoldsNoEscapes()
    {
        const QString shown = shownText("a\x1b[2Jb\r\n\xff\xe2\x80\xae"
                                        "c\t"
                                            + QByteArray(500, 'd'),
                                        20);

        QCOMPARE(shown, u"a\uFFFD[2Jb\uFFFD\n\uFFFD\uFFFDc\tdddddddd …"_s);
    }

    void theCommandTellsHowItEndedWhatDiffersAndWhy()
    {
        QTemporaryDir folder;
        const QString drawn = folder.filePath(u"drawn.ppm"_s);
        QCOMPARE(run({"render", defaultScene(), "--rounding", "truncate", "-o", drawn}).exitCode,
                 0);

        const ProgramRun tried = run({"try", "--scene", defaultScene(), "--", "cat", drawn});

        QCOMPARE(tried.exitCode, 1);
        QVERIFY2(tried.output.contains(": it finished\n    64 × 48 pixels: 2214 same, 833 colour, "
                                       "25 undecidable"),
                 tried.output.constData());
        QVERIFY2(tried.output.contains("\nrounding-truncate\n"), tried.output.constData());

        // `cat` is not ours: built with a sanitizer, our programs need more memory than they are
        // given.
        const QString truth = folder.filePath(u"truth.ppm"_s);
        QCOMPARE(run({"render", defaultScene(), "-o", truth}).exitCode, 0);
        const ProgramRun right
            = run({"try", "--scene", defaultScene(), "--json", "--", "cat", truth});
        QCOMPARE(right.exitCode, 0);
        const QJsonObject report = QJsonDocument::fromJson(right.output).object();
        QVERIFY(report[u"right"_s].toBool());

        const ProgramRun crashed
            = run({"try", "--scene", defaultScene(), "--", "sh", "-c", "kill -ABRT $$"});
        QCOMPARE(crashed.exitCode, 1);
        QVERIFY2(crashed.output.contains("it crashed"), crashed.output.constData());
        QCOMPARE(run({"try", "true"}).exitCode, 2);
        QCOMPARE(run({"try", "/nowhere/at-all", "--scene", defaultScene()}).exitCode, 2);
        QCOMPARE(run({"try", "true", "--scene", defaultScene(), "--input", "xml"}).exitCode, 2);
    }

    void trianglesThatAreNamedAloneAreNotRight()
    {
        const auto tried = [](const QString &output, const QStringList &options = {}) {
            return pixelplumb::run(QStringList{"try", "--scene", defaultScene()} + options
                                   + QStringList{"--", "echo", output});
        };

        const ProgramRun named = tried(u"triangle 0"_s);
        QCOMPARE(named.exitCode, 1);
        QVERIFY2(named.output.contains("nothing was printed that could be compared"),
                 named.output.constData());
        QVERIFY2(!named.output.contains("\nright\n"), named.output.constData());
        const ProgramRun json = tried(u"triangle 0"_s, {"--json"});
        QVERIFY(json.output.contains("nothing was printed that could be compared"));
        const ProgramRun unknown = tried(u"triangle 7"_s);
        QCOMPARE(unknown.exitCode, 1);
        QVERIFY2(unknown.output.contains("triangle 7 is named, the scene has 1"),
                 unknown.output.constData());
        const ProgramRun beyond = tried(u"pixel 64 0 1 2 3"_s);
        QCOMPARE(beyond.exitCode, 1);
        QVERIFY2(beyond.output.contains("1 line of its trace lies beyond the frame"),
                 beyond.output.constData());
    }

    void withoutASandboxTheLimitsHold()
    {
        const QByteArray seconds = unusualSeconds();
        const StudentRun run = runProgram(
            *studentProgramOf(
                {u"sh"_s, u"-c"_s,
                 u"(setsid sh -c '(sleep %1 &) ; sleep %1' &) ; ulimit -v; sleep %1"_s.arg(
                     QString::fromLatin1(seconds))}),
            {}, within(500ms), {}, Confinement::LimitsAlone);

        QCOMPARE(run.output, QByteArray("1048576\n"));
        QVERIFY(run.isByClock);
        QCOMPARE(processesWith(seconds), 0);
    }

    void linesHaveTheScenesOwnCoordinatesAndSayWhereCentresAre()
    {
        Scene scene;
        scene.frame.pixelCentre = PixelCentre::Half;
        scene.triangles = {{{Vertex{latticePixel(4, 5), {}}, Vertex{latticePixel(9, 5), {}},
                             Vertex{latticePixel(4, 9), {}}}}};
        const QByteArray lines = *sceneLines(scene);
        QVERIFY2(lines.contains("\ncentre half\n"), lines.constData());
        QVERIFY2(lines.contains("\ntriangle 4 5 0 0 0 9 5 0 0 0 4 9 0 0 0\n"), lines.constData());
    }

    void theAdaptersDrawWhatTheirScanConverterDraws_data()
    {
        QTest::addColumn<QStringList>("make");
        QTest::addColumn<QStringList>("start");
        QTest::newRow("Python") << QStringList() << QStringList{"python3", "adapter.py"};
        QTest::newRow("C++") << QStringList{"c++",         "-std=c++17", "-Wall",  "-Werror",
                                            "adapter.cpp", "-o",         "student"}
                             << QStringList{"./student"};
    }
    void theAdaptersDrawWhatTheirScanConverterDraws()
    {
        QFETCH(QStringList, make);
        QFETCH(QStringList, start);
        QTemporaryDir folder;
        for (const QString &path :
             {resource(u"/adapters/adapter.py"_s), resource(u"/adapters/adapter.cpp"_s),
              testData("student/scanconverter.py"), testData("student/scanconverter.h")}) {
            QVERIFY(QFile::copy(path, folder.filePath(QFileInfo(path).fileName())));
        }
        if (!make.isEmpty()) {
            QProcess compiler;
            compiler.setWorkingDirectory(folder.path());
            compiler.start(make.front(), make.sliced(1));
            QVERIFY(compiler.waitForFinished(300'000));
            QVERIFY2(compiler.exitCode() == 0, compiler.readAllStandardError().constData());
        }
        for (QString &word : start) {
            if (QFileInfo::exists(folder.filePath(word)))
                word = folder.filePath(word);
        }

        const ProgramRun tried
            = run(QStringList{"try", "--input", "lines", "--scene", defaultScene(), "--scene",
                              sceneFile(u"sliver.json"_s), "--"}
                  + start);

        QVERIFY2(tried.exitCode == 0, tried.output + tried.messages);
    }
};

PIXELPLUMB_TEST(TestProgramRun)

} // namespace tst_programrun

#include "tst_programrun.moc"
