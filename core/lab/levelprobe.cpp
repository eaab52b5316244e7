// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/levelprobe.h"

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

bool probeLevels(const Method &method, const ScanSettings &settings, const Triangle &triangle,
                 FrameView frame, const FrameView &truth, LevelTally &tally)
{
    for (const auto &table : {probedWalks(), probedTests(), probedInterpolations()}) {
        const auto found = std::ranges::find_if(table, [&](const ProbedMethod &probed) {
            return method.id == QLatin1String(probed.id);
        });
        if (found != table.end()) {
            found->probe({{triangle}, {}}, settings, frame, truth, tally);
            return true;
        }
    }
    return false;
}

} // namespace pixelplumb
