// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picturediff.h"

#include <QImage>
#include <QJsonObject>
#include <QStringList>

namespace pixelplumb::cli {

/// How many pixels have which verdict, and what would explain them.
QStringList textOf(const PictureDiff &diff);
QJsonObject jsonOf(const PictureDiff &diff);

/// The expected picture, faint and grey, with the differing pixels marked (Okabe and Ito's
/// colours): vermilion missing, blue extra, purple another colour, yellow undecidable.
QImage markedPicture(const PictureDiff &diff, const Picture &expected);

} // namespace pixelplumb::cli
