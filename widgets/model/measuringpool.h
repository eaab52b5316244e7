// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QThreadPool;

namespace pixelplumb {

/// For all jobs that time something: it runs one at a time, so that none disturbs another. The
/// others wait, and then measure.
QThreadPool *measuringPool();

/// What a job says that is about to be put there: "Measuring …", or that it waits.
QString measuringNote();

} // namespace pixelplumb
