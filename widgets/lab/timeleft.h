// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"

#include <QString>

#include <chrono>
#include <optional>

namespace pixelplumb {

/// How long a phase of a job will still take, if it goes on as it went so far.
class TimeLeft {
public:
    using Clock = std::chrono::steady_clock;

    void tell(const JobProgress &progress, Clock::time_point now);

    /// 0 … 1 of the phase in hand; none while nobody knows.
    std::optional<double> share() const;
    /// None before a second and a part of the phase have passed.
    std::optional<std::chrono::seconds> left() const;
    /// "measuring: 40 %, about 6 s left"
    QString text() const;

private:
    JobProgress m_progress;
    Clock::time_point m_begin; ///< of the phase
    Clock::time_point m_now;
    bool m_hasBegun = false;
};

} // namespace pixelplumb
