// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"

#include <QString>

#include <chrono>
#include <optional>

namespace pixelplumb {

/// "about 14 s"; from two minutes on "about 5 min".
QString aboutText(double seconds);

/// How far a long job is, and how long it will still take: what was known before, scaled by how it
/// went so far.
class TimeLeft {
public:
    using Clock = std::chrono::steady_clock;

    /// s that the job is known to take about.
    explicit TimeLeft(double expected)
        : m_expected(expected)
    {
    }

    /// The job's phases count on one scale.
    void tell(const JobProgress &progress, Clock::time_point now);

    double share() const; ///< 0 … 1
    double seconds() const; ///< that are left; before the first word those known before
    /// "judging: 40 %, about 6 s left"
    QString text() const;

private:
    double m_expected;
    std::optional<JobProgress> m_progress;
    Clock::time_point m_begin;
    Clock::time_point m_now;
};

} // namespace pixelplumb
