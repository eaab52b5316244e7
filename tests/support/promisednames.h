// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace pixelplumb {

/// What a name in tests/data/object_names.txt stands for.
enum class PromisedObject { Widget, Action, Dialog };

/// The object names promised to programs, in list order.
QStringList promisedNames(PromisedObject object);

/// The lines of the list that are neither a name nor a comment.
QStringList unreadPromises();

} // namespace pixelplumb
