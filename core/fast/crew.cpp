// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/crew.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <semaphore>
#include <system_error>
#include <thread>
#include <vector>

namespace pixelplumb {

namespace {

/// The jobs of one call.
class JobList {
public:
    JobList(int threads, int count, const std::function<void(int job)> &job)
        : m_threads(threads)
        , m_job(job)
        , m_isTaken(std::size_t(count))
    {
    }

    /// Runs the jobs that no other thread has taken.
    void work()
    {
        const auto count = std::int64_t(m_isTaken.size());
        const std::int64_t first = count * m_arrived++ / m_threads;
        for (std::int64_t k = 0; k < count; ++k) {
            const std::int64_t mine = (first + k) % count;
            if (!m_isTaken[std::size_t(mine)].exchange(true))
                m_job(int(mine));
        }
    }

private:
    int m_threads;
    const std::function<void(int job)> &m_job;
    std::vector<std::atomic<bool>> m_isTaken;
    std::atomic<int> m_arrived = 0;
};

/// Threads that wait for jobs.
class Crew {
public:
    Crew() = default;
    ~Crew()
    {
        m_jobs = nullptr;
        m_begun.release(std::ptrdiff_t(m_others.size()));
    }
    Crew(const Crew &) = delete;
    Crew &operator=(const Crew &) = delete;

    void share(int threads, int count, const std::function<void(int job)> &job)
    {
        const std::lock_guard lock(m_mutex);
        hire(std::size_t(threads - 1));
        const int helpers = std::min(threads - 1, int(m_others.size()));
        JobList jobs(threads, count, job);
        m_jobs = &jobs;
        m_begun.release(helpers);
        jobs.work();
        for (int i = 0; i < helpers; ++i)
            awaitHelper();
    }

private:
    void hire(std::size_t wanted)
    {
        try {
            while (m_others.size() < wanted)
                m_others.emplace_back([this] { workUntilDismissed(); });
        } catch (const std::system_error &) {
            // The threads that started, or the caller alone, do the work.
        }
    }

    void workUntilDismissed()
    {
        while (true) {
            m_begun.acquire();
            if (m_jobs == nullptr)
                return;
            m_jobs->work();
            m_finished.release();
        }
    }

    /// The last jobs end at about the same time: sooner than a thread could be put to sleep and
    /// woken.
    void awaitHelper()
    {
        constexpr int tries = 2000; // some 20 µs
        for (int i = 0; i < tries; ++i) {
            if (m_finished.try_acquire())
                return;
        }
        m_finished.acquire();
    }

    std::mutex m_mutex; ///< held while jobs are shared
    std::counting_semaphore<> m_begun{0};
    std::counting_semaphore<> m_finished{0};
    JobList *m_jobs = nullptr; ///< handed over by m_begun; null: dismissed
    std::vector<std::jthread> m_others; ///< last member: joined before the others are destroyed
};

} // namespace

void shareJobs(int threads, int count, const std::function<void(int job)> &job)
{
    static Crew crew;
    crew.share(threads, count, job);
}

} // namespace pixelplumb
