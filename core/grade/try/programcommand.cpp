// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/programcommand.h"

#include "core/grade/showntext.h"
#include "core/grade/try/programuser.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <optional>

namespace pixelplumb {

namespace {

constexpr rlim_t openFiles = 256;

/// The number of all existing processes and threads: no user has more.
rlim_t presentProcesses()
{
    QFile load(QStringLiteral("/proc/loadavg"));
    if (!load.open(QIODevice::ReadOnly))
        return 0;
    return rlim_t(load.readAll().split(' ').value(3).split('/').value(1).toULongLong());
}

/// "--cpu=10:11": neither limit exceeds our own hard limit.
QString limitWord(const char *name, __rlimit_resource resource, rlim_t soft, rlim_t hard)
{
    rlimit present = {RLIM_INFINITY, RLIM_INFINITY};
    getrlimit(resource, &present);
    const auto text = [&present](rlim_t limit) {
        const rlim_t least = std::min(limit, present.rlim_max);
        return least == RLIM_INFINITY ? QStringLiteral("unlimited") : QString::number(least);
    };
    return QStringLiteral("--%1=%2:%3").arg(QLatin1String(name), text(soft), text(hard));
}

/// Limits of each process. `processes` are counted by user; none: not limited.
QStringList limitWords(const ProgramLimits &limits, std::optional<rlim_t> processes)
{
    const auto word = [](const char *name, __rlimit_resource resource, rlim_t limit) {
        return limitWord(name, resource, limit, limit);
    };
    const auto seconds = rlim_t(limits.wholeSeconds());
    QStringList words = {
        QStringLiteral("/usr/bin/prlimit"),
        // For each process. SIGXCPU comes first, at the soft limit, so that this end can be told
        // from others.
        limitWord("cpu", RLIMIT_CPU, seconds, seconds + 1),
        word("as", RLIMIT_AS, limits.memory > 0 ? rlim_t(limits.memory) : RLIM_INFINITY),
        word("fsize", RLIMIT_FSIZE, rlim_t(limits.files)), word("nofile", RLIMIT_NOFILE, openFiles),
        word("core", RLIMIT_CORE, 0), word("msgqueue", RLIMIT_MSGQUEUE, 0)};
    if (processes)
        words += word("nproc", RLIMIT_NPROC, *processes);
    return words + QStringList(QStringLiteral("--"));
}

/// Starts what follows after limiting the processes of the sandbox's first process, too. With a
/// user of its own this is not needed: no process of the program's can trace that one.
QStringList firstProcessWords(const ProgramLimits &limits, const ProgramUser &user)
{
    if (user.isOwn)
        return {};
    const QString limit
        = limitWord("nproc", RLIMIT_NPROC, rlim_t(limits.processes), rlim_t(limits.processes));
    return {QStringLiteral("/bin/sh"), QStringLiteral("-c"),
            QStringLiteral("/usr/bin/prlimit --pid=1 %1 && exec \"$@\"").arg(limit),
            QStringLiteral("sh")};
}

QStringList wordsOf(const StudentProgram &student)
{
    return QStringList{student.path} + student.arguments;
}

/// What programs need to run, and nothing of the user's: in /etc only what tells the loader,
/// alternatives and runtimes where things are.
QStringList systemFolders()
{
    QStringList folders;
    for (const char *name : {"/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32",
                             "/nix/store", "/gnu/store", "/etc/alternatives", "/etc/ld.so.cache",
                             "/etc/ld.so.conf", "/etc/ld.so.conf.d", "/etc/localtime"})
        folders += QString::fromLatin1(name);
    const QDir settings(QStringLiteral("/etc"));
    for (const QString &name :
         settings.entryList({QStringLiteral("java-*"), QStringLiteral("mono")}, QDir::Dirs))
        folders += settings.filePath(name);
    return folders;
}

/// Our own programs: a student's program that ran them would hand in their pictures.
QStringList hiddenFiles()
{
    const QString own = QFile::symLinkTarget(QStringLiteral("/proc/self/exe"));
    QStringList files;
    const QDir folder(QFileInfo(own).path());
    for (const QString &name : folder.entryList({QStringLiteral("pixelplumb*")}, QDir::Files))
        files += folder.filePath(name);
    for (const char *name : {"pixelplumb", "pixelplumb-cli"})
        files += QStandardPaths::findExecutable(QLatin1String(name));
    files.removeAll(QString());
    files.removeDuplicates();
    return files;
}

bool isInOneOf(const QStringList &folders, const QString &path)
{
    return std::ranges::any_of(folders, [&path](const QString &folder) {
        return path == folder || path.startsWith(folder + u'/');
    });
}

/// What of /proc only root may read. A program that runs as a user of its own keeps root's right to
/// read, for its own files.
QStringList rootsFilesOfProc()
{
    QStringList files;
    for (const char *name : {"/proc", "/proc/sys/kernel", "/proc/sys/vm", "/proc/tty"}) {
        const QDir folder(QString::fromLatin1(name));
        for (const QFileInfo &file : folder.entryInfoList(QDir::AllEntries | QDir::Hidden
                                                          | QDir::System | QDir::NoDotAndDotDot)) {
            const bool isProcess = file.fileName().at(0).isDigit();
            if (!isProcess && !file.isSymLink() && !file.permission(QFile::ReadOther))
                files += file.filePath();
        }
    }
    return files;
}

/// Puts nothing in place of a file, or of a folder's content.
QStringList hidingWords(const QString &path)
{
    if (QFileInfo(path).isDir())
        return {QStringLiteral("--size"),       QStringLiteral("4096"),
                QStringLiteral("--tmpfs"),      path,
                QStringLiteral("--remount-ro"), path};
    return {QStringLiteral("--ro-bind"), QStringLiteral("/dev/null"), path};
}

/// What the sandbox shows: the system and the program's own files, read-only, and folders in memory
/// with at most `bytes` each; nothing of what is hidden.
QStringList viewWords(const QStringList &shown, const QStringList &hidden, std::int64_t bytes)
{
    QStringList words;
    QStringList seen = systemFolders();
    for (const QString &path : seen)
        words += {QStringLiteral("--ro-bind-try"), path, path};
    words += {QStringLiteral("--proc"), QStringLiteral("/proc"), QStringLiteral("--dev"),
              QStringLiteral("/dev"),   QStringLiteral("--dir"), QStringLiteral("/run")};
    for (const char *folder : {"/dev/shm", "/tmp"})
        words += {QStringLiteral("--perms"), QStringLiteral("1777"),    QStringLiteral("--size"),
                  QString::number(bytes),    QStringLiteral("--tmpfs"), QLatin1String(folder)};
    // No terminals, which the machine has only a limited number of: /dev/ptmx leads nowhere.
    words += hidingWords(QStringLiteral("/dev/pts"));
    for (const QString &path : hidden)
        words += hidingWords(path);
    for (const QString &path : shown) {
        if (!isInOneOf(seen, path))
            words += {QStringLiteral("--ro-bind"), path, path};
    }
    seen += shown;
    for (const QString &file : hiddenFiles()) {
        if (isInOneOf(seen, file))
            words += hidingWords(file);
    }
    return words + QStringList{QStringLiteral("--perms"),      QStringLiteral("0777"),
                               QStringLiteral("--dir"),        sandboxFolder(),
                               QStringLiteral("--remount-ro"), QStringLiteral("/dev"),
                               QStringLiteral("--remount-ro"), QStringLiteral("/"),
                               QStringLiteral("--chdir"),      sandboxFolder()};
}

/// What is separated, and which of root's capabilities stay until the user changes.
QStringList separationWords(const ProgramUser &user)
{
    QStringList words;
    for (const char *space : {"ipc", "pid", "net", "uts", "cgroup-try"})
        words += QStringLiteral("--unshare-") + QLatin1String(space);
    if (!user.isOwn)
        words += QStringLiteral("--unshare-user");
    words += {QStringLiteral("--new-session"), QStringLiteral("--die-with-parent"),
              QStringLiteral("--cap-drop"), QStringLiteral("ALL")};
    for (const QString &capability : user.isOwn ? ProgramUser::capabilities() : QStringList())
        words += {QStringLiteral("--cap-add"), capability};
    return words;
}

} // namespace

QStringList limitedCommand(const StudentProgram &student, const ProgramLimits &limits,
                           const ProgramUser &user)
{
    // Other processes of the same user count too.
    const rlim_t others = user.isOwn ? 0 : presentProcesses();
    return limitWords(limits, rlim_t(limits.processes) + others) + user.command()
        + wordsOf(student);
}

QStringList sandboxedCommand(const StudentProgram &student, const ProgramLimits &limits,
                             const ProgramUser &user, int filter)
{
    static const QStringList rootsFiles = rootsFilesOfProc(); // the same for every program
    // The program could trace the sandbox's first process and make it work for it.
    return limitWords(limits, std::nullopt) + QStringList{bubblewrapPath()} + separationWords(user)
        + viewWords(student.shown, user.isOwn ? rootsFiles : QStringList(), limits.files)
        + QStringList{QStringLiteral("--seccomp"), QString::number(filter), QStringLiteral("--")}
    + firstProcessWords(limits, user) + limitWords(limits, rlim_t(limits.processes))
        + user.command() + wordsOf(student);
}

QString bubblewrapPath()
{
    // A relative entry of PATH could name a folder of the program to be confined.
    QStringList folders = qEnvironmentVariable("PATH").split(u':', Qt::SkipEmptyParts);
    folders.removeIf([](const QString &folder) { return QDir::isRelativePath(folder); });
    return folders.isEmpty() ? QString()
                             : QStandardPaths::findExecutable(QStringLiteral("bwrap"), folders);
}

QString sandboxFolder() { return QStringLiteral("/tmp/pixelplumb-program"); }

QString faultOfStart(int exitCode, const QByteArray &messages)
{
    constexpr int ofTools = 1;
    constexpr std::array ofExecution = {126, 127};
    const bool isOfTools
        = exitCode == ofTools || exitCode == ofExecution[0] || exitCode == ofExecution[1];
    // By path, for when they cannot be loaded.
    const std::array tools = {QByteArray("bwrap"),
                              QByteArray("setpriv"),
                              QByteArray("prlimit"),
                              QFile::encodeName(bubblewrapPath()),
                              QByteArray("/usr/bin/setpriv"),
                              QByteArray("/usr/bin/prlimit")};
    const bool isTold = std::ranges::any_of(
        tools, [&](const QByteArray &tool) { return messages.startsWith(tool + ": "); });
    return isOfTools && isTold ? shownText(messages.left(messages.indexOf('\n'))) : QString();
}

} // namespace pixelplumb
