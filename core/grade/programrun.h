// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/sandbox.h"
#include "core/grade/studentprogram.h"
#include "core/scene/result.h"

#include <QByteArray>
#include <QStringList>

#include <chrono>
#include <cstdint>
#include <stop_token>

namespace pixelplumb {

/// What bubblewrap, which starts it, runs in: it needs 4, an interpreter more.
inline constexpr int leastMegabytes = 16;
inline constexpr int mostMegabytes = 1 << 20;

/// What a student's program may use. In bytes, but for the time and the number of processes.
struct ProgramLimits {
    std::chrono::milliseconds time{10'000}; ///< of computing, in whole seconds, for each process
    /// By the clock on the wall: who computes nearly nothing for so long waits for what never
    /// comes.
    std::chrono::milliseconds wallTime() const { return clockTimes * time; }
    int clockTimes = 4; ///< so many times as long as of computing
    int timesInAll = 16; ///< so many times as long may all processes together compute
    std::int64_t wholeSeconds() const
    {
        return std::chrono::ceil<std::chrono::seconds>(time).count();
    }
    std::int64_t memory = std::int64_t(1) << 30; ///< addresses of each process; 0: no limit
    std::int64_t output = std::int64_t(64) << 20; ///< stdout and stderr together
    std::int64_t files = std::int64_t(64) << 20; ///< in /tmp; without sandbox: each file
    std::int64_t processes = 64; ///< processes and threads at a time
};

enum class ProgramEnd {
    Finished, ///< exit code 0
    Failed, ///< another exit code
    Crashed, ///< by a signal
    TimedOut,
    Flooded, ///< wrote more than it may
    NotStarted,
    Cancelled, ///< by us
};
QString nameOf(ProgramEnd end);

/// How a student's program ended and what it wrote: bytes that nobody has looked at yet.
struct StudentRun {
    ProgramEnd end = ProgramEnd::NotStarted;
    int code = 0; ///< the exit code where it failed, the signal where it crashed
    QByteArray output;
    QByteArray messages; ///< of stderr the first 64 KiB
    QString sandboxLack; ///< why it ran in no sandbox; empty: in one
    bool isByClock = false; ///< where it timed out: it had waited, not computed
    bool isInAll = false; ///< where it timed out: all its processes together had computed too long
    QString told; ///< a sentence: how it ended

    bool isSandboxed() const { return sandboxLack.isEmpty(); }
};

/// Runs it in an empty folder, which is removed afterwards, with a bare environment and the input
/// as stdin, and returns when it and every process that it started are gone. In the sandbox it sees
/// what programs need to run, the files that it is shown and nobody else; with limits alone it may
/// do what the one may as whom it runs: who started it, or, where that is root, a user of its own.
/// Several can run at once, each in a thread of its own.
StudentRun runProgram(const StudentProgram &student, const QByteArray &input,
                      const ProgramLimits &limits = {}, const std::stop_token &stop = {},
                      Confinement confinement = bestConfinement());

} // namespace pixelplumb
