// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace pixelplumb {

/// Does jobs 0 … count − 1, each once, in the calling thread and `threads` − 1 more, and returns
/// when all are done; fewer threads where the system has none left. The jobs throw nothing. Threads
/// of the standard library, which a race detector sees through; to start and join one takes as long
/// as to wake one and wait for it. Each begins at a place of its own, the same every time, and goes
/// on from there: what it wrote the last time is still in its caches.
void shareJobs(int threads, int count, const std::function<void(int job)> &job);

} // namespace pixelplumb
