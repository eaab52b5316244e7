// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contest.h"
#include "core/grade/diagnosis.h"
#include "core/grade/picturediff.h"
#include "core/lab/study.h"

#include <QJsonObject>
#include <QStringList>

#include <span>

namespace pixelplumb::cli {

/// How many pixels have which verdict, and what would explain them.
QStringList diffLines(const PictureDiff &diff);
QJsonObject diffJson(const PictureDiff &diff);

/// The verdict and each set of defects, with the step at which its run departs from the right one.
QStringList diagnosisLines(const Diagnosis &diagnosis, std::span<const Submission> submissions);
QJsonObject diagnosisJson(const Diagnosis &diagnosis, std::span<const Submission> submissions);

/// A contest to report as text or as JSON, with the first `pixelLimit` differing pixels by columns.
struct CompareReport {
    const Contest &contest;
    std::size_t pixelLimit;
};

QStringList compareLines(const CompareReport &report);
QJsonObject compareJson(const CompareReport &report);

/// A study as readable text: warnings, a table per family, the costs of set-up, columns and pixels,
/// and the command that repeats it.
QStringList studyLines(const Study &study);

} // namespace pixelplumb::cli
