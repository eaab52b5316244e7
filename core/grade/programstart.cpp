// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/programstart.h"

#include <QFile>

#include <unistd.h>

#include <atomic>

namespace pixelplumb {

namespace {

constexpr rlim_t openFiles = 256;

/// All processes and threads that there are: those of one user are no more.
rlim_t presentProcesses()
{
    QFile load(QStringLiteral("/proc/loadavg"));
    if (!load.open(QIODevice::ReadOnly))
        return 0;
    return rlim_t(load.readAll().split(' ').value(3).split('/').value(1).toULongLong());
}

std::array<ResourceLimit, 6> resourceLimits(const ProgramLimits &limits)
{
    return {{
        {RLIMIT_CPU, rlim_t(limits.wholeSeconds())}, // of each process
        {RLIMIT_AS, limits.memory > 0 ? rlim_t(limits.memory) : RLIM_INFINITY},
        {RLIMIT_FSIZE, rlim_t(limits.files)},
        {RLIMIT_NOFILE, openFiles},
        {RLIMIT_CORE, 0},
        {RLIMIT_MSGQUEUE, 0},
    }};
}

/// False in a container that knows but some of the system's users: its root is none of them.
bool knowsAllUsers()
{
    QFile map(QStringLiteral("/proc/self/uid_map"));
    return map.open(QIODevice::ReadOnly) && map.readAll().simplified() == "0 0 4294967295";
}

/// Where root starts it: a user for each run, so that what it starts is counted by itself.
uid_t userOfRun()
{
    static std::atomic<uid_t> runs = 0;
    constexpr uid_t first = 1'000'000'000; // far from those that systems give
    constexpr uid_t each = 1000; // of a process that runs programs
    constexpr pid_t processes = 1'000'000;
    if (geteuid() != 0 || !knowsAllUsers())
        return geteuid();
    return first + uid_t(getpid() % processes) * each + runs++ % each;
}

} // namespace

ProgramStart::WordList::WordList(const QStringList &words)
{
    for (const QString &word : words)
        m_words.push_back(QFile::encodeName(word));
    for (QByteArray &word : m_words)
        m_pointers.push_back(word.data());
    m_pointers.push_back(nullptr);
}

ProgramStart::ProgramStart(const StudentProgram &student, const QString &folder,
                           const ProgramLimits &limits)
    : m_file(QFile::encodeName(student.path))
    , m_folder(QFile::encodeName(folder))
    , m_arguments(QStringList{student.path} + student.arguments)
    , m_environment({QStringLiteral("PATH=/usr/local/bin:/usr/bin:/bin"),
                     QStringLiteral("LC_ALL=C.UTF-8"), QStringLiteral("HOME=") + folder,
                     QStringLiteral("TMPDIR=") + folder})
{
    const uid_t user = userOfRun();
    const bool isOwnUser = user != geteuid();
    const gid_t group = isOwnUser ? user : getegid();
    m_folderOptions = QStringLiteral("size=%1,nr_inodes=4096,mode=0700,uid=%2,gid=%3")
                          .arg(limits.files)
                          .arg(user)
                          .arg(group)
                          .toLatin1();
    m_userMap = QStringLiteral("%1 %1 1").arg(user).toLatin1();
    m_groupMap = QStringLiteral("%1 %1 1").arg(group).toLatin1();
    m_plan.file = m_file.constData();
    m_plan.arguments = m_arguments.pointers();
    m_plan.environment = m_environment.pointers();
    m_plan.folder = m_folder.constData();
    m_plan.folderOptions = m_folderOptions.constData();
    m_plan.userMap = m_userMap.constData();
    m_plan.groupMap = m_groupMap.constData();
    m_plan.user = user;
    m_plan.group = group;
    m_plan.limits = resourceLimits(limits);
    m_plan.processes = rlim_t(limits.processes);
    m_plan.otherProcesses = isOwnUser ? 0 : presentProcesses();
}

} // namespace pixelplumb
