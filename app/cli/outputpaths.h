// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QStringList>

namespace pixelplumb::cli {

/// Where the results of several inputs are written, in their order. One input's goes to `output`
/// itself; but where that is a folder ("out/", or one that is there), which is made if need be,
/// each goes to the input's name in it, with `suffix` ("png") at its end. An error where there are
/// several inputs and no folder, where two would get one name, and for standard input, which has
/// none.
Result<QStringList> outputPaths(const QString &output, const QStringList &inputs,
                                const QString &suffix);

} // namespace pixelplumb::cli
