// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/programrun.h"

namespace pixelplumb {

struct ProgramUser;

/// The words that start a student's program within its limits, as that user, wherever it stands:
/// those of prlimit and setpriv.
QStringList limitedCommand(const StudentProgram &student, const ProgramLimits &limits,
                           const ProgramUser &user);
/// The same in the sandbox: those of bubblewrap before them. `filter` is a descriptor, open at the
/// start, of a file that holds syscallFilter().
QStringList sandboxedCommand(const StudentProgram &student, const ProgramLimits &limits,
                             const ProgramUser &user, int filter);

/// Where bubblewrap is; empty: it is not installed.
QString bubblewrapPath();

/// The only folder in the sandbox that can be written to, empty at first.
QString sandboxFolder();

/// What one of these tools said before it gave up, by the exit code and what stands on stderr;
/// empty where they started the program.
QString faultOfStart(int exitCode, const QByteArray &messages);

} // namespace pixelplumb
