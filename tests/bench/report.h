// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lineup.h"
#include "machinereport.h"
#include "picturecheck.h"
#include "race.h"

namespace pixelplumb::bench {

/// One contender on one workload: its time and its picture.
struct ReportRow {
    Result result;
    std::optional<PictureDifference> picture; ///< none for a limit
    /// For contenders that promise the plain kernel's picture: the share of pixels that differ
    /// after the last timed draw, overlaps included.
    std::optional<double> differsFromPlain;
};

struct WorkloadReport {
    QString id;
    QString title;
    FrameSize size;
    std::size_t triangles = 0;
    double pixelsPerTriangle = 0; ///< under the half-open rule
    std::vector<ReportRow> rows;

    /// Null if the contender did not run.
    const ReportRow *row(const QString &contenderId) const;
};

/// All results of a run.
struct Report {
    MachineConditions machine;
    double loadAtEnd = 0;
    int rounds = 0;
    Extent extent = Extent::Full;
    QString referenceId;
    std::vector<Absence> absent;
    std::vector<WorkloadReport> workloads;

    /// Contenders that promise the true picture but drew another one, as sentences.
    QStringList brokenPromises() const;
};

QString markdown(const Report &report);

} // namespace pixelplumb::bench
