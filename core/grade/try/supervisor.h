// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <linux/filter.h>
#include <sys/types.h>

namespace pixelplumb {

/// What a supervisor reports through its pipe; each record is two integers.
enum class SupervisorNews : int {
    NotStarted, ///< value: the error of the failed system call
    Ended, ///< value: the waitpid() status
    Computed, ///< value: computing time of all processes, ms; sent when they are gone
};

struct SupervisorRecord {
    SupervisorNews news = SupervisorNews::NotStarted;
    int value = 0;
};

/// A program's words, which end with a null pointer; none: null.
using ArgumentPointers = char *const *;

/// Everything needed to start a program, made before the fork: between fork and start nothing may
/// be allocated.
struct SupervisedStart {
    ArgumentPointers command = nullptr; ///< its first word is an absolute path
    ArgumentPointers environment = nullptr;
    const char *folder = nullptr; ///< where it starts
    /// Whether the supervisor makes the folder first, for this user, and holds a lock on it. It
    /// does so, since what its own parent made would be left by a signal that ends the parent
    /// before the fork.
    bool makesFolder = false;
    uid_t folderOwner = 0;
    ArgumentPointers removal = nullptr; ///< a command to run when all processes are gone
    const sock_fprog *filter = nullptr; ///< of system calls, for the program and all its
                                        ///< descendants
    // Descriptors. The supervisor ends everything when the other side of `control` is closed;
    // `passedOn` stays open in the program under its number.
    int input = -1, output = -1, messages = -1, passedOn = -1, control = -1, report = -1;
};

/// Call it in a newly forked child; it uses only async-signal-safe calls. Starts the program, waits
/// for its end or for an order to end it, and exits when all its descendants are gone, including
/// those with a session of their own.
[[noreturn]] void supervise(const SupervisedStart &start);

} // namespace pixelplumb
