// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/drawsample.h"

#include "core/measure/stopwatch.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr int mostDraws = 100'000;

double timeOfAll(const std::function<void()> &draw, int draws)
{
    const Stopwatch stopwatch;
    for (int i = 0; i < draws; ++i)
        draw();
    return std::max(stopwatch.elapsed().thread, 1.0);
}

/// In one short draw the clock itself takes most of the time: doubles the draws until they fill
/// half.
int drawsThatFill(const std::function<void()> &draw, double nanoseconds)
{
    int draws = 1;
    double time = timeOfAll(draw, draws);
    while (time < nanoseconds / 2 && draws < mostDraws) {
        const double wanted = std::max(2.0 * draws, std::ceil(nanoseconds / time * draws));
        draws = int(std::min(wanted, double(mostDraws)));
        time = timeOfAll(draw, draws);
    }
    return int(std::clamp(std::ceil(nanoseconds / time * draws), 1.0, double(mostDraws)));
}

} // namespace

double sampleDraw(const std::function<void()> &draw, int &draws, double nanoseconds)
{
    draw();
    if (draws == 0)
        draws = drawsThatFill(draw, nanoseconds);
    return timeOfAll(draw, draws) / draws;
}

} // namespace pixelplumb
