// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/supervisor.h"

#include <fcntl.h>
#include <linux/capability.h>
#include <linux/securebits.h>
#include <poll.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <limits>

namespace pixelplumb {

namespace {

constexpr int lookedAfter = 50; // ms between two looks for orphans
constexpr int killingRounds = 5000; // of a millisecond

void tell(const SupervisedStart &start, SupervisorNews news, int value)
{
    const SupervisorRecord record{news, value};
    [[maybe_unused]] const ssize_t written = ::write(start.report, &record, sizeof record);
}

int millisecondsOf(const rusage &used)
{
    const auto inAll = [](const timeval &time) { return time.tv_sec * 1000 + time.tv_usec / 1000; };
    return int(std::min<long>(inAll(used.ru_utime) + inAll(used.ru_stime),
                              std::numeric_limits<int>::max()));
}

/// Pipes of other runs must not be held open here.
void closeAllBut(std::array<int, 5> kept)
{
    std::sort(kept.begin(), kept.end());
    unsigned first = STDERR_FILENO + 1;
    for (const int descriptor : kept) {
        if (unsigned(descriptor) > first)
            close_range(first, unsigned(descriptor) - 1, 0);
        first = std::max(first, unsigned(descriptor) + 1);
    }
    close_range(first, ~0U, 0);
}

void writeTo(const char *path, const char *text)
{
    const int file = open(path, O_WRONLY | O_CLOEXEC);
    [[maybe_unused]] const ssize_t written = ::write(file, text, std::strlen(text));
    close(file);
}

/// Namespaces of processes, mounts, network and messages. Whoever is not root has to have a
/// namespace of users for that, in which it is who it was.
bool entersNamespaces(const SupervisedStart &start)
{
    constexpr int spaces = CLONE_NEWPID | CLONE_NEWNS | CLONE_NEWNET | CLONE_NEWIPC;
    if (geteuid() == 0)
        return unshare(spaces) == 0;
    if (unshare(spaces | CLONE_NEWUSER) != 0)
        return false;
    writeTo("/proc/self/setgroups", "deny");
    writeTo("/proc/self/uid_map", start.userMap);
    writeTo("/proc/self/gid_map", start.groupMap);
    return true;
}

/// All files can be read only; its folder is a bounded one in memory, which goes with it. Sockets
/// are no files: those by which desktops and services are spoken to are hidden.
bool closesFiles(const SupervisedStart &start)
{
    if (mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0)
        return false;
    constexpr unsigned long bare = MS_NOSUID | MS_NODEV;
    mount("proc", "/proc", "proc", bare | MS_NOEXEC, nullptr); // else the old one, to be read only
    for (const char *sockets : {"/run", "/tmp/.X11-unix", "/tmp/.ICE-unix"}) // or none is there
        mount("tmpfs", sockets, "tmpfs", bare | MS_RDONLY, "mode=0755");
    mount_attr readOnly = {};
    readOnly.attr_set = MOUNT_ATTR_RDONLY | MOUNT_ATTR_NOSUID;
    return mount_setattr(AT_FDCWD, "/", AT_RECURSIVE, &readOnly, sizeof readOnly) == 0
        && mount("tmpfs", start.folder, "tmpfs", bare, start.folderOptions) == 0;
}

void setLimit(const ResourceLimit &limit)
{
    rlimit present = {};
    if (getrlimit(__rlimit_resource(limit.resource), &present) != 0)
        return;
    const rlim_t least = std::min(limit.value, present.rlim_max);
    // Who has computed enough is told first, so that its end can be told from others, then killed.
    const bool isTold = limit.resource == RLIMIT_CPU && least < present.rlim_max;
    present = {least, isTold ? least + 1 : least};
    setrlimit(__rlimit_resource(limit.resource), &present);
}

/// Root becomes a user that has nothing, so that the limit on processes binds and no file of
/// another can be written to; where there is no such user it keeps its name but no power. It may
/// read on, or it could not read itself in a folder of root's.
void leaveRoot(const SupervisedStart &start)
{
    if (geteuid() != 0)
        return;
    prctl(PR_SET_SECUREBITS, SECBIT_NOROOT | SECBIT_NOROOT_LOCKED);
    if (start.user != 0) {
        [[maybe_unused]] const int owned = chown(start.folder, start.user, start.group);
        syscall(SYS_setgroups, 0, nullptr);
        prctl(PR_SET_KEEPCAPS, 1);
        syscall(SYS_setresgid, start.group, start.group, start.group);
        syscall(SYS_setresuid, start.user, start.user, start.user);
    }
    // What may be started is asked before the start, and what may be done is taken away by it.
    constexpr __u32 reads = 1U << CAP_DAC_READ_SEARCH;
    constexpr __u32 starts = reads | 1U << CAP_DAC_OVERRIDE;
    __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct data[2] = {};
    syscall(SYS_capget, &header, data);
    data[0].permitted &= starts;
    data[0].effective = data[0].permitted;
    data[0].inheritable = data[0].permitted & reads;
    data[1] = {};
    syscall(SYS_capset, &header, data);
    prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_RAISE, CAP_DAC_READ_SEARCH, 0, 0);
}

[[noreturn]] void startProgram(const SupervisedStart &start, rlim_t processes)
{
    for (int signal = 1; signal < NSIG; ++signal)
        ::signal(signal, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    setpgid(0, 0);
    umask(S_IWGRP | S_IWOTH);
    leaveRoot(start);
    for (const ResourceLimit &limit : start.limits)
        setLimit(limit);
    setLimit({RLIMIT_NPROC, processes});
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    if (chdir(start.folder) == 0 && dup2(start.input, STDIN_FILENO) >= 0
        && dup2(start.output, STDOUT_FILENO) >= 0 && dup2(start.messages, STDERR_FILENO) >= 0)
        execve(start.file, start.arguments, start.environment);
    tell(start, SupervisorNews::NotStarted, errno);
    _exit(127);
}

/// Reaps who has ended; true when nobody is left.
bool isAlone()
{
    pid_t reaped = 0;
    while ((reaped = waitpid(-1, nullptr, WNOHANG)) > 0) { }
    return reaped < 0 && errno == ECHILD;
}

/// Kills the children that the kernel lists; those of the killed become ours, and are next.
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

void killAll(pid_t program)
{
    if (getpid() == 1) { // of a namespace of our own
        kill(-1, SIGKILL);
        return;
    }
    kill(-program, SIGKILL);
    for (int round = 0; round < killingRounds && !isAlone(); ++round) {
        killChildren();
        poll(nullptr, 0, 1);
    }
}

/// Waits for the program's end, or for the other side of `control` to be closed.
void watch(const SupervisedStart &start, pid_t program)
{
    const int handle = int(syscall(SYS_pidfd_open, program, 0)); // -1 is passed over by poll
    std::array<pollfd, 2> awaited = {{{start.control, 0, 0}, {handle, POLLIN, 0}}};
    for (;;) {
        poll(awaited.data(), awaited.size(), lookedAfter);
        int status = 0;
        pid_t ended = 0;
        rusage used = {};
        while ((ended = wait4(-1, &status, WNOHANG, &used)) > 0) {
            if (ended == program) {
                tell(start, SupervisorNews::Computed, millisecondsOf(used));
                tell(start, SupervisorNews::Ended, status);
                return;
            }
        }
        if (awaited[0].revents != 0)
            return;
    }
}

} // namespace

void supervise(const SupervisedStart &start)
{
    setsid();
    closeAllBut({start.input, start.output, start.messages, start.control, start.report});
    const bool isApart = entersNamespaces(start);
    const bool hasOwnUsers = isApart && geteuid() != 0;
    prctl(PR_SET_DUMPABLE, 0, 0, 0, 0); // the program may not look into its supervisor
    if (isApart) {
        // Who is the first in a namespace of processes takes all others with it.
        const pid_t first = fork();
        if (first != 0) {
            close(start.output);
            close(start.messages);
            while (waitpid(first, nullptr, 0) < 0 && errno == EINTR) { }
            _exit(0);
        }
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (closesFiles(start))
            tell(start, SupervisorNews::Isolated, 0);
    }
    prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
    const pid_t program = fork();
    if (program == 0)
        startProgram(start, start.processes + (hasOwnUsers ? 0 : start.otherProcesses));
    close(start.output);
    close(start.messages);
    if (program < 0) {
        tell(start, SupervisorNews::NotStarted, errno);
        _exit(0);
    }
    watch(start, program);
    killAll(program);
    _exit(0);
}

} // namespace pixelplumb
