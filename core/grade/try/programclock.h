// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/try/programrun.h"

#include <optional>

namespace pixelplumb {

/// Why a program that the kernel does not end is ended.
struct LateEnd {
    bool isByClock = false;
    QString told; ///< a sentence
};

/// Looks at a program after each wall time of its limits. The kernel ends programs that compute, by
/// their own processor time, however busy the machine is; the clock ends programs that wait. Two
/// distant limits end those that escape the kernel by starting one process after another.
class ProgramClock {
public:
    using Clock = std::chrono::steady_clock;

    ProgramClock(const ProgramLimits &limits, Clock::time_point start);

    Clock::time_point nextLook() const { return m_nextLook; }
    /// Given how long the program and its descendants have computed by now: the program may go on
    /// until the next look, or is ended.
    std::optional<LateEnd> look(std::chrono::milliseconds computed, Clock::time_point now);

private:
    ProgramLimits m_limits;
    Clock::time_point m_start, m_nextLook;
    std::chrono::milliseconds m_computedBefore{0}; ///< at the last look
};

/// The signal that ended a program, from its waitpid() status; a program that started it reports it
/// by an exit code from 129 on, as shells do. 0: none.
int signalIn(int status);

/// Whether it ended as the kernel ends a program that computes too long, or as a shell that ran
/// one. A program that ignores SIGXCPU gets SIGKILL. The kernel's limit counts clock ticks, which
/// on a busy machine differ widely from the time it reports later, `computed`; half of the limit is
/// enough to exclude programs that send themselves such a signal.
bool hasComputedTooLong(int status, std::chrono::milliseconds computed,
                        const ProgramLimits &limits);

} // namespace pixelplumb
