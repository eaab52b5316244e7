// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/judging/levelprobe.h"

#include "core/lab/judging/exactlevel.h"
#include "core/methods/method.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

void LevelTally::add(double error)
{
    const double magnitude = std::abs(error);
    magnitudes.push_back(float(magnitude));
    squares += error * error;
    largest = std::max(largest, magnitude);
}

std::optional<LevelErrors> LevelTally::errors()
{
    if (magnitudes.empty())
        return std::nullopt;
    const auto place = std::size_t(std::ceil(0.999 * double(magnitudes.size()))) - 1;
    std::ranges::sort(magnitudes);
    return LevelErrors{std::int64_t(magnitudes.size()), largest,
                       std::sqrt(squares / double(magnitudes.size())), double(magnitudes[place])};
}

namespace {

void count(LabShare &share, bool is)
{
    share.count += is ? 1 : 0;
    ++share.of;
}

void addSample(LevelTally &tally, const SampleRecord &sample, const ExactLevels &exact,
               const FrameView &truth)
{
    const auto &colours = sample.colour;
    const bool hasNoNumber = std::ranges::any_of(
        colours, [](const Quantity &level) { return std::isnan(level.toDouble()); });
    const bool hasInfinity = std::ranges::any_of(
        colours, [](const Quantity &level) { return std::isinf(level.toDouble()); });
    count(tally.notANumber, hasNoNumber);
    count(tally.infinite, hasInfinity);
    count(tally.clamped, sample.clamped);
    if (hasNoNumber || hasInfinity || !truth.contains(sample.x, sample.y)
        || *truth.at(sample.x, sample.y) == 0)
        return;
    for (std::size_t i = 0; i < colours.size(); ++i)
        tally.add(levelError(exact.at(i, sample.x, sample.y), colours[i]));
}

} // namespace

bool probeLevels(const Method &method, const ScanSettings &settings, const Triangle &triangle,
                 FrameView frame, const FrameView &truth, LevelTally &tally)
{
    if (!method.draws(PrimitiveKind::Triangle))
        return false;
    const auto trace = Run(&method, {{triangle}, {}}, settings, frame).trace(frame);
    const ExactLevels exact(triangle);
    for (std::size_t span = 0; span < trace->spanCount(); ++span) {
        for (const SampleRecord &sample : trace->samplesWithoutCells(span)) {
            if (sample.fate == SampleFate::Written)
                addSample(tally, sample, exact, truth);
        }
    }
    return true;
}

} // namespace pixelplumb
