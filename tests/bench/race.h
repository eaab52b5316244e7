// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contender.h"
#include "core/measure/spread.h"
#include "core/measure/stopwatch.h"

#include <functional>

namespace pixelplumb::bench {

struct RaceOptions {
    int rounds = 11;
    double sampleNanoseconds = 10e6; ///< a sample draws as often as fills this
    double longestDraw = 150e6; ///< ns; who needs longer draws fewer of the triangles
};

/// The times of one contender on one workload, round by round.
struct Result {
    Contender *contender = nullptr;
    std::size_t triangles = 0; ///< as many of the workload's as were drawn, from the first
    int drawsPerSample = 1;
    double firstTime = 0; ///< ns of one draw, when it was tried how long one takes
    std::vector<double> nanosecondsPerTriangle; ///< a value a round
    std::vector<double> processorsUsed; ///< processor time of all threads over wall time, a round
    int disturbedSamples = 0; ///< preempted in every attempt

    Spread time() const { return spreadOf(nanosecondsPerTriangle); }
};

/// This result's times in units of another's, each divided within its round.
Spread ratio(const Result &result, const Result &unit);

/// A workload in the form that each shading asks for.
class Forms {
public:
    explicit Forms(const Workload &workload)
        : m_workload(workload)
    {
    }

    /// The first so many triangles; they live as long as this and the workload.
    Scene scene(Shading shading, std::size_t triangles);

private:
    const Workload &m_workload;
    std::vector<Triangle> m_flat; ///< made when first asked for
};

/// Lets contenders draw a workload in turn: each round takes one sample of everyone, so that what
/// slows the machine for a while slows all of them and cancels out in the ratios of that round.
///
/// Google Benchmark runs the repetitions of one benchmark after the other, or shuffled, and knows
/// no rounds; this takes its place and uses only its guards against the optimiser.
///
/// On one thread the clock is the thread's own processor time: other programs on the same
/// processor do not count. Contenders with more threads are timed by the wall clock; a sample in
/// which the system took a processor away is taken again, up to four times.
///
/// Afterwards each contender's frame is as its last draw left it.
std::vector<Result> race(const Workload &workload, Forms &forms,
                         const std::vector<Contender *> &contenders, const RaceOptions &options,
                         const std::function<void(const QString &)> &progress);

} // namespace pixelplumb::bench
