// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/descriptor.h"
#include "core/grade/try/programrun.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/programs/submissions.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <csignal>
#include <cstdlib>

namespace tst_sandbox {

using namespace pixelplumb;

namespace {

/// Replaces NAME in the script by a name: a file named on the command line would be visible in the
/// sandbox.
StudentRun runPython(QString script, Confinement confinement, const QString &name = {},
                     const ProgramLimits &limits = {})
{
    script.replace(u"NAME"_s, name);
    const auto program = studentProgramOf({u"python3"_s, u"-c"_s, script});
    return runProgram(*program, {}, limits, {}, confinement);
}

/// Whether data or a connection arrives at the descriptor.
bool isReached(const Descriptor &descriptor)
{
    pollfd awaited = {descriptor.number(), POLLIN, 0};
    return poll(&awaited, 1, 0) > 0;
}

/// A listening socket; not open if that is impossible.
template <class Address>
Descriptor listenAt(const Address &address, socklen_t length)
{
    const auto *named = reinterpret_cast<const sockaddr *>(&address);
    Descriptor made(socket(named->sa_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const bool listens = bind(made.number(), named, length) == 0 && listen(made.number(), 4) == 0;
    return listens ? std::move(made) : Descriptor();
}

Descriptor listenAtPath(const QByteArray &path)
{
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    std::copy(path.begin(), path.end(), address.sun_path);
    const auto length = socklen_t(offsetof(sockaddr_un, sun_path) + std::size_t(path.size()));
    Descriptor listening = listenAt(address, length);
    if (!path.startsWith('\0'))
        chmod(path.constData(), 0777);
    return listening;
}

/// A listening socket on the loopback device, and its port.
std::pair<Descriptor, int> listenAtPort()
{
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    Descriptor listening = listenAt(address, sizeof address);
    socklen_t length = sizeof address;
    getsockname(listening.number(), reinterpret_cast<sockaddr *>(&address), &length);
    return {std::move(listening), int(ntohs(address.sin_port))};
}

/// A folder that everybody may enter, as with system folders.
std::unique_ptr<QTemporaryDir> openFolderIn(const QString &folder)
{
    auto made = std::make_unique<QTemporaryDir>(folder + u"/sandbox-test-XXXXXX"_s);
    chmod(QFile::encodeName(made->path()).constData(), 0755);
    return made;
}

constexpr const char *connecting = "import socket\n"
                                   "name = 'NAME'.replace('@', '\\0')\n"
                                   "if name.isdigit():\n"
                                   "    socket.create_connection(('127.0.0.1', int(name)), 5)\n"
                                   "else:\n"
                                   "    socket.socket(socket.AF_UNIX).connect(name)\n"
                                   "print('connected')\n";

} // namespace

/// Programs that try to leave the sandbox, in every way we know; and, where it is harmless, that
/// the same ways work without a sandbox.
class TestSandbox : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!sandboxLack().isEmpty())
            QSKIP(qPrintable(u"No sandbox here: "_s + sandboxLack()));
    }

    void noSocketOutsideIsReached_data()
    {
        QTest::addColumn<QString>("place"); // a folder; @ for an abstract name; : for a port
        QTest::newRow("in /tmp") << QDir::tempPath();
        QTest::newRow("in /run") << u"/run"_s;
        QTest::newRow("in the home folder") << QDir::homePath();
        QTest::newRow("by an abstract name") << u"@"_s;
        QTest::newRow("on the loopback device") << u":"_s;
    }
    void noSocketOutsideIsReached()
    {
        QFETCH(QString, place);
        std::unique_ptr<QTemporaryDir> folder;
        Descriptor listening;
        QString name;
        if (place == u':') {
            auto [made, port] = listenAtPort();
            listening = std::move(made);
            name = QString::number(port);
        } else if (place == u'@') {
            name = u"@pixelplumb-test-%1"_s.arg(getpid());
            listening = listenAtPath(name.toUtf8().replace('@', '\0'));
        } else {
            folder = openFolderIn(place);
            name = folder->filePath(u"socket"_s);
            listening = listenAtPath(QFile::encodeName(name));
        }
        if (!listening.isOpen())
            QSKIP("Nobody may listen there.");
        const QString script = QString::fromLatin1(connecting);

        const StudentRun inside = runPython(script, Confinement::Sandbox, name);

        QCOMPARE(nameOf(inside.end), u"failed"_s);
        QVERIFY(!isReached(listening));
        const StudentRun outside = runPython(script, Confinement::LimitsAlone, name);
        if (outside.output != "connected\n") // its user may not enter root's folder
            QSKIP("Nor is it reached without a sandbox.");
        QVERIFY(isReached(listening));
    }

    void noTerminalIsWrittenTo()
    {
        const Descriptor terminal(posix_openpt(O_RDWR | O_NOCTTY));
        if (!terminal.isOpen() || grantpt(terminal.number()) != 0
            || unlockpt(terminal.number()) != 0)
            QSKIP("No terminal can be made.");
        const QString name = QString::fromLocal8Bit(ptsname(terminal.number()));
        const Descriptor held(open(ptsname(terminal.number()), O_RDWR | O_NOCTTY | O_CLOEXEC));
        chmod(ptsname(terminal.number()), 0666);
        const QString script
            = u"import fcntl, os, termios\n"
              "for name in ['NAME', '/dev/tty', '/dev/console', 0, 1, 2]:\n"
              "    try:\n"
              "        file = os.open(name, os.O_RDWR | os.O_NOCTTY) if isinstance(name, str) else "
              "name\n"
              "        if isinstance(name, str): os.write(file, b'\\x1b]0;owned\\x07')\n"
              "        fcntl.ioctl(file, termios.TIOCSTI, b'x')\n"
              "    except OSError: pass\n"_s;

        runPython(script, Confinement::Sandbox, name);
        QVERIFY(!isReached(terminal));
        runPython(script, Confinement::LimitsAlone, name);
        QVERIFY(isReached(terminal));
    }

    /// The machine has a limited number of terminals for all, and a program could use them up.
    void noTerminalIsMade()
    {
        const QString script = u"import os\n"
                               "os.open('/dev/ptmx', os.O_RDWR | os.O_NOCTTY)\n"
                               "print('made')"_s;
        QCOMPARE(runPython(script, Confinement::Sandbox).output, QByteArray());
        if (runPython(script, Confinement::LimitsAlone).output != "made\n")
            QSKIP("Nor is one made without a sandbox.");
    }

    void noPipeOutsideIsWrittenTo()
    {
        const auto folder = openFolderIn(QDir::tempPath());
        const QString name = folder->filePath(u"pipe"_s);
        QCOMPARE(mkfifo(QFile::encodeName(name).constData(), 0666), 0);
        chmod(QFile::encodeName(name).constData(), 0666);
        const Descriptor reader(
            open(QFile::encodeName(name).constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
        const QString script = u"import os\n"
                               "os.write(os.open('NAME', os.O_WRONLY | os.O_NONBLOCK), b'x')"_s;

        runPython(script, Confinement::Sandbox, name);
        QVERIFY(!isReached(reader));
        runPython(script, Confinement::LimitsAlone, name);
        QVERIFY(isReached(reader));
    }

    void nobodyElseIsSentASignal()
    {
        QProcess witness;
        witness.start(u"sleep"_s, {u"1000"_s});
        QVERIFY(witness.waitForStarted());

        const StudentRun run
            = runPython(u"import os, signal\n"
                        "seen = [int(each) for each in os.listdir('/proc') if each.isdigit()]\n"
                        "for each in seen + [os.getppid(), NAME, %1]:\n"
                        "    if each != os.getpid():\n"
                        "        try: os.kill(each, signal.SIGKILL)\n"
                        "        except OSError: pass\n"
                        "try: os.kill(-1, signal.SIGKILL)\n"
                        "except PermissionError: print('not all')\n"_s.arg(getpid()),
                        Confinement::Sandbox, QString::number(witness.processId()));

        // The program may end the first process of its own namespace, and thereby itself.
        QVERIFY2(run.output == "not all\n" || run.end == ProgramEnd::Crashed, qPrintable(run.told));
        QCOMPARE(witness.state(), QProcess::Running);
        witness.kill();
        QVERIFY(witness.waitForFinished());
    }

    /// Including the sandbox's own process: a program that can trace it can make it do its work.
    void everyProcessThatItCanReachHasItsLimits()
    {
        const StudentRun run = runPython(
            u"import os\n"
            "for each in os.listdir('/proc'):\n"
            "    try: os.kill(int(each), 0); text = open(f'/proc/{each}/limits').read()\n"
            "    except (OSError, ValueError): continue\n"
            "    of = {line[:26].strip(): line[26:].split()[1] for line in text.splitlines()}\n"
            "    print(of['Max processes'], of['Max address space'], of['Max cpu time'])\n"_s,
            Confinement::Sandbox);

        QList<QByteArray> lines = run.output.trimmed().split('\n');
        QVERIFY2(lines.front().startsWith("64 "), run.output.constData());
        lines.removeAll(lines.front());
        QVERIFY2(lines.isEmpty(), run.output.constData());
    }

    void memoryThatNoProcessOwnsIsBounded()
    {
        ProgramLimits limits;
        limits.files = 4 << 20;
        const StudentRun run = runPython(
            u"import ctypes, os\n"
            "libc = ctypes.CDLL(None, use_errno=True)\n"
            "page = ctypes.create_string_buffer(1 << 12)\n"
            "pages = (ctypes.c_size_t * 2)(ctypes.addressof(page), 1 << 12)\n"
            "print(libc.memfd_create(b'x', 0), libc.shmget(0, 1 << 28, 0o1600),\n"
            "      libc.msgget(0, 0o1600), libc.unshare(0x10000000),\n"
            "      libc.setxattr(b'/tmp', b'user.a', b'b', 1, 0),\n"
            "      libc.vmsplice(os.pipe()[1], pages, 1, 0))\n"
            "written = 0\n"
            "for folder, _, _ in os.walk('/'):\n"
            "    if folder.startswith('/proc'): continue\n"
            "    for i in range(8):\n"
            "        try:\n"
            "            file = os.open(f'{folder}/{i}.large', os.O_CREAT | os.O_WRONLY)\n"
            "            while True: written += os.write(file, bytes(1 << 16))\n"
            "        except OSError: pass\n"
            "print(written)\n"_s,
            Confinement::Sandbox, {}, limits);

        const QList<QByteArray> lines = run.output.split('\n');
        QCOMPARE(lines.front(), QByteArray("-1 -1 -1 -1 -1 -1"));
        const qint64 written = lines.value(1).toLongLong();
        QVERIFY2(written >= limits.files && written <= 2 * limits.files, run.output.constData());
    }

    void filesOfOthersAreNotSeen()
    {
        const auto folder = openFolderIn(QDir::homePath());
        const auto other = openFolderIn(QDir::tempPath());
        if (!folder->isValid())
            QSKIP("Nothing can be written to the home folder.");
        const QStringList files = {folder->filePath(u"secret"_s), other->filePath(u"secret"_s),
                                   u"/etc/passwd"_s, u"/etc/hostname"_s};
        QVERIFY(writeTo(files[0], "s") && writeTo(files[1], "s"));
        const QString script
            = u"import os\n"
              "print(*[name for name in 'NAME'.split() if os.path.exists(name)])\n"
              "print(*os.listdir(os.environ['HOME']), *os.listdir('/run'), *os.listdir('.'))\n"_s;

        const StudentRun run = runPython(script, Confinement::Sandbox, files.join(u' '));

        QCOMPARE(run.output, QByteArray("\n\n"));
    }

    /// Reading is root's right, which a user of its own keeps for the program's files.
    void whatTheKernelTellsRootAloneIsNotTold()
    {
        const QString script
            = u"import os, stat\n"
              "told = []\n"
              "for name in ['vmallocinfo', 'slabinfo', 'timer_list', 'kpagecount', 'kmsg']:\n"
              "    name = '/proc/' + name\n"
              "    try:\n"
              "        if stat.S_ISREG(os.stat(name).st_mode) and os.open(name, os.O_RDONLY) >= "
              "0:\n"
              "            told.append(name)\n"
              "    except OSError: pass\n"
              "print(*told, os.listdir('/proc/tty/driver') if os.access('/proc/tty/driver', "
              "os.R_OK)"
              " else [])\n"_s;

        const StudentRun run = runPython(script, Confinement::Sandbox);

        QCOMPARE(run.output, QByteArray("[]\n"));
    }

    void aProgramSeesItsFolderAndNoOther()
    {
        const auto folder = openFolderIn(QDir::tempPath());
        const QString program = folder->filePath(u"ada/draw"_s);
        QVERIFY(writeTo(program,
                        "#!/bin/sh\ncat \"$(dirname \"$0\")/table\" 2>&1; cat \""
                            + QFile::encodeName(folder->filePath(u"bob/table"_s))
                            + "\" 2>/dev/null || echo hidden\n"));
        chmod(QFile::encodeName(program).constData(), 0755);
        QVERIFY(writeTo(folder->filePath(u"ada/table"_s), "her own\n"));
        QVERIFY(writeTo(folder->filePath(u"bob/table"_s), "another's\n"));

        const auto inFolder = studentProgramOf({program});
        const auto alone = studentProgramOf({program}, ShownFiles::Alone);

        QCOMPARE(runProgram(*inFolder, {}).output, QByteArray("her own\nhidden\n"));
        const QByteArray output = runProgram(*alone, {}).output;
        QVERIFY2(!output.contains("her own") && output.endsWith("hidden\n"), output.constData());
    }

    /// A newer kernel may do by another number what is denied: setxattrat (463) holds memory.
    void callsThatAreNotKnownAreDenied()
    {
        const QString script
            = u"import ctypes, errno\n"
              "libc = ctypes.CDLL(None, use_errno=True)\n"
              "def failure(call):\n"
              "    libc.syscall(call, -1, 0, 0, 0, 0, 0)\n"
              "    return ctypes.get_errno()\n"
              "libc.syscall(463, -100, b'/tmp', 0, b'user.a', (ctypes.c_uint64 * 2)(), 16)\n"
              "print(*[each for each in range(450, 1024) if failure(each) != errno.ENOSYS])\n"_s;

        QCOMPARE(runPython(script, Confinement::Sandbox).output, QByteArray("\n"));
    }

    /// Beside a program in a folder of many only it is seen: in the home folder, by its own path
    /// and by that of a link, and where everybody may write.
    void whatLiesBesideAProgramInASharedFolderIsNotSeen_data()
    {
        QTest::addColumn<bool>("isHome");
        QTest::addColumn<QString>("home"); // in the test's folder
        QTest::addColumn<int>("mode");
        QTest::addColumn<QByteArray>("seen");
        const QByteArray hidden = "hidden\n";
        QTest::newRow("a folder of its own")
            << false << QString() << 0755 << QByteArray("others'\n");
        QTest::newRow("the home folder") << true << u"real"_s << 0755 << hidden;
        QTest::newRow("a home folder by a link") << true << u"link"_s << 0755 << hidden;
        QTest::newRow("a home folder in one by a link")
            << true << u"link/below"_s << 0755 << hidden;
        QTest::newRow("where everybody may write") << false << QString() << 01777 << hidden;
    }
    void whatLiesBesideAProgramInASharedFolderIsNotSeen()
    {
        QFETCH(bool, isHome);
        QFETCH(QString, home);
        QFETCH(int, mode);
        QFETCH(QByteArray, seen);
        const auto folder = openFolderIn(QDir::tempPath());
        const QByteArray real = QFile::encodeName(folder->filePath(u"real"_s));
        const QString program = folder->filePath(u"real/draw"_s);
        QVERIFY(
            writeTo(program, "#!/bin/sh\ncat \"$(dirname \"$0\")/table\" 2>&- || echo hidden\n"));
        QVERIFY(writeTo(folder->filePath(u"real/table"_s), "others'\n"));
        chmod(QFile::encodeName(program).constData(), 0755);
        chmod(real.constData(), mode_t(mode));
        QVERIFY(QFile::link(QString::fromLocal8Bit(real), folder->filePath(u"link"_s)));
        QVERIFY(QDir(folder->path()).mkpath(u"real/below"_s));
        const QByteArray before = qgetenv("HOME");
        if (isHome)
            qputenv("HOME", QFile::encodeName(folder->filePath(home)));

        const auto byPath = studentProgramOf({program});
        const auto byLink = studentProgramOf({folder->filePath(u"link/draw"_s)});
        qputenv("HOME", before);

        QCOMPARE(runProgram(*byPath, {}).output, seen);
        QCOMPARE(runProgram(*byLink, {}).output, seen);
    }

    void ourOwnProgramsAreHiddenFromIt()
    {
        const QStringList words{"sh", "-c", "\"$0\" --version >&2 && echo ran; exit 3", program()};
        const ProgramRun tried
            = run(QStringList{"try", "--scene", defaultScene(), "--json", "--"} + words);

        QVERIFY2(tried.output.contains("exit code 3"), tried.output.constData());
        QVERIFY2(tried.output.contains("ermission denied"), tried.output.constData());
    }
};

PIXELPLUMB_TEST(TestSandbox)

} // namespace tst_sandbox

#include "tst_sandbox.moc"
