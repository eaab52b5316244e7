// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/workingfolder.h"

#include "core/grade/descriptor.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRandomGenerator>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <ctime>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

const QString nameStart = u"pixelplumb-program-"_s;

QStringList removalOf(const QString &folder)
{
    // Folders may lack permissions for their owner.
    return {u"/bin/sh"_s, u"-c"_s,
            u"/bin/rm -rf -- \"$1\" 2>/dev/null || "
            "{ /bin/chmod -R u+rwx -- \"$1\"; /bin/rm -rf -- \"$1\"; } 2>/dev/null"_s,
            u"sh"_s, folder};
}

void remove(const QString &folder)
{
    const QStringList words = removalOf(folder);
    QProcess::execute(words.front(), words.sliced(1));
}

/// Opens a directory; not open for anything else, links included.
Descriptor opened(const QString &folder)
{
    return Descriptor(open(QFile::encodeName(folder).constData(),
                           O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

/// False where another process holds the lock.
bool lock(const Descriptor &folder) { return flock(folder.number(), LOCK_EX | LOCK_NB) == 0; }

/// Whether it is abandoned: unlocked, and not just being made.
bool isLeft(const Descriptor &folder)
{
    constexpr time_t makingTime = 60; // s
    struct stat status = {};
    return fstat(folder.number(), &status) == 0 && (status.st_uid == geteuid() || geteuid() == 0)
        && time(nullptr) - status.st_mtime > makingTime && lock(folder);
}

void removeLeftFolders()
{
    const QDir all(QDir::tempPath());
    for (const QString &name : all.entryList({nameStart + u'*'}, QDir::Dirs | QDir::NoSymLinks)) {
        const Descriptor folder = opened(all.filePath(name));
        if (folder.isOpen() && isLeft(folder))
            remove(all.filePath(name));
    }
}

} // namespace

WorkingFolder::WorkingFolder()
{
    static const bool isTidy = (removeLeftFolders(), true);
    Q_UNUSED(isTidy)
    m_path = QDir::tempPath() + u'/' + nameStart
        + QString::number(QRandomGenerator::system()->generate64(), 36);
}

WorkingFolder::~WorkingFolder()
{
    if (!m_path.isEmpty() && QFile::exists(m_path))
        remove(m_path);
}

QStringList WorkingFolder::removal() const { return removalOf(m_path); }

void WorkingFolder::endProcesses() const
{
    const QByteArray mark = QByteArray("TMPDIR=") + QFile::encodeName(m_path);
    constexpr int rounds = 100; // a killed process may have started another
    bool hasFound = true;
    for (int round = 0; round < rounds && hasFound; ++round) {
        hasFound = false;
        for (const QString &process : QDir(u"/proc"_s).entryList(QDir::Dirs)) {
            const pid_t number = process.toInt();
            QFile environment(u"/proc/%1/environ"_s.arg(process));
            const bool isOfProgram = number > 0 && environment.open(QIODevice::ReadOnly)
                && environment.readAll().split('\0').contains(mark);
            if (isOfProgram)
                hasFound = kill(number, SIGKILL) == 0 || hasFound;
        }
    }
}

} // namespace pixelplumb
