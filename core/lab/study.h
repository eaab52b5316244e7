// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/costfit.h"
#include "core/lab/effectstudy.h"
#include "core/lab/labcontender.h"
#include "core/lab/labfamily.h"
#include "core/lab/labfigures.h"
#include "core/measure/machine.h"
#include "core/number/jobprogress.h"

namespace pixelplumb {

/// What is asked of a study.
struct StudySettings {
    StudyExtent extent = StudyExtent::Quick;
    std::uint64_t seed = 1;
    std::shared_ptr<const Scene> ownScene; ///< may be null
    QString ownSceneName; ///< as the command line has it; for the command that does it again
    std::vector<HardCase> hardCases = {};
    QStringList families = {}; ///< ids; empty: all
    std::vector<LabContender> contenders = {}; ///< empty: those of the extent
    std::vector<LabContender> peers = {}; ///< beside them
    /// Samples that a contender may take for the accuracy of one family; 0: the extent's.
    std::int64_t mostSamples = 0;
    /// Seconds of processor time after which a contender hangs; 0: the extent's, far more than any
    /// takes within its samples.
    double hangSeconds = 0;
    /// Seconds of processor time of a timed draw, beyond which it is not timed; 0: the extent's.
    double longestDrawSeconds = 0;
    int rounds = -1; ///< of timing; below 0: the extent's; 0: nothing is timed
};

/// s that the study takes about on two idle cores, for who waits.
double expectedSeconds(const StudySettings &settings);

enum class LabOutcome : std::uint8_t {
    Pending, ///< the study was ended before its turn
    Measured,
    Refused, ///< has no such rule for this family, or is not given such triangles
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

    /// How many times its straight loop it takes, where that is more than what is fair (1.3).
    std::optional<double> missesStraight() const;
    /// What depends on the seed alone: no cost, and no remark, which may tell of times.
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

/// What was drawn, for the figures that are shares of it.
struct StudyFamily {
    QString id;
    QString title;
    QString stresses;
    std::int64_t triangles = 0; ///< of the family
    std::int64_t timedTriangles = 0; ///< drawn by everyone in each timed draw; 0: not timed
    std::int64_t timedPixels = 0; ///< that they write, each as often as it is written
    std::int64_t timedColumns = 0; ///< samples that their columns are at
    std::int64_t timedRows = 0;
    std::int64_t timedBytes = 0; ///< of the cache lines that they write to
    /// Of frames, settings and triangles: the same for the same work. None in files of version 1.
    std::optional<QString> digest = {};

    /// Rows of a contender whose spans are rows, columns of everyone else.
    std::int64_t timedSpans(const QString &contender) const;

    friend bool operator==(const StudyFamily &, const StudyFamily &) = default;
};

/// A study, finished or not. A value that views receive and files keep.
struct Study {
    StudyExtent extent = StudyExtent::Quick;
    std::uint64_t seed = 1;
    MachineConditions conditions;
    QString command; ///< that does it again; empty where its scene was in no file
    std::vector<StudyContender> contenders;
    std::vector<StudyFamily> families;
    std::vector<LabRow> rows; ///< by families, each with all contenders in their order
    std::vector<EffectRow> effects;
    int rounds = 0; ///< of timing, done
    bool isComplete = false;

    const LabRow *row(const QString &contender, const QString &family) const;
    const StudyContender *contender(const QString &id) const;
    const StudyFamily *family(const QString &id) const;
    /// ns a pixel of a row, in the middle; none where it was not timed.
    std::optional<double> perPixel(const LabRow &row) const;

    friend bool operator==(const Study &, const Study &) = default;
};

/// What to know before believing: the machine's, too few rounds, a wide spread, no straight loop
/// that vouches.
QStringList warningsOf(const Study &study);

/// Hears from the study, in its thread.
struct StudyListener {
    ProgressListener progress; ///< false ends the study, which keeps what it has
    /// A row has its accuracy, or why it has none, or why it is not timed.
    std::function<void(const Study &study, std::size_t row)> rowChanged;
    /// A family's first round or another round of all is over, whole or not, and the timed rows
    /// have its times.
    std::function<void(const Study &study)> roundDone = {};
};

/// Judges every contender on every family and times each family once as soon as it is judged, then
/// times all of them in turn, round by round; then it measures what effects cost. The accuracy
/// depends on nothing but the settings: how much is judged is limited in samples, and the limit in
/// seconds only ends what hangs. Nothing of it is thrown when a contender fails.
Study runStudy(const StudySettings &settings, const StudyListener &listener = {});

} // namespace pixelplumb
