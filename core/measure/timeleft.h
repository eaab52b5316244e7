// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"

#include <QString>

#include <chrono>
#include <optional>

namespace pixelplumb {

/// "about 14 s"; from two minutes on "about 5 min".
QString aboutText(double seconds);

/// How long a job will still take of which is known before what it takes about, and which tells its
/// progress as a whole: what was known, scaled by how it went so far.
class TimeLeft {
public:
    using Clock = std::chrono::steady_clock;

    explicit TimeLeft(double expectedSeconds)
        : m_expected(expectedSeconds)
    {
    }

    void tell(const JobProgress &progress, Clock::time_point now);

    double share() const; ///< 0 … 1 that are done
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
