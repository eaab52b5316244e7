// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace pixelplumb {

/// Whether a file stands in the folder of example scenes that came with the program: beside its
/// sources, where it was built, or in the share folder where it was installed. What a person draws
/// is not saved there unasked.
bool isExample(const QString &path);

/// The example scenes, by name; none where the program has lost its folder.
QStringList examplePaths();

} // namespace pixelplumb
