// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/primitiverejection.h"
#include "core/geometry/shape.h"

#include <QString>

#include <memory>
#include <optional>

namespace pixelplumb {

/// The outlines of a text's glyphs as a polygon on the lattice, to be filled by winding number: a
/// font's contours may overlap, and holes run the other way round.
struct TextOutlines {
    Shape polygon;
    std::optional<PrimitiveRejection> rejection; ///< then the polygon has no vertices
};

/// The glyphs stand one after the other by the font's advance widths; there is no kerning, no
/// shaping and no line break, and a character that the font lacks is its box. Everything is integer
/// arithmetic on the font's own units, unhinted, with each point brought to the nearest lattice
/// point, so that the same text has the same outlines everywhere. Curves become chains of chords
/// that leave them by 1/32 px at most.
/// Rejected: FontMissing, NoOutline where no character leaves a mark, and NotRepresentable where a
/// point lies beyond ±2^30 px.
TextOutlines outlinesOf(const Shape &text);
/// The same, kept until another text is asked for: of 100,000 characters they take a second, and
/// every look at a pixel asks. On any thread.
std::shared_ptr<const TextOutlines> sharedOutlinesOf(const Shape &text);

/// How far along the baseline the next glyph after a text would stand, lattice units, down to a
/// whole one; 0 without the font. Never negative, whichever way y grows.
Lattice advanceOf(const Shape &text);

/// The file of DejaVu Sans among the system's and the user's fonts; empty where there is none.
/// The font is read from the file, without a font system, so that a program without a display or a
/// QGuiApplication can do it, on any thread.
QString textFontFile();

} // namespace pixelplumb
