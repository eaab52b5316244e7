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
    QFile load(u"/proc/loadavg"_s);
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
        return least == RLIM_INFINITY ? u"unlimited"_s : QString::number(least);
    };
    return u"--%1=%2:%3"_s.arg(QLatin1String(name), text(soft), text(hard));
}

/// Limits of each process. `processes` are counted by user; none: not limited.
QStringList limitWords(const ProgramLimits &limits, std::optional<rlim_t> processes)
{
    const auto word = [](const char *name, __rlimit_resource resource, rlim_t limit) {
        return limitWord(name, resource, limit, limit);
    };
    const auto seconds = rlim_t(limits.wholeSeconds());
    QStringList words = {
        u"/usr/bin/prlimit"_s,
        // For each process. SIGXCPU comes first, at the soft limit, so that this end can be told
        // from others.
        limitWord("cpu", RLIMIT_CPU, seconds, seconds + 1),
        word("as", RLIMIT_AS, limits.memory > 0 ? rlim_t(limits.memory) : RLIM_INFINITY),
        word("fsize", RLIMIT_FSIZE, rlim_t(limits.files)), word("nofile", RLIMIT_NOFILE, openFiles),
        word("core", RLIMIT_CORE, 0), word("msgqueue", RLIMIT_MSGQUEUE, 0)};
    if (processes)
        words += word("nproc", RLIMIT_NPROC, *processes);
    return words + QStringList(u"--"_s);
}

/// Starts what follows after limiting the processes of the sandbox's first process, too. With a
/// user of its own this is not needed: no process of the program's can trace that one.
QStringList firstProcessWords(const ProgramLimits &limits, const ProgramUser &user)
{
    if (user.isOwn)
        return {};
    const QString limit
        = limitWord("nproc", RLIMIT_NPROC, rlim_t(limits.processes), rlim_t(limits.processes));
    return {u"/bin/sh"_s, u"-c"_s, u"/usr/bin/prlimit --pid=1 %1 && exec \"$@\""_s.arg(limit),
            u"sh"_s};
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
    const QDir settings(u"/etc"_s);
    for (const QString &name : settings.entryList({u"java-*"_s, u"mono"_s}, QDir::Dirs))
        folders += settings.filePath(name);
    return folders;
}

/// Our own programs: a student's program that ran them would hand in their pictures.
QStringList hiddenFiles()
{
    const QString own = QFile::symLinkTarget(u"/proc/self/exe"_s);
    QStringList files;
    const QDir folder(QFileInfo(own).path());
    for (const QString &name : folder.entryList({u"pixelplumb*"_s}, QDir::Files))
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
        return {u"--size"_s, u"4096"_s, u"--tmpfs"_s, path, u"--remount-ro"_s, path};
    return {u"--ro-bind"_s, u"/dev/null"_s, path};
}

/// What the sandbox shows: the system and the program's own files, read-only, and folders in memory
/// with at most `bytes` each; nothing of what is hidden.
QStringList viewWords(const QStringList &shown, const QStringList &hidden, std::int64_t bytes)
{
    QStringList words;
    QStringList seen = systemFolders();
    for (const QString &path : seen)
        words += {u"--ro-bind-try"_s, path, path};
    words += {u"--proc"_s, u"/proc"_s, u"--dev"_s, u"/dev"_s, u"--dir"_s, u"/run"_s};
    for (const char *folder : {"/dev/shm", "/tmp"})
        words += {u"--perms"_s,           u"1777"_s,    u"--size"_s,
                  QString::number(bytes), u"--tmpfs"_s, QLatin1String(folder)};
    // No terminals, which the machine has only a limited number of: /dev/ptmx leads nowhere.
    words += hidingWords(u"/dev/pts"_s);
    for (const QString &path : hidden)
        words += hidingWords(path);
    for (const QString &path : shown) {
        if (!isInOneOf(seen, path))
            words += {u"--ro-bind"_s, path, path};
    }
    seen += shown;
    for (const QString &file : hiddenFiles()) {
        if (isInOneOf(seen, file))
            words += hidingWords(file);
    }
    return words
        + QStringList{u"--perms"_s,      u"0777"_s,      u"--dir"_s,        sandboxFolder(),
                      u"--remount-ro"_s, u"/dev"_s,      u"--remount-ro"_s, u"/"_s,
                      u"--chdir"_s,      sandboxFolder()};
}

/// What is separated, and which of root's capabilities stay until the user changes.
QStringList separationWords(const ProgramUser &user)
{
    QStringList words;
    for (const char *space : {"ipc", "pid", "net", "uts", "cgroup-try"})
        words += u"--unshare-"_s + QLatin1String(space);
    if (!user.isOwn)
        words += u"--unshare-user"_s;
    words += {u"--new-session"_s, u"--die-with-parent"_s, u"--cap-drop"_s, u"ALL"_s};
    for (const QString &capability : user.isOwn ? ProgramUser::capabilities() : QStringList())
        words += {u"--cap-add"_s, capability};
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
        + QStringList{u"--seccomp"_s, QString::number(filter), u"--"_s}
    + firstProcessWords(limits, user) + limitWords(limits, rlim_t(limits.processes))
        + user.command() + wordsOf(student);
}

QString bubblewrapPath()
{
    // A relative entry of PATH could name a folder of the program to be confined.
    QStringList folders = qEnvironmentVariable("PATH").split(u':', Qt::SkipEmptyParts);
    folders.removeIf([](const QString &folder) { return QDir::isRelativePath(folder); });
    return folders.isEmpty() ? QString() : QStandardPaths::findExecutable(u"bwrap"_s, folders);
}

QString sandboxFolder() { return u"/tmp/pixelplumb-program"_s; }

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
