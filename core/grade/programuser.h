// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <sys/types.h>

namespace pixelplumb {

/// Whom a program of others runs as: who started it or, where that is root with its powers, a user
/// of its own for each run, who owns nothing, whose processes are counted by themselves and cannot
/// send signals to root's.
struct ProgramUser {
    uid_t id = 0;
    bool isOwn = false;

    static ProgramUser ofNextRun();

    /// The words right before a program by which root becomes that user; empty where it stays who
    /// it is. What may be started is asked with root's power, and then that is taken away but for
    /// one, to read on: the program could not read itself in a folder of root's.
    QStringList command() const;
    /// The names of the powers that this takes.
    static QStringList capabilities();
};

} // namespace pixelplumb
