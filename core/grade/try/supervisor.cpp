// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/supervisor.h"

#include <fcntl.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <limits>

namespace pixelplumb {

namespace {

constexpr int lookedAfter = 50; // ms between two checks for orphans
constexpr int killingRounds = 5000; // of one millisecond each

void tell(const SupervisedStart &start, SupervisorNews news, int value)
{
    const SupervisorRecord record{news, value};
    [[maybe_unused]] const ssize_t written = ::write(start.report, &record, sizeof record);
}

long millisecondsOf(const rusage &used)
{
    const auto inAll = [](const timeval &time) { return time.tv_sec * 1000 + time.tv_usec / 1000; };
    return inAll(used.ru_utime) + inAll(used.ru_stime);
}

/// Closes the pipes of other runs, which must not stay open here.
void closeAllBut(std::array<int, 6> kept)
{
    std::sort(kept.begin(), kept.end());
    unsigned first = STDERR_FILENO + 1;
    for (const int descriptor : kept) {
        if (descriptor < int(first))
            continue;
        if (unsigned(descriptor) > first)
            close_range(first, unsigned(descriptor) - 1, 0);
        first = unsigned(descriptor) + 1;
    }
    close_range(first, ~0U, 0);
}

[[noreturn]] void startProgram(const SupervisedStart &start)
{
    for (int signal = 1; signal < NSIG; ++signal)
        ::signal(signal, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    setpgid(0, 0);
    umask(S_IWGRP | S_IWOTH);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (start.passedOn >= 0)
        fcntl(start.passedOn, F_SETFD, 0);
    else // bubblewrap does so itself
        prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    const bool isReady = chdir(start.folder) == 0 && dup2(start.input, STDIN_FILENO) >= 0
        && dup2(start.output, STDOUT_FILENO) >= 0 && dup2(start.messages, STDERR_FILENO) >= 0
        && (!start.filter || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, start.filter) == 0);
    if (isReady)
        execve(start.command[0], start.command, start.environment);
    tell(start, SupervisorNews::NotStarted, errno);
    _exit(127);
}

/// Waits for processes that have ended.
class Reaper {
public:
    explicit Reaper(pid_t program)
        : m_program(program)
    {
    }

    /// True when no children are left.
    bool reap()
    {
        pid_t reaped = 0;
        int status = 0;
        rusage used = {};
        while ((reaped = wait4(-1, &status, WNOHANG, &used)) > 0) {
            m_computed += millisecondsOf(used);
            if (reaped == m_program) {
                m_hasEnded = true;
                m_status = status;
            }
        }
        return reaped < 0 && errno == ECHILD;
    }
    bool hasEnded() const { return m_hasEnded; } ///< whether the program has
    int status() const { return m_status; }
    /// The computing time of all that have ended, ms.
    int computed() const
    {
        return int(std::min<long>(m_computed, std::numeric_limits<int>::max()));
    }

private:
    pid_t m_program;
    bool m_hasEnded = false;
    int m_status = 0;
    long m_computed = 0;
};

/// Kills the children that the kernel lists; their own children then become ours, and are killed
/// next.
void killChildren()
{
    const int list = open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
    if (list < 0)
        return;
    std::array<char, 4096> text;
    const ssize_t length = ::read(list, text.data(), text.size());
    close(list);
    pid_t child = 0;
    for (ssize_t i = 0; i < length; ++i) {
        const char character = text[std::size_t(i)];
        if (character >= '0' && character <= '9') {
            child = child * 10 + (character - '0');
        } else {
            if (child > 0)
                kill(child, SIGKILL);
            child = 0;
        }
    }
}

void killAll(pid_t program, Reaper &reaper)
{
    kill(-program, SIGKILL);
    for (int round = 0; round < killingRounds && !reaper.reap(); ++round) {
        killChildren();
        poll(nullptr, 0, 1);
    }
}

/// Waits for the program's end, or for the other side of `control` to close.
void watch(const SupervisedStart &start, pid_t program, Reaper &reaper)
{
    const int handle = int(syscall(SYS_pidfd_open, program, 0)); // poll ignores -1
    std::array<pollfd, 2> awaited = {{{start.control, 0, 0}, {handle, POLLIN, 0}}};
    while (!reaper.hasEnded() && awaited[0].revents == 0) {
        poll(awaited.data(), awaited.size(), lookedAfter);
        reaper.reap();
    }
    if (reaper.hasEnded())
        tell(start, SupervisorNews::Ended, reaper.status());
}

/// Locks the new folder and gives it to its owner. False if it cannot; errno says why.
bool ownFolder(const SupervisedStart &start)
{
    // It stays open, and with it the lock, until the supervisor is gone.
    const int folder = open(start.folder, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    return folder >= 0 && flock(folder, LOCK_EX | LOCK_NB) == 0
        && (start.folderOwner == geteuid()
            || fchown(folder, start.folderOwner, start.folderOwner) == 0);
}

/// Runs the removal even if the process that started everything is gone.
void runRemoval(const SupervisedStart &start)
{
    if (!start.removal)
        return;
    const pid_t remover = fork();
    if (remover == 0) {
        execve(start.removal[0], start.removal, start.environment);
        _exit(127);
    }
    while (waitpid(remover, nullptr, 0) < 0 && errno == EINTR) { }
}

} // namespace

void supervise(const SupervisedStart &start)
{
    setsid();
    ::signal(SIGPIPE, SIG_IGN); // if our parent is gone, nobody reads the reports
    closeAllBut(
        {start.input, start.output, start.messages, start.passedOn, start.control, start.report});
    prctl(PR_SET_DUMPABLE, 0, 0, 0, 0); // the program must not read its supervisor's memory
    prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
    if (start.makesFolder && mkdir(start.folder, S_IRWXU) != 0) {
        tell(start, SupervisorNews::NotStarted, errno);
        _exit(0);
    }
    const bool isReady = !start.makesFolder || ownFolder(start);
    const pid_t program = isReady ? fork() : -1;
    if (program == 0)
        startProgram(start);
    close(start.output);
    close(start.messages);
    if (program < 0) {
        tell(start, SupervisorNews::NotStarted, errno);
    } else {
        Reaper reaper(program);
        watch(start, program, reaper);
        killAll(program, reaper);
        tell(start, SupervisorNews::Computed, reaper.computed());
    }
    runRemoval(start);
    _exit(0);
}

} // namespace pixelplumb
