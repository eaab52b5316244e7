// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// The path of a file or folder of resources/ in the tree that the tests were compiled from:
/// "/scenes/default.json". A function and no macro, since a path among the options of every test
/// would keep a compiler cache from knowing it in another clone.
QString resource(const QString &path);
/// That of a file of tests/data: "hard_cases.json".
QString testData(const QString &name);

} // namespace pixelplumb
