// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>

namespace pixelplumb {

/// How the eye of a person sees colours: with three kinds of cones, or without one of them.
enum class ColourVision { Ordinary, Protanopia, Deuteranopia, Tritanopia };

/// "protanopia"; "ordinary vision".
QString nameOf(ColourVision vision);

/// The sRGB colour that looks to ordinary eyes as `colour` does to such ones; alpha stays. Greys
/// stay what they are.
///
/// By the matrices for severity 1 of [Machado 2009] (resources/sources.md), which act on linear
/// light; the one without blue cones is an approximation, as the authors say. What leaves the
/// display's colours is clamped.
QRgb seenWith(ColourVision vision, QRgb colour);

/// Every pixel of a picture, which becomes one of Format_ARGB32.
void seeWith(ColourVision vision, QImage &picture);

} // namespace pixelplumb
