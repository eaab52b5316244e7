// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <sys/types.h>

#include <chrono>

namespace pixelplumb {

/// How long a process and all that came of it have computed, those among them that have ended and
/// were waited for; as /proc tells, in ticks of its clock (10 ms). 0 where it tells nothing.
std::chrono::milliseconds computedBy(pid_t ancestor);

/// The text of a file of /proc; empty where it cannot be read.
QByteArray procText(const QString &path);

} // namespace pixelplumb
