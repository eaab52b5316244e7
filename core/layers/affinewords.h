// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/affinemap.h"

#include <QString>
#include <QStringList>

/// What the layer of the affine map says of its numbers: exact fractions or, if one in a sentence
/// is long, the whole sentence rounded and marked by ≈.
namespace pixelplumb {

/// "(27/2, 9)", px.
QString pointText(const RationalPoint &point);
/// The two rows of a map, which form one sentence.
QStringList rowsText(const AffineMap &map);
QString weightsText(const PointAreas &areas);
QString areasText(const PointAreas &areas);
/// The factor by which the map scales areas, and whether it mirrors.
QString areasChangeText(const AffineMap &map);

} // namespace pixelplumb
