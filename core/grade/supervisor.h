// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <linux/filter.h>

namespace pixelplumb {

/// What a supervisor tells through its pipe; each is a record of two integers.
enum class SupervisorNews : int {
    NotStarted, ///< the error of the system call that failed
    Ended, ///< the status as of waitpid
    Computed, ///< how long all that came of it did, ms; when they are gone
};

struct SupervisorRecord {
    SupervisorNews news = SupervisorNews::NotStarted;
    int value = 0;
};

/// A program's words, which end with a null pointer; none: null.
using ArgumentPointers = char *const *;

/// All that is needed to start a program, made before the fork: between that and the start nothing
/// may be allocated.
struct SupervisedStart {
    ArgumentPointers command = nullptr; ///< its first word is a whole path
    ArgumentPointers environment = nullptr;
    const char *folder = nullptr; ///< in which it starts
    ArgumentPointers removal = nullptr; ///< a command to be run when all processes are gone
    const sock_fprog *filter = nullptr; ///< of system calls, for itself and all that come of it
    // Descriptors. The supervisor ends everything when the other side of `control` is closed; what
    // is passed on stays open in the program under its number.
    int input = -1, output = -1, messages = -1, passedOn = -1, control = -1, report = -1;
};

/// To be called in a child just forked; calls nothing that is not async-signal-safe. Starts the
/// program, waits for its end, or to be told, and leaves when every process that came of it is
/// gone, also those that made themselves a session.
[[noreturn]] void supervise(const SupervisedStart &start);

} // namespace pixelplumb
