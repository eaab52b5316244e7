// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/viewmapping.h"

#include <QColor>
#include <QImage>

namespace pixelplumb {

/// Enlarges or thins out the part of a picture that a rectangle of device pixels shows: each device
/// pixel is a copy of one pixel, the one that ViewMapping::pixelAt finds there. Costs as much as
/// the rectangle is large, whatever the size of the picture.
///
/// `device` must lie inside mapping.devicePicture(). `shown` is given the rectangle's size and
/// keeps its memory where it has it already.
void enlargePicture(const QImage &picture, const ViewMapping &mapping, const QRect &device,
                    QImage &shown);

/// Writes the pixels' bytes into their cells, where these have room for them and are not too many
/// to be read. `area`: the part of the widget that is seen.
void drawValues(QPainter &painter, const FrameBuffer &frame, const ViewMapping &mapping,
                const QRectF &area, ByteNotation notation);

/// Draws the lines between cells into an enlarged picture, on the first device pixels of each cell.
void blendGrid(QImage &shown, const ViewMapping &mapping, const QRect &device,
               const QColor &colour);

} // namespace pixelplumb
