// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/diagnosis.h"

#include <QJsonObject>
#include <QStringList>

#include <span>

namespace pixelplumb::cli {

/// The verdict and each set of defects, with the step at which its run departs from the right one.
QStringList textOf(const Diagnosis &diagnosis, std::span<const Submission> submissions);
QJsonObject jsonOf(const Diagnosis &diagnosis, std::span<const Submission> submissions);

} // namespace pixelplumb::cli
