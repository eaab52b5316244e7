// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"

#include <QString>

#include <chrono>
#include <optional>

namespace pixelplumb {

/// "about 14 s"; from two minutes on "about 5 min".
QString aboutText(double seconds);

/// How far a long job is, and how long it will still take: the earlier estimate, scaled by progress
/// so far.
class TimeLeft {
public:
    using Clock = std::chrono::steady_clock;

    /// About how many s the job is known to take.
    explicit TimeLeft(double expected)
        : m_expected(expected)
    {
    }

    /// All phases of the job count on one scale.
    void tell(const JobProgress &progress, Clock::time_point now);

    double share() const; ///< 0 … 1
    double seconds() const; ///< that are left; before the first report the earlier estimate
    /// "judging: 40 %, about 6 s left"
    QString text() const;

private:
    double m_expected;
    std::optional<JobProgress> m_progress;
    Clock::time_point m_begin;
    Clock::time_point m_now;
};

} // namespace pixelplumb
