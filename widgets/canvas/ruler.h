// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/signs.h"
#include "widgets/look/viewmapping.h"

#include <QtGui>

#include <span>
#include <vector>

namespace pixelplumb {

enum class TickKind { Labelled, Plain };

struct RulerTick {
    std::int64_t value = 0; ///< px, in the scene's coordinates
    TickKind kind = TickKind::Plain;

    friend bool operator==(const RulerTick &, const RulerTick &) = default;
};

/// 1, 2 or 5 times a power of ten: the smallest for which a step of that many px is at least as
/// long as `leastLength`, where one px is `pixelLength` long.
std::int64_t rulerStep(double pixelLength, double leastLength);

/// The ticks at whole px in [first, last]: labelled ones at least `leastLabelLength` apart, plain
/// ones between them at least `leastTickLength` apart.
std::vector<RulerTick> rulerTicks(double first, double last, double pixelLength,
                                  double leastLabelLength, double leastTickLength);

/// Something that a ruler points out at a sample coordinate.
struct RulerMark {
    double sample = 0; ///< px
    Sign sign = Sign::CurrentColumn;
};

/// The scale along one side of the frame, in the scene's coordinates: with half-integer pixel
/// centres its ticks are between the cells.
class Ruler {
public:
    Ruler(Qt::Orientation orientation, const QRectF &rect, const ViewMapping &mapping);

    void paint(QPainter &painter, const QPalette &palette, std::span<const RulerMark> marks) const;

private:
    bool isHorizontal() const { return m_orientation == Qt::Horizontal; }
    /// The ruler position of a sample coordinate.
    double along(double sample) const;
    /// The side that touches the frame's view, and the direction away from it.
    double innerSide() const;
    double outward() const;
    void paintTick(QPainter &painter, const RulerTick &tick) const;
    void paintMark(QPainter &painter, const QPalette &palette, const RulerMark &mark) const;

    Qt::Orientation m_orientation;
    QRectF m_rect;
    ViewMapping m_mapping;
};

/// The room that rulers need for their labels, in logical pixels.
double columnRulerHeight(const QFontMetricsF &metrics);
double rowRulerWidth(const QFontMetricsF &metrics, const FrameSpec &frame);

} // namespace pixelplumb
