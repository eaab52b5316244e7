// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <chrono>

namespace pixelplumb {

/// How long a process and all that came of it have computed, those among them that have ended and
/// were waited for; as /proc tells, in ticks of its clock (10 ms). 0 where it tells nothing.
std::chrono::milliseconds computedBy(pid_t ancestor);

} // namespace pixelplumb
