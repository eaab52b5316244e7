// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/resource.h>

#include <ctime>

namespace pixelplumb {

/// What a stretch of work took.
struct Elapsed {
    double wall = 0; ///< ns
    double thread = 0; ///< ns of the calling thread on a processor
    double process = 0; ///< ns of all threads on processors
    long preemptions = 0; ///< how often the system took a processor from a thread of this process
};

class Stopwatch {
public:
    Elapsed elapsed() const
    {
        const Elapsed now = read();
        return {now.wall - m_start.wall, now.thread - m_start.thread, now.process - m_start.process,
                now.preemptions - m_start.preemptions};
    }

private:
    static double nanosecondsOf(clockid_t clock)
    {
        timespec time = {};
        clock_gettime(clock, &time);
        return double(time.tv_sec) * 1e9 + double(time.tv_nsec);
    }
    static Elapsed read()
    {
        rusage usage = {};
        getrusage(RUSAGE_SELF, &usage);
        return {nanosecondsOf(CLOCK_MONOTONIC), nanosecondsOf(CLOCK_THREAD_CPUTIME_ID),
                nanosecondsOf(CLOCK_PROCESS_CPUTIME_ID), usage.ru_nivcsw};
    }

    Elapsed m_start = read();
};

} // namespace pixelplumb
