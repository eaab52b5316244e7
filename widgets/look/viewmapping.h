// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/frame/framespec.h"
#include "core/geometry/lattice.h"

#include <QtGui>

#include <optional>

namespace pixelplumb {

/// How large a frame pixel is on the screen: devicePixels : framePixels, one of which is 1, so that
/// all cells of the picture have the same whole number of device pixels.
struct ViewZoom {
    /// The limit in either direction; at three device pixels per logical one, cells still have room
    /// for numbers.
    static constexpr int largest = 128;

    int devicePixels = 1;
    int framePixels = 1;

    /// One number for both directions: 8 is 8 device pixels per frame pixel, −4 is 4 frame pixels
    /// per device pixel. 0 and −1 are 1:1; others are clamped to ±largest.
    static ViewZoom fromNumber(int number);
    int number() const { return framePixels > 1 ? -framePixels : devicePixels; }
    double factor() const { return double(devicePixels) / framePixels; }

    ViewZoom nextLarger() const;
    ViewZoom nextSmaller() const;

    friend bool operator==(const ViewZoom &, const ViewZoom &) = default;
};

/// Where the frame is in a widget. It relates three kinds of coordinates:
///
/// - sample coordinates, in lattice units: pixel (x, y) is the sample at (x, y), and its cell
///   extends half a pixel to each side of it;
/// - device pixels of the window's grid, whole numbers: cell edges lie on them;
/// - logical positions in the widget, as events and painters use them.
///
/// At a fractional device pixel ratio the widget's own corner may lie between device pixels; the
/// mapping includes that fraction, so that what is drawn and what is hit stay the same.
class ViewMapping {
public:
    ViewMapping() = default;
    /// `origin`: the device pixel at the upper left corner of the picture. `fraction`: where the
    /// widget's corner lies in its device pixel, 0 ≤ each < 1.
    ViewMapping(const FrameSpec &frame, const ViewZoom &zoom, const QPoint &origin,
                double devicePixelRatio = 1, const QPointF &fraction = {});

    /// The whole frame in the middle of a view, as large as it fits.
    static ViewMapping fitted(const FrameSpec &frame, const QRectF &view, double devicePixelRatio,
                              const QPointF &fraction = {});

    const FrameSpec &frame() const { return m_frame; }
    const ViewZoom &zoom() const { return m_zoom; }
    QPoint origin() const { return m_origin; }
    double devicePixelRatio() const { return m_devicePixelRatio; }
    QPointF fraction() const { return m_fraction; }

    /// This mapping at another zoom, with the same point under the anchor.
    ViewMapping zoomedAt(const QPointF &anchor, const ViewZoom &zoom) const;
    ViewMapping movedBy(const QPoint &devicePixels) const;
    /// This mapping, moved no more than needed to keep part of the frame inside the view.
    ViewMapping keptInside(const QRectF &view) const;

    QPoint deviceAt(const QPointF &position) const;
    QPointF positionOfDevice(const QPointF &device) const;
    /// The device pixels that a rectangle of the widget touches.
    QRect deviceRect(const QRectF &rect) const;

    /// The pixel drawn under a position; none outside the frame.
    std::optional<QPoint> pixelAt(const QPointF &position) const;
    /// The column or row drawn under a position, inside the frame or not.
    std::int64_t columnAt(const QPointF &position) const;
    std::int64_t rowAt(const QPointF &position) const;
    /// The sample point under a position, inside the frame or not.
    LatticePoint latticeAt(const QPointF &position) const;

    /// The middle device pixel of a cell, as an event there would report its position.
    QPointF positionOf(const QPoint &pixel) const;
    /// The position of a sample point, given in px of sample coordinates.
    QPointF positionOf(double x, double y) const;
    QPointF positionOf(const LatticePoint &point) const;
    /// A pixel's cell.
    QRect deviceCellOf(const QPoint &pixel) const;
    QRectF cellOf(const QPoint &pixel) const;

    /// The picture's rectangle, and the part of it that a device rectangle shows, in columns and
    /// lines of the picture, 0 at its upper left.
    QRect devicePicture() const;
    QRect pictureIn(const QRect &device) const;
    /// The column or line of the picture at a device pixel.
    int pictureColumnAt(int deviceX) const;
    int pictureLineAt(int deviceY) const;

    friend bool operator==(const ViewMapping &, const ViewMapping &) = default;

private:
    FrameSpec m_frame;
    ViewZoom m_zoom;
    QPoint m_origin;
    double m_devicePixelRatio = 1;
    QPointF m_fraction;
};

/// Calls `use(pixel)` for the frame's pixels in a part of its picture (ViewMapping::pictureIn()),
/// line by line.
template <class Use>
void forEachPixel(const FrameSpec &frame, const QRect &part, const Use &use)
{
    for (int line = part.top(); line <= part.bottom(); ++line) {
        const auto y = int(rowOfPictureLine(frame, line));
        for (int column = part.left(); column <= part.right(); ++column)
            use(QPoint(frame.firstColumn + column, y));
    }
}

/// The picture of the frame in which a pixel has the colour `colourAt(pixel)`.
template <class ColourAt>
QImage pictureWith(const FrameSpec &frame, const ColourAt &colourAt,
                   QImage::Format format = QImage::Format_RGB32)
{
    QImage picture(frame.width, frame.height, format);
    auto *next = reinterpret_cast<QRgb *>(picture.bits()); // four bytes a pixel: lines have no gaps
    forEachPixel(frame, picture.rect(), [&](const QPoint &pixel) { *next++ = colourAt(pixel); });
    return picture;
}

} // namespace pixelplumb
