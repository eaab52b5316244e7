// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <array>

namespace pixelplumb {

/// What a supervisor tells through its pipe; each is a record of two integers.
enum class SupervisorNews : int {
    Isolated, ///< the program has namespaces of its own: its files and its network are bounded
    NotStarted, ///< the error of the system call that failed
    Computed, ///< how long it did, with the children that it waited for, ms; before its end
    Ended, ///< the status as of waitpid
};

struct SupervisorRecord {
    SupervisorNews news = SupervisorNews::NotStarted;
    int value = 0;
};

struct ResourceLimit {
    int resource = 0; ///< RLIMIT_…
    rlim_t value = 0;
};

/// All that is needed to start a program, made before the fork: between that and the start nothing
/// may be allocated.
struct SupervisedStart {
    const char *file = nullptr;
    char *const *arguments = nullptr;
    char *const *environment = nullptr;
    const char *folder = nullptr; ///< empty, and its own
    const char *folderOptions = nullptr; ///< of the tmpfs that takes its place in the sandbox
    const char *userMap = nullptr; ///< as /proc/self/uid_map wants it
    const char *groupMap = nullptr;
    uid_t user = 0; ///< whom it runs as: another than the caller only where that is root
    gid_t group = 0;
    std::array<ResourceLimit, 6> limits = {};
    rlim_t processes = 0; ///< at a time
    /// How many its user may have beside them, which are counted where it has no
    /// namespace of users.
    rlim_t otherProcesses = 0;
    // Descriptors. The supervisor ends everything when the other side of `control` is closed.
    int input = -1, output = -1, messages = -1, control = -1, report = -1;
};

/// To be called in a child just forked; calls nothing that is not async-signal-safe. Starts the
/// program, waits for its end, or to be told, and leaves when every process that came of it is
/// gone, also those that made themselves a session.
[[noreturn]] void supervise(const SupervisedStart &start);

} // namespace pixelplumb
