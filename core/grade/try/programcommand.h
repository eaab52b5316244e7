// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/try/programrun.h"

namespace pixelplumb {

struct ProgramUser;

/// The words that start a student's program within its limits, as that user, in any folder: those
/// of prlimit and setpriv.
QStringList limitedCommand(const StudentProgram &student, const ProgramLimits &limits,
                           const ProgramUser &user);
/// Like limitedCommand(), in the sandbox: preceded by bubblewrap's words. `filter` is a descriptor,
/// open at the start, of a file that holds syscallFilter().
QStringList sandboxedCommand(const StudentProgram &student, const ProgramLimits &limits,
                             const ProgramUser &user, int filter);

/// The path of bubblewrap; empty: not installed.
QString bubblewrapPath();

/// The only writable folder in the sandbox, initially empty.
QString sandboxFolder();

/// The error that one of these tools printed before it gave up, judged by the exit code and stderr;
/// empty where they started the program.
QString faultOfStart(int exitCode, const QByteArray &messages);

} // namespace pixelplumb
