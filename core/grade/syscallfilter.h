// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace pixelplumb {

/// What a program that nobody trusts may not ask of the kernel, for seccomp(2): an array of
/// sock_filter, made once. It takes away memory that belongs to no process, namespaces of its own,
/// devices and protocols that namespaces do not separate, input for terminals, and signals to
/// everybody. Who asks all the same is told that it may not, or that there is no such call, and
/// goes on. Empty where no such program can be made.
const QByteArray &syscallFilter();

} // namespace pixelplumb
