// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QThreadPool;

namespace pixelplumb {

/// The pool for all jobs that time something: it runs one at a time, so that none disturbs another;
/// the others wait.
QThreadPool *measuringPool();

/// The title of a job about to be put there: "Measuring …", or that it waits.
QString measuringNote();

} // namespace pixelplumb
