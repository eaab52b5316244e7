// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/crew.h"

#include <atomic>
#include <cstdint>
#include <system_error>
#include <thread>
#include <vector>

namespace pixelplumb {

void shareJobs(int threads, int count, const std::function<void(int job)> &job)
{
    std::vector<std::atomic<bool>> isTaken(static_cast<std::size_t>(count));
    const auto takeJobs = [&](int thread) {
        const int first = int(std::int64_t(count) * thread / threads);
        for (int k = 0; k < count; ++k) {
            const int mine = (first + k) % count;
            if (!isTaken[std::size_t(mine)].exchange(true))
                job(mine);
        }
    };
    std::vector<std::jthread> others; // joined before the rest goes
    others.reserve(std::size_t(threads - 1));
    try {
        while (int(others.size()) < threads - 1)
            others.emplace_back(takeJobs, int(others.size()) + 1);
    } catch (const std::system_error &) {
        // Those that started, or the caller alone, do the work.
    }
    takeJobs(0);
}

} // namespace pixelplumb
