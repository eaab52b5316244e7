// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace pixelplumb {

/// The path of a file or folder of resources/ in the tree that the tests were compiled from:
/// "/scenes/default.json". A function and no macro, since a path among the options of every test
/// would keep a compiler cache from knowing it in another clone.
QString resource(const QString &path);
/// That of a file of tests/data: "hard_cases.json".
QString testData(const QString &name);

/// The path of a file or folder that is named from the root of the tree: "core/scan".
QString inTree(const QString &path);

/// The text of a file that is named from the root of the tree; empty where it cannot be read.
QString textInTree(const QString &path);

/// The files below a folder of the tree, as paths from its root, in alphabetical order.
/// `patterns`: wildcards of which a file's name matches one.
QStringList filesBelow(const QString &folder, const QStringList &patterns = {"*.h", "*.cpp"});

/// README and the documents in resources/, as paths from the root of the tree.
QStringList documents();

} // namespace pixelplumb
