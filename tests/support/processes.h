// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

/// What the tests of programs of others share: which processes there are.
namespace pixelplumb {

/// How many processes of the whole system have a word among their arguments.
int processesWith(const QByteArray &word);

/// Seconds to sleep that no other process names.
QByteArray unusualSeconds();

} // namespace pixelplumb
