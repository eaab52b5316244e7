// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QByteArray>

#include <optional>

namespace pixelplumb {

/// The content of a file of up to 256 MiB.
Result<QByteArray> readFile(const QString &path);
/// The same of what a scene refers to: a pipe or a device, which may never end, is refused.
Result<QByteArray> readRegularFile(const QString &path);

/// An error in what a file holds, with the file's path before its place.
InputError errorIn(const QString &path, InputError error);

/// What is said where a listener ended the reading.
InputError readingCancelled(const QString &place);

/// Whether two paths lead to one regular file (same device and inode), through links too; false
/// where one of them does not exist.
bool isSameFile(const QString &path, const QString &other);

/// Replaces a file in one step (QSaveFile): after an error the old content stands. What is no
/// regular file (a device, a pipe) is written to as it is.
std::optional<InputError> writeFile(const QString &path, const QByteArray &content);

} // namespace pixelplumb
