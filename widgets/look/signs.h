// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/difference.h"

#include <QtGui>

namespace pixelplumb {

/// The things that have one colour and one glyph everywhere in the window.
enum class Sign {
    LowerEdge, ///< y_B
    UpperEdge, ///< y_T
    CurrentColumn, ///< the plumb line
    PickedPixel,
    Missing, ///< ?
    Extra, ///< !
    ColourDiffers, ///< c
    Tie, ///< =
    Clamp, ///< ^
    FirstDifference, ///< ≠, on the scrubber
    VertexMark, ///< a vertex and its column on the scrubber
    Breakpoint,
    Changed, ///< a number that differs from the previous column's
};

/// A sign's colour from the Okabe–Ito set, darkened or lightened so that text in it keeps 4.5:1 on
/// the palette's base.
QColor signColour(Sign sign, const QPalette &palette);
/// The glyph that marks a sign in addition to its colour; empty where its position does so.
QString signGlyph(Sign sign);
Sign signOf(Difference difference); ///< of one other than None
bool isDark(const QPalette &palette);

/// The signs of a tape deck. They are drawn, because no font can be relied on to have them.
enum class StepSign { ToStart, Backward, Play, Pause, Forward, ToEnd };

/// An icon in the palette's current text colour, also when disabled, at any size.
QIcon stepIcon(StepSign sign);

/// The colour at an opacity of 0 … 1.
inline QColor translucent(QColor colour, double opacity)
{
    colour.setAlphaF(float(opacity));
    return colour;
}

/// `base` with a share (0 … 1) of `tint` mixed in, channel by channel.
inline QColor blended(const QColor &base, const QColor &tint, float share)
{
    const auto mix = [share](float from, float to) { return from + (to - from) * share; };
    return QColor::fromRgbF(mix(base.redF(), tint.redF()), mix(base.greenF(), tint.greenF()),
                            mix(base.blueF(), tint.blueF()));
}

} // namespace pixelplumb
