// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contest.h"

#include <QJsonObject>
#include <QStringList>

namespace pixelplumb::cli {

/// A contest to report as text or as JSON, with the first `pixelLimit` differing pixels by columns.
struct CompareReport {
    const Contest &contest;
    std::size_t pixelLimit;
};

QStringList textOf(const CompareReport &report);
QJsonObject jsonOf(const CompareReport &report);

} // namespace pixelplumb::cli
