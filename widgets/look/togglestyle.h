// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

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

} // namespace pixelplumb
