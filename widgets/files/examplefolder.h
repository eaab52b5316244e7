// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace pixelplumb {

/// Whether a file stands in the folder of example scenes that came with the program: beside its
/// sources, where it was built, or in the share folder where it was installed. What a person draws
/// is not saved there unasked.
bool isExample(const QString &path);

struct Example {
    QString path;
    QString title; ///< "Shared edge"
    QString line; ///< what there is to see; empty where nobody has said it
};

/// The example scenes, by name; none where the program has lost its folder.
std::vector<Example> examples();

} // namespace pixelplumb
