// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"
#include "core/scene/writtenas.h"

#include <QByteArray>
#include <QIODevice>

#include <optional>

namespace pixelplumb {

/// Of scenes, meshes, assignments and all else that is no picture; bytes.
inline constexpr qint64 largestFile = qint64(256) << 20;

/// The content of a file of at most so many bytes, which is an input from then on: a pipe, too,
/// since a person named it.
Result<QByteArray> readFile(const QString &path, qint64 most = largestFile);
/// The same of what no person named for itself, or chose in a window: a pipe or a device, which may
/// never begin or end, is refused.
Result<QByteArray> readRegularFile(const QString &path, qint64 most = largestFile);
/// What is left of a device that is open, in pieces: it may never end. `place` names it.
Result<QByteArray> readDevice(const QString &place, QIODevice &device, qint64 most);

/// An error in what a file holds, with the file's path before its place.
InputError errorIn(const QString &path, InputError error);

/// What is said where a listener ended the reading.
InputError readingCancelled(const QString &place);

/// Replaces a file in one step: after an error the old content stands. What is no regular file (a
/// device, a pipe) is written to as it is.
std::optional<InputError> writeFile(const QString &path, const QByteArray &content,
                                    WrittenAs as = WrittenAs::Export);

} // namespace pixelplumb
