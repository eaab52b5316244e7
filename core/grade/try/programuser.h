// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <sys/types.h>

namespace pixelplumb {

/// The user that someone else's program runs as: the one who started it or, if that is root with
/// its capabilities, a separate user for each run, who owns nothing, whose processes are counted
/// separately and cannot signal root's.
struct ProgramUser {
    uid_t id = 0;
    bool isOwn = false;

    static ProgramUser ofNextRun();

    /// The words in front of a program by which root becomes that user; empty without a change.
    /// Root's capabilities decide what may be started; they are then dropped except one for
    /// reading, since the program could not read itself in a folder of root's.
    QStringList command() const;
    /// The names of the capabilities that this needs.
    static QStringList capabilities();
};

} // namespace pixelplumb
