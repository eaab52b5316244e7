// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"

namespace pixelplumb::cli {

// One function per command, each in its own file.
ExitCode render(const Command &command, const QStringList &arguments);
ExitCode trace(const Command &command, const QStringList &arguments);
ExitCode pixel(const Command &command, const QStringList &arguments);
ExitCode listMethods(const Command &command, const QStringList &arguments);
ExitCode plan(const Command &command, const QStringList &arguments);
ExitCode check(const Command &command, const QStringList &arguments);
ExitCode diagnose(const Command &command, const QStringList &arguments);
ExitCode grade(const Command &command, const QStringList &arguments);
ExitCode invariants(const Command &command, const QStringList &arguments);
ExitCode counterExample(const Command &command, const QStringList &arguments);
ExitCode diff(const Command &command, const QStringList &arguments);
ExitCode tryProgram(const Command &command, const QStringList &arguments);
ExitCode motion(const Command &command, const QStringList &arguments);
ExitCode compare(const Command &command, const QStringList &arguments);
ExitCode lab(const Command &command, const QStringList &arguments);
ExitCode help(const Command &command, const QStringList &arguments);

} // namespace pixelplumb::cli
