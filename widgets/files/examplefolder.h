// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace pixelplumb {

/// Whether a file is in the folder of example scenes that came with the program: beside its sources
/// where it was built, in the share folder where it was installed. A person's work is not saved
/// there unasked.
bool isExample(const QString &path);

struct Example {
    QString path;
    QString title; ///< "Shared edge"
    QString line; ///< what there is to see; empty where the example has no description
};

/// The example scenes, the assignment's triangle first, in the order of a course; none where their
/// folder is not found.
std::vector<Example> examples();

} // namespace pixelplumb
