// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace pixelplumb {

/// The seccomp(2) filter for untrusted programs: an array of sock_filter, made once. It denies
/// memory that belongs to no process, new namespaces, devices and protocols that namespaces do not
/// separate, input for terminals, and signals to everybody. A denied call fails as not permitted or
/// not existing, and the program goes on. Empty where no filter can be made.
const QByteArray &syscallFilter();

} // namespace pixelplumb
