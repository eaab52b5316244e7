// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace pixelplumb {

/// Does jobs 0 … count − 1, each once, in the calling thread and up to `threads` − 1 more, and
/// returns when all are done. The jobs throw nothing and share none themselves. The threads
/// begin at places as far apart as can be and go on from there: neighbours share cache lines.
///
/// The threads are kept until the process ends, since to start and to join one takes some 100 µs;
/// who calls while they work for another waits. They are handed over by the standard library's
/// semaphores, which a race detector sees through.
void shareJobs(int threads, int count, const std::function<void(int job)> &job);

} // namespace pixelplumb
