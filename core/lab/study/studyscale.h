// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"

#include <algorithm>

namespace pixelplumb {

/// The progress of all parts of a study as one, each weighted by about how long it takes.
class StudyScale {
public:
    /// `whole`: s of all parts. The listener must outlive the scale.
    StudyScale(const ProgressListener &listener, double whole)
        : m_listener(listener)
        , m_whole(whole)
    {
    }

    /// The listener for the next part, which reports its own progress and takes about `seconds` s.
    ProgressListener next(double seconds)
    {
        const double before = m_before;
        m_before += seconds;
        return [this, before, seconds](const JobProgress &part) {
            const double share = part.total == 0 ? 0 : double(part.done) / double(part.total);
            return goesOn(m_listener, {part.phase, stepsOf(before + seconds * share), steps});
        };
    }

private:
    static constexpr std::int64_t steps = 100'000;

    std::int64_t stepsOf(double seconds) const
    {
        return std::min(steps, std::int64_t(double(steps) * seconds / m_whole));
    }

    const ProgressListener &m_listener;
    double m_whole;
    double m_before = 0;
};

} // namespace pixelplumb
