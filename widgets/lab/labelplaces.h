// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtCore>

#include <optional>
#include <vector>

namespace pixelplumb {

/// A dot of a chart and the size of its label, logical pixels of the chart.
struct LabelledDot {
    QPointF centre;
    QSizeF label; ///< empty: none
};

/// The rectangle a dot covers.
QRectF coveredBy(const QPointF &dot);

/// The surroundings of the dots.
struct LabelArea {
    QRectF whole; ///< labels stay in it
    std::vector<QRectF> others; ///< no label covers these, such as dots without one
    std::vector<QRectF> lines; ///< covered only where a label has no other place
    enum class Sides {
        All, ///< beside, above and below the dot
        Beside, ///< for close rows, where a label above a dot would seem to be another's
    } sides
        = Sides::All;
};

/// Places labels so that none covers another or a dot, or is as near to another dot as to its own;
/// none where there is no room. Earlier dots choose first.
std::vector<std::optional<QRectF>> placeLabels(const std::vector<LabelledDot> &dots,
                                               const LabelArea &area);

} // namespace pixelplumb
