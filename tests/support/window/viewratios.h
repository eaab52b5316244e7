// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>

#include <array>

namespace pixelplumb {

/// Where device pixels lie in a widget drawn at a given ratio.
struct Ratio {
    double devicePixelRatio;
    QPointF fraction; ///< of the widget's corner
};
/// The ratios of ordinary screens; at 1.5 a widget may begin between two device pixels.
inline const std::array ratios
    = {Ratio{1, {}}, Ratio{1.5, {}}, Ratio{1.5, {0.5, 0.5}}, Ratio{2, {}}};

} // namespace pixelplumb
