// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace pixelplumb {

/// The path of a file or folder of resources/ in the source tree of this build:
/// "/scenes/default.json". It is a function, not a macro, because a path among the compiler options
/// of every test would defeat a compiler cache shared with another clone.
QString resource(const QString &path);
/// The path of a file in tests/data: "hard_cases.json".
QString testData(const QString &name);

/// The path of a file or folder given relative to the root of the tree: "core/scan".
QString inTree(const QString &path);

/// The text of a file given relative to the root of the tree; empty if it cannot be read.
QString textInTree(const QString &path);

/// The files below a folder, as paths from the root of the tree, in alphabetical order. `patterns`
/// are wildcards; a file's name must match one of them.
QStringList filesBelow(const QString &folder, const QStringList &patterns = {"*.h", "*.cpp"});

/// README and the documents in resources/, as paths from the root of the tree.
QStringList documents();

} // namespace pixelplumb
