// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/programrun.h"

#include <optional>

namespace pixelplumb {

/// Why a program is ended that the kernel does not end.
struct LateEnd {
    bool isByClock = false;
    QString told; ///< a sentence
};

/// Looks at a program from time to time, each wall time of its limits. Who computes is ended by the
/// kernel, by its own processor time alone, however many others the machine serves; the clock ends
/// who waits. For those that the kernel does not end, who start one process after another, there
/// are two ends far off.
class ProgramClock {
public:
    using Clock = std::chrono::steady_clock;

    ProgramClock(const ProgramLimits &limits, Clock::time_point start);

    Clock::time_point nextLook() const { return m_nextLook; }
    /// What it and all that came of it have computed by now is looked at: it may go on, until the
    /// next look, or is ended.
    std::optional<LateEnd> look(std::chrono::milliseconds computed, Clock::time_point now);

private:
    ProgramLimits m_limits;
    Clock::time_point m_start, m_nextLook;
    std::chrono::milliseconds m_computedBefore{0}; ///< at the last look
};

/// The signal that ended a program, by its status as of waitpid: what started it says so by an exit
/// code from 129 on, as shells do. 0: none did.
int signalIn(int status);

/// Whether it ended as the kernel ends who computes too long, or as a shell does that ran such a
/// one. Who does not heed SIGXCPU gets SIGKILL. The kernel ends it by a count in ticks of its
/// clock, which on a busy machine is far from what it tells afterwards, `computed`: half of the
/// limit tells it from whoever sends itself such a signal.
bool hasComputedTooLong(int status, std::chrono::milliseconds computed,
                        const ProgramLimits &limits);

} // namespace pixelplumb
