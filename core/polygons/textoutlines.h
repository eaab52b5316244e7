// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/primitiverejection.h"
#include "core/geometry/shape.h"
#include "core/polygons/contours.h"

#include <QString>

#include <memory>
#include <optional>

namespace pixelplumb {

/// The outlines of a text's glyphs as a polygon on the lattice, filled non-zero: a font's contours
/// may overlap, and holes run the other way round.
struct TextOutlines {
    Shape polygon;
    Contours
        contours; ///< of the polygon; runs refer to them, since they may have millions of edges
    std::optional<PrimitiveRejection> rejection; ///< then the polygon has no vertices
};

/// Places the glyphs one after another by the font's advance widths, without kerning, shaping or
/// line breaks; a character that the font lacks is shown as its box. All arithmetic is integer, on
/// the font's own units, unhinted, with each point snapped to the nearest lattice point, so that a
/// text has the same outlines everywhere. Curves become chains of chords that deviate from them by
/// at most 1/32 px.
/// Rejected: FontMissing, NoOutline where no character leaves a mark, and OutlineTooLarge where a
/// point lies beyond ±2^30 px.
TextOutlines outlinesOf(const Shape &text);
/// Like outlinesOf(), but cached until another text is requested: 100,000 characters take a second,
/// and every look at a pixel needs them. Callable on any thread.
std::shared_ptr<const TextOutlines> sharedOutlinesOf(const Shape &text);

/// The distance along the baseline to the next glyph after a text, lattice units, rounded down; 0
/// without the font. Never negative, whichever way y grows.
Lattice advanceOf(const Shape &text);

/// The file of DejaVu Sans among the system's and the user's fonts; empty where there is none. The
/// font is read from its file, without a font system, so that it works without a display or a
/// QGuiApplication, on any thread.
QString textFontFile();

} // namespace pixelplumb
