// SPDX-License-Identifier: GPL-3.0-or-later
#include "race.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

/// ns. Refilling the caches takes 1 or 2 ms: less than the noise of a draw of this length.
constexpr double coldMattersBelow = 100e6;

double timeOf(const Elapsed &elapsed, const Contender &contender)
{
    return contender.info().threads == 1 ? elapsed.thread : elapsed.wall;
}

Elapsed timeDraws(Contender &contender, int draws)
{
    const Stopwatch stopwatch;
    for (int draw = 0; draw < draws; ++draw) {
        contender.draw();
        benchmark::ClobberMemory();
    }
    return stopwatch.elapsed();
}

/// Finds how many triangles one draw may take and how many draws fill a sample. Leaves the
/// contender loaded and warm.
void calibrate(Result &result, std::size_t available, Forms &forms, const RaceOptions &options)
{
    Contender &contender = *result.contender;
    result.triangles = std::min<std::size_t>(available, 10);
    double time = 0;
    while (true) {
        contender.load(forms.scene(contender.info().shading, result.triangles));
        contender.draw(); // touches the frame's pages and fills the caches
        time = std::max(timeOf(timeDraws(contender, 1), contender), 1.0);
        if (result.triangles == available || time * 2 > options.longestDraw)
            break;
        const double fitting = options.longestDraw / time * double(result.triangles);
        const double next = std::min(fitting, double(result.triangles) * 30);
        result.triangles = std::min(available, std::size_t(std::max(next, 1.0)));
    }
    result.firstTime = time;
    result.drawsPerSample = std::max(1, int(std::ceil(options.sampleNanoseconds / time)));
}

void takeSample(Result &result)
{
    Contender &contender = *result.contender;
    if (result.firstTime < coldMattersBelow)
        contender.draw(); // discards what the previous contender left in the caches
    const int mostAttempts = contender.info().threads == 1 ? 1 : 4;
    Elapsed best;
    for (int attempt = 0; attempt < mostAttempts; ++attempt) {
        const Elapsed now = timeDraws(contender, result.drawsPerSample);
        if (attempt == 0 || now.preemptions < best.preemptions)
            best = now;
        if (best.preemptions == 0)
            break;
    }
    result.processorsUsed.push_back(best.process / std::max(best.wall, 1.0));
    result.disturbedSamples += best.preemptions > 0 ? 1 : 0;
    result.nanosecondsPerTriangle.push_back(timeOf(best, contender) / result.drawsPerSample
                                            / double(result.triangles));
}

} // namespace

Spread ratio(const Result &result, const Result &unit)
{
    std::vector<double> ratios;
    for (std::size_t round = 0; round < result.nanosecondsPerTriangle.size(); ++round) {
        ratios.push_back(result.nanosecondsPerTriangle[round] / unit.nanosecondsPerTriangle[round]);
    }
    return spreadOf(ratios);
}

Scene Forms::scene(Shading shading, std::size_t triangles)
{
    if (shading == Shading::Smooth)
        return {m_workload.size, std::span(m_workload.triangles).first(triangles)};
    if (m_flat.empty())
        m_flat = flattened(m_workload.triangles);
    return {m_workload.size, std::span(m_flat).first(triangles)};
}

std::vector<Result> race(const Workload &workload, Forms &forms,
                         const std::vector<Contender *> &contenders, const RaceOptions &options,
                         const std::function<void(const QString &)> &progress)
{
    std::vector<Result> results;
    for (Contender *contender : contenders) {
        progress(u"%1: warming up %2"_s.arg(workload.id, contender->info().name));
        results.emplace_back().contender = contender;
        calibrate(results.back(), workload.triangles.size(), forms, options);
    }
    for (int round = 0; round < options.rounds; ++round) {
        progress(u"%1: round %2 of %3"_s.arg(workload.id).arg(round + 1).arg(options.rounds));
        // Each round starts with another contender, so that none always follows the same
        // neighbour's load.
        for (std::size_t turn = 0; turn < results.size(); ++turn)
            takeSample(results[(turn + std::size_t(round)) % results.size()]);
    }
    return results;
}

} // namespace pixelplumb::bench
