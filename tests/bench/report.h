// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lineup.h"
#include "machinereport.h"
#include "picturecheck.h"
#include "race.h"

#include <QByteArray>

namespace pixelplumb::bench {

/// One contender on one workload: its time beside its picture.
struct ReportRow {
    Result result;
    std::optional<PictureDifference> picture; ///< none for a limit
    /// Of who promises the plain kernel's picture: the share of pixels that differ after the last
    /// timed draw, overlaps and all.
    std::optional<double> differsFromPlain;
};

struct WorkloadReport {
    QString id;
    QString title;
    FrameSize size;
    std::size_t triangles = 0;
    double pixelsPerTriangle = 0; ///< under the half-open rule
    std::vector<ReportRow> rows;

    /// Null when the contender did not run.
    const ReportRow *row(const QString &contenderId) const;
};

/// All that a run found out; what is printed and what is written comes from here.
struct Report {
    MachineConditions machine;
    double loadAtEnd = 0;
    int rounds = 0;
    Extent extent = Extent::Full;
    QString referenceId;
    std::vector<Absence> absent;
    std::vector<WorkloadReport> workloads;

    /// Contenders that promise the true picture and drew another one, as sentences.
    QStringList brokenPromises() const;
};

QString markdown(const Report &report);
QByteArray json(const Report &report);

} // namespace pixelplumb::bench
