// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/pixelhistory.h"

#include <QJsonObject>
#include <QStringList>

namespace pixelplumb::cli {

/// The history of one pixel, to report as text or as JSON.
struct PixelReport {
    const TracedScene &traced;
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::vector<PixelAttempt> attempts;
};

QStringList textOf(const PixelReport &report);
QJsonObject jsonOf(const PixelReport &report);

} // namespace pixelplumb::cli
