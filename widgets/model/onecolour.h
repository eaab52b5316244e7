// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

namespace pixelplumb {

/// Whether a primitive is painted in one colour, that of its first vertex. A document gives it to
/// all of its vertices, so that their handles have the visible colour.
constexpr bool hasOneColour(PrimitiveKind kind)
{
    switch (kind) {
    case PrimitiveKind::Triangle:
    case PrimitiveKind::Point:
    case PrimitiveKind::Line:
        return false;
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
    case PrimitiveKind::Bezier:
    case PrimitiveKind::Polygon:
    case PrimitiveKind::Text:
        break;
    }
    return true;
}

} // namespace pixelplumb
