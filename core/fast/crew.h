// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <semaphore>
#include <thread>
#include <vector>

namespace pixelplumb {

/// The calling thread and some more, which share jobs. Handed over by the standard library's
/// semaphores, which a race detector sees through.
class Crew {
public:
    /// Of `threads` in all, 1 or more; fewer where the system has no thread left.
    explicit Crew(int threads);
    ~Crew();
    Crew(const Crew &) = delete;
    Crew &operator=(const Crew &) = delete;

    /// Does jobs 0 … count − 1, each once, and returns when all are done. The jobs throw nothing.
    void share(int count, const std::function<void(int job)> &job);

private:
    void workUntilDismissed();
    void takeJobs();

    std::counting_semaphore<> m_begun{0};
    std::counting_semaphore<> m_finished{0};
    const std::function<void(int job)> *m_job = nullptr;
    int m_count = 0;
    std::atomic<int> m_next = 0;
    std::atomic<bool> m_isDismissed = false;
    std::vector<std::jthread> m_others; ///< last: joined before the rest goes
};

} // namespace pixelplumb
