// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace pixelplumb {

/// What a name of tests/data/object_names.txt stands for.
enum class PromisedObject { Widget, Action, Dialog };

/// The object names that are promised to programs, in the order of the list.
QStringList promisedNames(PromisedObject object);

/// The lines of the list that can be read neither as a name nor as a comment.
QStringList unreadPromises();

} // namespace pixelplumb
