// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <sys/types.h>

#include <chrono>

namespace pixelplumb {

/// How long a process and its descendants have computed, including those that have ended and were
/// waited for; from /proc, in ticks of its clock (10 ms). 0 where it reports nothing.
std::chrono::milliseconds computedBy(pid_t ancestor);

/// The content of a file in /proc; empty where it cannot be read.
QByteArray procText(const QString &path);

} // namespace pixelplumb
