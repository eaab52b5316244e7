// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace pixelplumb {

/// What to do with changes that are not in a file yet.
enum class UnsavedChanges { Save, Discard, Cancel };

/// Asks in a box before the named scene is replaced: any of the three.
UnsavedChanges askAboutChanges(const QString &name, QWidget *window);
/// Asks before going back to the file: Discard or Cancel; saving first would leave nothing to go
/// back to.
UnsavedChanges askAboutRevert(const QString &name, QWidget *window);

} // namespace pixelplumb
