// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contender.h"
#include "core/measure/spread.h"
#include "core/measure/stopwatch.h"

#include <functional>

namespace pixelplumb::bench {

struct RaceOptions {
    int rounds = 11;
    double sampleNanoseconds = 10e6; ///< a sample repeats the draw until this is filled
    double longestDraw = 150e6; ///< ns; a contender that needs longer draws fewer of the triangles
};

/// The times of one contender on one workload, round by round.
struct Result {
    Contender *contender = nullptr;
    std::size_t triangles = 0; ///< how many of the workload's triangles were drawn, from the first
    int drawsPerSample = 1;
    double firstTime = 0; ///< ns of the one draw that was tried to find out how long it takes
    std::vector<double> nanosecondsPerTriangle; ///< one value per round
    std::vector<double> processorsUsed; ///< processor time of all threads over wall time, one per
                                        ///< round
    int disturbedSamples = 0; ///< preempted in every attempt

    Spread time() const { return spreadOf(nanosecondsPerTriangle); }
};

/// This result's times in units of another result's, divided round by round.
Spread ratio(const Result &result, const Result &unit);

/// A workload in the form that each shading needs.
class Forms {
public:
    explicit Forms(const Workload &workload)
        : m_workload(workload)
    {
    }

    /// The first `triangles` triangles; the scene is valid as long as this object and the workload.
    Scene scene(Shading shading, std::size_t triangles);

private:
    const Workload &m_workload;
    std::vector<Triangle> m_flat; ///< made on first use
};

/// Lets contenders draw a workload in turn: each round takes one sample of every contender, so that
/// whatever slows the machine for a while slows all of them and cancels out in that round's ratios.
///
/// Google Benchmark runs the repetitions of one benchmark after the other, or shuffled, and has no
/// rounds; this function replaces it and uses only its guards against the optimiser.
///
/// On one thread the clock is the thread's own processor time, so other programs on the same
/// processor do not count. Contenders with more threads are timed by the wall clock; a sample
/// during which the system took a processor away is repeated, up to four times.
///
/// Afterwards each contender's frame is as its last draw left it.
std::vector<Result> race(const Workload &workload, Forms &forms,
                         const std::vector<Contender *> &contenders, const RaceOptions &options,
                         const std::function<void(const QString &)> &progress);

} // namespace pixelplumb::bench
