// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/text/result.h"
#include "core/scene/text/writtenas.h"

#include <QByteArray>
#include <QIODevice>

#include <optional>

namespace pixelplumb {

/// The largest file in bytes, for scenes, meshes, assignments and everything else but pictures.
inline constexpr qint64 largestFile = qint64(256) << 20;

/// Reads a file of at most `most` bytes and records it as an input. Pipes are read too, since the
/// user named the path.
Result<QByteArray> readFile(const QString &path, qint64 most = largestFile);
/// Like readFile(), but refuses pipes and devices, which may never begin or end: for paths that the
/// user did not type, or chose in a window.
Result<QByteArray> readRegularFile(const QString &path, qint64 most = largestFile);
/// Reads the rest of an open device in pieces, since it may never end. `place` names it in errors.
Result<QByteArray> readDevice(const QString &place, QIODevice &device, qint64 most);

/// An error in a file's content, with the file's path before its place.
InputError errorIn(const QString &path, InputError error);

/// The error where a listener ended the reading.
InputError readingCancelled(const QString &place);

/// Replaces a file in one step: after an error the old content remains. What is no regular file (a
/// device, a pipe) is written to directly.
std::optional<InputError> writeFile(const QString &path, const QByteArray &content,
                                    WrittenAs as = WrittenAs::Export);

} // namespace pixelplumb
