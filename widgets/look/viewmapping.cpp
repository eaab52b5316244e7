// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/viewmapping.h"

#include "core/frame/framebuffer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelplumb {

namespace {

// Each step is a factor between 1.2 and 2; from 1 to 64 a wheel needs fifteen notches.
constexpr std::array zoomSteps = {-64, -48, -32, -24, -16, -12, -8, -6, -4, -3, -2, 1,  2,  3,  4,
                                  5,   6,   8,   10,  12,  16,  20, 24, 32, 40, 48, 64, 96, 128};

// Event positions are device pixels divided by the ratio; the product may fall short of the integer
// by a few units in the last place.
constexpr double hair = 1e-6;

/// The part of the frame that always stays visible when moved, in device pixels.
constexpr int leastVisible = 24;

/// The frame pixel of the picture at a device pixel; below 1:1, the middle one of those that share
/// it.
std::int64_t picturePixelAt(int device, int origin, const ViewZoom &zoom)
{
    return floorDivide(std::int64_t(device - origin) * zoom.framePixels + zoom.framePixels / 2,
                       std::int64_t(zoom.devicePixels));
}

/// picturePixelAt() in lattice units from the picture's edge.
Lattice pictureUnitsAt(int device, int origin, const ViewZoom &zoom)
{
    if (zoom.framePixels > 1)
        return picturePixelAt(device, origin, zoom) * unitsPerPixel + unitsPerPixel / 2;
    const std::int64_t doubled = 2 * std::int64_t(device - origin) * unitsPerPixel;
    return floorDivide(doubled + zoom.devicePixels, 2 * std::int64_t(zoom.devicePixels));
}

int deviceLength(std::int32_t framePixels, const ViewZoom &zoom)
{
    return (framePixels * zoom.devicePixels + zoom.framePixels - 1) / zoom.framePixels;
}

/// The largest zoom at which `framePixels` fit into `devicePixels`.
int fittingZoom(std::int32_t framePixels, int devicePixels)
{
    const int device = std::max(devicePixels, 1);
    if (framePixels <= device)
        return std::min(device / framePixels, ViewZoom::largest);
    return -std::min((framePixels + device - 1) / device, ViewZoom::largest);
}

/// How far an interval must move so that part of it stays in [first, first + length).
int distanceInto(int start, int extent, int first, int length)
{
    const int kept = std::min({leastVisible, extent, length});
    if (start + extent < first + kept)
        return first + kept - (start + extent);
    if (start > first + length - kept)
        return first + length - kept - start;
    return 0;
}

} // namespace

ViewZoom ViewZoom::fromNumber(int number)
{
    const int clamped = std::clamp(number, -largest, largest);
    if (clamped >= 1)
        return {clamped, 1};
    return {1, std::max(1, -clamped)};
}

ViewZoom ViewZoom::nextLarger() const
{
    const auto *const step = std::ranges::upper_bound(zoomSteps, number());
    return step == zoomSteps.end() ? *this : fromNumber(*step);
}

ViewZoom ViewZoom::nextSmaller() const
{
    const auto *const step = std::ranges::lower_bound(zoomSteps, number());
    return step == zoomSteps.begin() ? *this : fromNumber(*std::prev(step));
}

ViewMapping::ViewMapping(const FrameSpec &frame, const ViewZoom &zoom, const QPoint &origin,
                         double devicePixelRatio, const QPointF &fraction)
    : m_frame(frame)
    , m_zoom(zoom)
    , m_origin(origin)
    , m_devicePixelRatio(devicePixelRatio)
    , m_fraction(fraction)
{
}

ViewMapping ViewMapping::fitted(const FrameSpec &frame, const QRectF &view, double devicePixelRatio,
                                const QPointF &fraction)
{
    ViewMapping mapping(frame, {}, {}, devicePixelRatio, fraction);
    const QRect device = mapping.deviceRect(view);
    mapping.m_zoom = ViewZoom::fromNumber(std::min(fittingZoom(frame.width, device.width()),
                                                   fittingZoom(frame.height, device.height())));
    const QSize size = mapping.devicePicture().size();
    mapping.m_origin = device.topLeft()
        + QPoint((device.width() - size.width()) / 2, (device.height() - size.height()) / 2);
    return mapping;
}

ViewMapping ViewMapping::zoomedAt(const QPointF &anchor, const ViewZoom &zoom) const
{
    const QPoint device = deviceAt(anchor);
    const double growth = zoom.factor() / m_zoom.factor();
    // The middle of the device pixel under the anchor stays fixed, so that zooming in and out again
    // does not drift.
    const auto moved = [growth](int fixed, int origin) {
        return int(std::floor(fixed + 0.5 - (fixed + 0.5 - origin) * growth + 0.5));
    };
    return {m_frame,
            zoom,
            {moved(device.x(), m_origin.x()), moved(device.y(), m_origin.y())},
            m_devicePixelRatio,
            m_fraction};
}

ViewMapping ViewMapping::movedBy(const QPoint &devicePixels) const
{
    return {m_frame, m_zoom, m_origin + devicePixels, m_devicePixelRatio, m_fraction};
}

ViewMapping ViewMapping::keptInside(const QRectF &view) const
{
    const QRect device = deviceRect(view);
    const QRect picture = devicePicture();
    return movedBy({distanceInto(picture.x(), picture.width(), device.x(), device.width()),
                    distanceInto(picture.y(), picture.height(), device.y(), device.height())});
}

QPoint ViewMapping::deviceAt(const QPointF &position) const
{
    const QPointF device = position * m_devicePixelRatio + m_fraction;
    return {int(std::floor(device.x() + hair)), int(std::floor(device.y() + hair))};
}

QPointF ViewMapping::positionOfDevice(const QPointF &device) const
{
    return (device - m_fraction) / m_devicePixelRatio;
}

QRect ViewMapping::deviceRect(const QRectF &rect) const
{
    const QPointF end = rect.bottomRight() * m_devicePixelRatio + m_fraction;
    return {deviceAt(rect.topLeft()),
            QPoint(int(std::ceil(end.x() - hair)) - 1, int(std::ceil(end.y() - hair)) - 1)};
}

int ViewMapping::pictureColumnAt(int deviceX) const
{
    // Below 1:1 the last device pixel may cover fewer frame pixels than the others.
    const std::int64_t column = picturePixelAt(deviceX, m_origin.x(), m_zoom);
    const bool isLast = column >= m_frame.width && devicePicture().right() == deviceX;
    return isLast ? m_frame.width - 1 : int(column);
}

int ViewMapping::pictureLineAt(int deviceY) const
{
    const std::int64_t line = picturePixelAt(deviceY, m_origin.y(), m_zoom);
    const bool isLast = line >= m_frame.height && devicePicture().bottom() == deviceY;
    return isLast ? m_frame.height - 1 : int(line);
}

std::optional<QPoint> ViewMapping::pixelAt(const QPointF &position) const
{
    const QPoint device = deviceAt(position);
    if (!devicePicture().contains(device))
        return std::nullopt;
    return QPoint(m_frame.firstColumn + pictureColumnAt(device.x()),
                  int(rowOfPictureLine(m_frame, pictureLineAt(device.y()))));
}

std::int64_t ViewMapping::columnAt(const QPointF &position) const
{
    return std::int64_t(m_frame.firstColumn) + pictureColumnAt(deviceAt(position).x());
}

std::int64_t ViewMapping::rowAt(const QPointF &position) const
{
    return rowOfPictureLine(m_frame, pictureLineAt(deviceAt(position).y()));
}

LatticePoint ViewMapping::latticeAt(const QPointF &position) const
{
    const QPoint device = deviceAt(position);
    const Lattice right = pictureUnitsAt(device.x(), m_origin.x(), m_zoom);
    const Lattice down = pictureUnitsAt(device.y(), m_origin.y(), m_zoom);
    const Lattice leftEdge = m_frame.firstColumn * unitsPerPixel - unitsPerPixel / 2;
    const Lattice lowestEdge = m_frame.firstRow * unitsPerPixel - unitsPerPixel / 2;
    if (m_frame.origin == FrameOrigin::BottomLeft)
        return {leftEdge + right, lowestEdge + m_frame.height * unitsPerPixel - down};
    return {leftEdge + right, lowestEdge + down};
}

QPointF ViewMapping::positionOf(const QPoint &pixel) const
{
    const QRect cell = deviceCellOf(pixel);
    return positionOfDevice(cell.topLeft()
                            + QPoint((cell.width() - 1) / 2, (cell.height() - 1) / 2));
}

QPointF ViewMapping::positionOf(double x, double y) const
{
    const double right = x - m_frame.firstColumn + 0.5;
    const double up = y - m_frame.firstRow + 0.5;
    const double down = m_frame.origin == FrameOrigin::BottomLeft ? m_frame.height - up : up;
    return positionOfDevice(m_origin + QPointF(right, down) * m_zoom.factor());
}

QPointF ViewMapping::positionOf(const LatticePoint &point) const
{
    return positionOf(double(point.x) / unitsPerPixel, double(point.y) / unitsPerPixel);
}

QRect ViewMapping::deviceCellOf(const QPoint &pixel) const
{
    const QPoint picture(pixel.x() - m_frame.firstColumn, pictureLine(m_frame, pixel.y()));
    const auto deviceOf = [this](int picturePixel) {
        return int(floorDivide(std::int64_t(picturePixel) * m_zoom.devicePixels,
                               std::int64_t(m_zoom.framePixels)));
    };
    return {m_origin + QPoint(deviceOf(picture.x()), deviceOf(picture.y())),
            QSize(m_zoom.devicePixels, m_zoom.devicePixels)};
}

QRectF ViewMapping::cellOf(const QPoint &pixel) const
{
    const QRect device = deviceCellOf(pixel);
    return {positionOfDevice(device.topLeft()), QSizeF(device.size()) / m_devicePixelRatio};
}

QRect ViewMapping::devicePicture() const
{
    return {m_origin,
            QSize(deviceLength(m_frame.width, m_zoom), deviceLength(m_frame.height, m_zoom))};
}

QRect ViewMapping::pictureIn(const QRect &device) const
{
    const QRect shown = device & devicePicture();
    if (shown.isEmpty())
        return {};
    return {QPoint(pictureColumnAt(shown.left()), pictureLineAt(shown.top())),
            QPoint(pictureColumnAt(shown.right()), pictureLineAt(shown.bottom()))};
}

} // namespace pixelplumb
