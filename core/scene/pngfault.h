// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace pixelplumb {

/// Where a PNG is broken, even where a decoder would take it; empty of a whole one and of what is
/// no PNG. A chunk that no decoder needs may be broken.
QString pngFault(const QByteArray &content);

/// A whole PNG with what its pixels need alone: its decoder writes to the terminal what it thinks
/// of other chunks.
QByteArray plainPng(const QByteArray &content);

} // namespace pixelplumb
