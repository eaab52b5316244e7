// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace pixelplumb {

/// Fusion, but that a tool button that can be switched on has a frame, and a tint while it is on:
/// Fusion draws one that is off as a label, and darkens one that is on, which on a dark window is
/// not to be seen. The outline of a check box, of a menu's and a list's too, is lighter for the
/// same reason.
class ToggleStyle : public QProxyStyle {
    Q_OBJECT

public:
    ToggleStyle();

    void drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
                            QPainter *painter, const QWidget *widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override;
};

} // namespace pixelplumb
