// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

#include <cstdint>
#include <functional>
#include <string_view>

namespace pixelplumb {

/// What a long job is doing at the moment, for the person waiting.
enum class JobPhase {
    Reading, ///< counts bytes
    Projecting, ///< solids; counts faces
    Drawing, ///< counts primitives, or pictures where there are several
    Recording, ///< counts spans, or runs where there are several
    RecordingExactly, ///< the same run in exact arithmetic; counts spans
    Judging, ///< draws the truth; counts rows
    Explaining, ///< explains where pictures differ; counts columns
    Measuring, ///< counts samples of time
    Writing, ///< counts spans
    Checking, ///< counts methods
    Shrinking, ///< simplifies a scene; counts the simpler scenes tried
};

constexpr std::string_view nameOf(JobPhase phase)
{
    switch (phase) {
    case JobPhase::Reading:
        return QT_TRANSLATE_NOOP("core", "reading");
    case JobPhase::Projecting:
        return QT_TRANSLATE_NOOP("core", "projecting");
    case JobPhase::Drawing:
        return QT_TRANSLATE_NOOP("core", "drawing");
    case JobPhase::Recording:
        return QT_TRANSLATE_NOOP("core", "recording");
    case JobPhase::RecordingExactly:
        return QT_TRANSLATE_NOOP("core", "recording in exact numbers");
    case JobPhase::Judging:
        return QT_TRANSLATE_NOOP("core", "judging");
    case JobPhase::Explaining:
        return QT_TRANSLATE_NOOP("core", "explaining");
    case JobPhase::Measuring:
        return QT_TRANSLATE_NOOP("core", "measuring");
    case JobPhase::Writing:
        return QT_TRANSLATE_NOOP("core", "writing");
    case JobPhase::Checking:
        return QT_TRANSLATE_NOOP("core", "checking");
    case JobPhase::Shrinking:
        return "shrinking";
    }
    return {};
}

/// How far a job is in its phase.
struct JobProgress {
    JobPhase phase = JobPhase::Drawing;
    std::int64_t done = 0;
    std::int64_t total = 0; ///< 0: unknown

    friend bool operator==(const JobProgress &, const JobProgress &) = default;
};

/// Called now and then, in the job's thread, with its progress; returning false ends the job.
using ProgressListener = std::function<bool(const JobProgress &progress)>;

/// Reports progress to the listener, if there is one. False when the job is to end.
inline bool goesOn(const ProgressListener &listener, const JobProgress &progress)
{
    return !listener || listener(progress);
}

} // namespace pixelplumb
