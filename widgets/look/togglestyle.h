// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace pixelplumb {

/// Fusion, but that a tool button that is switched on has a frame and a tint: Fusion darkens it,
/// which on a dark window is not to be seen.
class ToggleStyle : public QProxyStyle {
    Q_OBJECT

public:
    ToggleStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override;
};

} // namespace pixelplumb
