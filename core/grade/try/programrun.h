// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/try/sandbox.h"
#include "core/grade/try/studentprogram.h"
#include "core/scene/text/result.h"

#include <QByteArray>
#include <QStringList>

#include <chrono>
#include <cstdint>
#include <stop_token>

namespace pixelplumb {

/// What bubblewrap, which starts the program, runs in: it needs 4 MB, an interpreter more.
inline constexpr int leastMegabytes = 16;
inline constexpr int mostMegabytes = 1 << 20;

/// What a student's program may use, in bytes except for time and processes.
struct ProgramLimits {
    std::chrono::milliseconds time{10'000}; ///< computing time of each process, in whole seconds
    /// Wall-clock time: a program that computes almost nothing for this long waits for something
    /// that never comes.
    std::chrono::milliseconds wallTime() const { return clockTimes * time; }
    int clockTimes = 4; ///< wall-clock time as a multiple of computing time
    int timesInAll = 16; ///< computing time of all processes together, as a multiple of one's
    std::int64_t wholeSeconds() const
    {
        return std::chrono::ceil<std::chrono::seconds>(time).count();
    }
    std::int64_t memory = std::int64_t(1) << 30; ///< address space of each process; 0: no limit
    std::int64_t output = std::int64_t(64) << 20; ///< stdout and stderr together
    std::int64_t files = std::int64_t(64) << 20; ///< in /tmp; without a sandbox: each file
    std::int64_t processes = 64; ///< processes and threads at one time
};

enum class ProgramEnd {
    Finished, ///< exit code 0
    Failed, ///< another exit code
    Crashed, ///< by a signal
    TimedOut,
    Flooded, ///< wrote more than allowed
    NotStarted,
    Cancelled, ///< by us
};
QString nameOf(ProgramEnd end);

/// How a student's program ended, and the unchecked bytes it wrote.
struct StudentRun {
    ProgramEnd end = ProgramEnd::NotStarted;
    int code = 0; ///< the exit code if it failed, the signal if it crashed
    QByteArray output;
    QByteArray messages; ///< the first 64 KiB of stderr
    QString sandboxLack; ///< why it ran without a sandbox; empty: it ran in one
    bool isByClock = false; ///< if it timed out: it had waited, not computed
    bool isInAll = false; ///< if it timed out: its processes together had computed too long
    QString told; ///< a sentence on how it ended

    bool isSandboxed() const { return sandboxLack.isEmpty(); }
};

/// Runs a program in an empty folder, removed afterwards, with a minimal environment and the input
/// as stdin; returns when it and every process that it started are gone. In the sandbox it sees
/// only what programs need to run and the files it is shown. With limits alone it may do whatever
/// its user may: the one who started it or, if that is root, a user of its own. Several can run at
/// once, each in its own thread.
StudentRun runProgram(const StudentProgram &student, const QByteArray &input,
                      const ProgramLimits &limits = {}, const std::stop_token &stop = {},
                      Confinement confinement = bestConfinement());

} // namespace pixelplumb
