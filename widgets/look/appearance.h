// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

#include <optional>

namespace pixelplumb {

/// Fusion with frames and tints for checkable tool buttons: Fusion draws an unchecked one as a
/// label and darkens a checked one, which cannot be seen in a dark window. The outlines of check
/// boxes, also in menus and lists, are lighter for the same reason.
class ToggleStyle : public QProxyStyle {
    Q_OBJECT

public:
    ToggleStyle();

    void drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
                            QPainter *painter, const QWidget *widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override;
};

/// The relative luminance of WCAG 2.1: 0 for black, 1 for white.
double luminance(const QColor &colour);

enum class PaletteChoice { System, Light, Dark };

/// "light", "dark", "system": on the command line and in the settings.
QString nameOf(PaletteChoice choice);
std::optional<PaletteChoice> paletteNamed(QStringView name);

/// Both keep at least 4.5:1 between text and its background, 3:1 for disabled text.
QPalette lightPalette();
QPalette darkPalette();

/// The contrast of two opaque colours after WCAG 2.1, 1 … 21.
double contrastRatio(const QColor &a, const QColor &b);

/// The font itself when its ten digits are equally wide, else DejaVu, Noto or Liberation Sans, the
/// first with such digits; failing these, the font itself.
QFont withTabularFigures(const QFont &font);

/// Gives the whole program the Fusion style, the chosen palette and a font with tabular figures.
/// PaletteChoice::System is light or dark as the desktop was when the program started.
void applyAppearance(PaletteChoice choice);

} // namespace pixelplumb
