// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/programclock.h"

#include <sys/wait.h>

#include <csignal>

namespace pixelplumb {

namespace {

constexpr int waitingShare = 64; // computing less than 1/64 of the time limit counts as waiting
constexpr int timesByClock = 64; // however much it computes

} // namespace

ProgramClock::ProgramClock(const ProgramLimits &limits, Clock::time_point start)
    : m_limits(limits)
    , m_start(start)
    , m_nextLook(start + limits.wallTime())
{
}

std::optional<LateEnd> ProgramClock::look(std::chrono::milliseconds computed, Clock::time_point now)
{
    const std::chrono::seconds own(m_limits.wholeSeconds());
    if (computed >= m_limits.timesInAll * own)
        return LateEnd{false,
                       u"it was ended after %1 s of computing in all its processes"_s.arg(
                           (m_limits.timesInAll * own).count())};
    // The number of earlier looks depends on the machine's load, so it is not reported.
    if (waitingShare * (computed - m_computedBefore) < own)
        return LateEnd{true,
                       u"it was ended by the clock: for %1 s it was not seen to compute"_s.arg(
                           double(m_limits.wallTime().count()) / 1000)};
    if (now >= m_start + timesByClock * own)
        return LateEnd{true,
                       u"it was ended after %1 s by the clock"_s.arg((timesByClock * own).count())};
    m_computedBefore = computed;
    m_nextLook = now + m_limits.wallTime();
    return std::nullopt;
}

int signalIn(int status)
{
    constexpr int ofShells = 128;
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status) - ofShells;
    return signal > 0 && signal < NSIG ? signal : 0;
}

bool hasComputedTooLong(int status, std::chrono::milliseconds computed, const ProgramLimits &limits)
{
    const int signal = signalIn(status);
    return (signal == SIGXCPU || signal == SIGKILL)
        && 2 * computed >= std::chrono::seconds(limits.wholeSeconds());
}

} // namespace pixelplumb
