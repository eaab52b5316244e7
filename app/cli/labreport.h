// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study.h"

namespace pixelplumb::cli {

/// A study as readable text: warnings, a table per family, the costs of set-up, columns and pixels,
/// and the command that repeats it.
QStringList textOf(const Study &study);

} // namespace pixelplumb::cli
