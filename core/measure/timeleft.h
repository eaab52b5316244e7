// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"

#include <QString>

#include <chrono>
#include <optional>
#include <vector>

namespace pixelplumb {

/// A part of a long job, and what it is known to take about.
struct JobStage {
    JobPhase phase = JobPhase::Drawing;
    double seconds = 0; ///< above 0
};

/// "about 14 s"; from two minutes on "about 5 min".
QString aboutText(double seconds);

/// How far a job of several stages is as a whole, and how long it will still take: what was known
/// before, scaled by how the stages that are done went.
class TimeLeft {
public:
    using Clock = std::chrono::steady_clock;

    /// In their order.
    explicit TimeLeft(std::vector<JobStage> stages);

    /// A phase that no stage to come has changes nothing.
    void tell(const JobProgress &progress, Clock::time_point now);

    double share() const; ///< 0 … 1 of all stages
    double seconds() const; ///< that are left; before the first word those known before
    /// "judging: 40 %, about 6 s left"
    QString text() const;

private:
    double expected() const; ///< seconds of all stages, as known before

    std::vector<JobStage> m_stages;
    std::size_t m_stage = 0; ///< in hand
    std::optional<JobProgress> m_progress; ///< of the stage in hand
    Clock::time_point m_begin;
    Clock::time_point m_now;
};

} // namespace pixelplumb
