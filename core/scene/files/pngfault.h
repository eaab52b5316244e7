// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace pixelplumb {

/// Where a PNG is broken, even where a decoder would accept it; empty for a whole one and for other
/// files. Chunks that no decoder needs may be broken.
QString pngFault(const QByteArray &content);

/// A whole PNG reduced to what its pixels need: its decoder prints remarks about other chunks to
/// the terminal.
QByteArray plainPng(const QByteArray &content);

} // namespace pixelplumb
