// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

#include <span>

namespace pixelplumb {

using namespace Qt::StringLiterals;

/// A fill's name in files, for one kind of shape.
struct FillName {
    const char *name;
    ShapeFill fill;
};

/// The fills that a kind of shape may have in files, its default first; none where there is no
/// choice. A circle never crosses itself, so both fill rules agree on it.
inline std::span<const FillName> fillNamesOf(PrimitiveKind kind)
{
    static constexpr FillName ofCircles[]
        = {{"outline", ShapeFill::Outline}, {"filled", ShapeFill::NonZero}};
    static constexpr FillName ofPolygons[] = {{"even-odd", ShapeFill::EvenOdd},
                                              {"non-zero", ShapeFill::NonZero},
                                              {"outline", ShapeFill::Outline}};
    static constexpr FillName ofCurves[] = {{"outline", ShapeFill::Outline},
                                            {"even-odd", ShapeFill::EvenOdd},
                                            {"non-zero", ShapeFill::NonZero}};
    switch (kind) {
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
        return ofCircles;
    case PrimitiveKind::Polygon:
        return ofPolygons;
    case PrimitiveKind::Bezier:
        return ofCurves;
    case PrimitiveKind::Triangle:
    case PrimitiveKind::Point:
    case PrimitiveKind::Line:
    case PrimitiveKind::Text:
        break;
    }
    return {};
}

/// The key that names a kind of primitive in files: "triangle", "points", "line", …
inline QString keyOf(PrimitiveKind kind)
{
    return kind == PrimitiveKind::Point ? u"points"_s : nameOf(kind);
}

} // namespace pixelplumb
