// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

/// Shared helpers of the tests that run foreign programs: which processes exist.
namespace pixelplumb {

/// The number of processes on the whole system that have this word among their arguments.
int processesWith(const QByteArray &word);

/// A number of seconds to sleep that no other process uses.
QByteArray unusualSeconds();

} // namespace pixelplumb
