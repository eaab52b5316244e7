// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace pixelplumb {

/// Runs jobs 0 … count − 1, each once, on the calling thread and up to `threads` − 1 others, and
/// returns when all are done. Jobs must not throw or share jobs themselves. The threads start as
/// far apart as possible and go on from there, because neighbouring jobs share cache lines.
///
/// The threads are kept until the process ends, since starting and joining one takes some 100 µs; a
/// caller waits while they work for another. Work is handed over through the standard library's
/// semaphores, which race detectors understand.
void shareJobs(int threads, int count, const std::function<void(int job)> &job);

} // namespace pixelplumb
