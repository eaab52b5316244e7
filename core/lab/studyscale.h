// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"

namespace pixelplumb {

/// The progress of all parts of a study as one: each part has a weight, about the time that it
/// takes.
class StudyScale {
public:
    /// `whole`: the weights of all parts. The listener outlives the scale.
    StudyScale(const ProgressListener &listener, std::int64_t whole)
        : m_listener(listener)
        , m_whole(whole)
    {
    }

    /// For the next part, which tells its own progress to it.
    ProgressListener next(std::int64_t weight)
    {
        const std::int64_t before = m_before;
        m_before += weight;
        return [this, before, weight](const JobProgress &part) {
            const double share = part.total == 0 ? 0 : double(part.done) / double(part.total);
            return goesOn(m_listener,
                          {part.phase,
                           steps * before + std::int64_t(double(steps * weight) * share),
                           steps * m_whole});
        };
    }

private:
    static constexpr std::int64_t steps = 1000; ///< of a weight of 1

    const ProgressListener &m_listener;
    std::int64_t m_whole;
    std::int64_t m_before = 0;
};

} // namespace pixelplumb
