// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QStringList>

namespace pixelplumb::cli {

/// Where the results of several inputs are written, in their order. A single result goes to
/// `output` itself. Where `output` is a folder ("out/", or an existing one), which is made if need
/// be, each result gets its input's name in it with the ending `suffix` ("png"). An error where
/// there are several inputs and no folder, where two would get the same name, and for standard
/// input, which has no name.
Result<QStringList> outputPaths(const QString &output, const QStringList &inputs,
                                const QString &suffix);

} // namespace pixelplumb::cli
