// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study.h"

namespace pixelplumb::cli {

/// A study as people read it: warnings, a table a family, what set-up, columns and pixels take, and
/// the command that does it again.
QStringList textOf(const Study &study);

} // namespace pixelplumb::cli
