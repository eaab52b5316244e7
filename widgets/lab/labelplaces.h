// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QSizeF>

#include <optional>
#include <vector>

namespace pixelplumb {

/// A dot of a chart and the size of its label, logical pixels of the chart.
struct LabelledDot {
    QPointF centre;
    QSizeF label; ///< empty: none
};

/// What a dot covers.
QRectF coveredBy(const QPointF &dot);

/// What stands around the dots.
struct LabelArea {
    QRectF whole; ///< that labels stay in
    std::vector<QRectF> others; ///< that no label covers, such as dots without one
    std::vector<QRectF> lines; ///< that a label covers only where there is no other place for it
    enum class Sides {
        All, ///< beside, above and below the dot
        Beside, ///< where rows are so close that what stands above a dot seems to be another's
    } sides
        = Sides::All;
};

/// Where labels stand so that none covers another or a dot, or stands as near to another dot as to
/// its own; none where there is no room for it. The first dots choose first.
std::vector<std::optional<QRectF>> placeLabels(const std::vector<LabelledDot> &dots,
                                               const LabelArea &area);

} // namespace pixelplumb
