// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/contenders/labcontender.h"
#include "core/lab/families/labfamily.h"
#include "core/lab/judging/costfit.h"
#include "core/lab/judging/labfigures.h"
#include "core/lab/study/effectstudy.h"
#include "core/measure/machine.h"
#include "core/number/jobprogress.h"

namespace pixelplumb {

/// What is requested of a study.
struct StudySettings {
    StudyExtent extent = StudyExtent::Quick;
    std::uint64_t seed = 1;
    std::shared_ptr<const Scene> ownScene; ///< may be null
    QString ownSceneName; ///< as on the command line; for the command that repeats the study
    std::vector<HardCase> hardCases = {};
    QStringList families = {}; ///< ids; empty: all
    std::vector<LabContender> contenders = {}; ///< empty: those of the extent
    std::vector<LabContender> peers = {}; ///< added to these
    /// Samples that a contender may visit for the accuracy of one family; 0: the extent's.
    std::int64_t mostSamples = 0;
    /// Seconds of processor time after which a contender counts as hanging; 0: the extent's, far
    /// more than any takes for its samples.
    double hangSeconds = 0;
    /// Seconds of processor time above which a draw is not timed; 0: the extent's.
    double longestDrawSeconds = 0;
    int rounds = -1; ///< of timing; below 0: the extent's; 0: nothing is timed
};

/// About how many s the study takes on two idle cores, for whoever waits.
double expectedSeconds(const StudySettings &settings);

enum class LabOutcome : std::uint8_t {
    Pending, ///< the study was ended before its turn
    Measured,
    Refused, ///< has no suitable rule for this family, or is not given such triangles
    TookTooLong,
    Failed,
};
/// "pending", "measured", "refused", "took-too-long", "failed"
QString nameOf(LabOutcome outcome);

/// One contender on one family.
struct LabRow {
    QString contender; ///< id
    QString family; ///< id
    LabOutcome outcome = LabOutcome::Pending;
    QString remark; ///< why not; empty where it was measured
    ScanSettings settings;
    std::optional<AccuracyFigures> accuracy;
    std::optional<CostFigures> cost;
    std::optional<LabMiss> firstMiss;

    /// How many times as long as its straight loop it takes, if that is more than fair (1.3).
    std::optional<double> missesStraight() const;
    /// What depends on the seed alone: no cost, and no remark, which may mention times.
    LabRow withoutTimes() const;

    friend bool operator==(const LabRow &, const LabRow &) = default;
};

struct StudyContender {
    QString id;
    QString label;
    LabKernel kernel = LabKernel::Plain;
    bool isProved = false; ///< of the plain kernel (see LabContender)
    QString domain; ///< of the proof
    std::optional<CostFit> fit; ///< over the families that were timed

    friend bool operator==(const StudyContender &, const StudyContender &) = default;
};

/// What was drawn, the basis of figures that are shares.
struct StudyFamily {
    QString id;
    QString title;
    QString stresses;
    std::int64_t triangles = 0; ///< of the family
    std::int64_t timedTriangles = 0; ///< drawn by every contender in each timed draw; 0: not timed
    std::int64_t timedPixels = 0; ///< that they write, counted each time
    std::int64_t timedColumns = 0; ///< columns of samples in their boxes
    std::int64_t timedRows = 0;
    std::int64_t timedBytes = 0; ///< of the cache lines that they write to
    /// A hash of frames, settings and triangles: equal for equal work. None in files of version 1.
    std::optional<QString> digest = {};

    /// Rows for a contender whose spans are rows, columns for all others.
    std::int64_t timedSpans(const QString &contender) const;

    friend bool operator==(const StudyFamily &, const StudyFamily &) = default;
};

/// A study, finished or not. A value that views receive and files keep.
struct Study {
    StudyExtent extent = StudyExtent::Quick;
    std::uint64_t seed = 1;
    MachineConditions conditions;
    QString command; ///< that repeats it; empty if its scene was in no file
    std::vector<StudyContender> contenders;
    std::vector<StudyFamily> families;
    std::vector<LabRow> rows; ///< by family, each with all contenders in their order
    std::vector<EffectRow> effects;
    int rounds = 0; ///< of timing, done
    bool isComplete = false;

    const LabRow *row(const QString &contender, const QString &family) const;
    const StudyContender *contender(const QString &id) const;
    const StudyFamily *family(const QString &id) const;
    /// The median ns per pixel of a row; none if it was not timed.
    std::optional<double> perPixel(const LabRow &row) const;

    friend bool operator==(const Study &, const Study &) = default;
};

/// Warnings about the figures: the machine's, too few rounds, a wide spread, no straight loop to
/// vouch for them.
QStringList warningsOf(const Study &study);

/// Receives a study's events, in its thread.
struct StudyListener {
    ProgressListener progress; ///< false ends the study, which keeps what it has
    /// A row has its accuracy, or the reason why it has none or is not timed.
    std::function<void(const Study &study, std::size_t row)> rowChanged;
    /// A family's first round or another round of all is over, complete or not, and the timed rows
    /// have its times.
    std::function<void(const Study &study)> roundDone = {};
};

/// Judges every contender on every family and times each family once as soon as it is judged, then
/// times all of them in turn, round by round; then it measures what effects cost. The accuracy
/// depends only on the settings: the judging is limited in samples, and the limit in seconds only
/// ends what hangs. It does not throw when a contender fails.
Study runStudy(const StudySettings &settings, const StudyListener &listener = {});

} // namespace pixelplumb
