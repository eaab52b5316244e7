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

/// Where labels stand so that none covers another, a dot or one of the others, such as lines and
/// dots without a label: beside, above or below its dot, within the area; none where there is no
/// room for it. The first dots choose first.
std::vector<std::optional<QRectF>> placeLabels(const std::vector<LabelledDot> &dots,
                                               const std::vector<QRectF> &others,
                                               const QRectF &area);

} // namespace pixelplumb
