// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/viewmapping.h"

#include <QColor>
#include <QImage>

namespace pixelplumb {

/// Enlarges or thins out the part of a picture that a rectangle of device pixels shows: each device
/// pixel copies the one pixel that ViewMapping::pixelAt finds there. The cost depends on the size
/// of the rectangle, not of the picture.
///
/// `device` must lie inside mapping.devicePicture(). `shown` takes the rectangle's size and reuses
/// its memory where the size is unchanged.
void enlargePicture(const QImage &picture, const ViewMapping &mapping, const QRect &device,
                    QImage &shown);

/// Writes the pixels' bytes into their cells, where these have room and are few enough to be read.
/// `area`: the visible part of the widget.
void drawValues(QPainter &painter, const FrameBuffer &frame, const ViewMapping &mapping,
                const QRectF &area, ByteNotation notation);

/// Draws the grid lines into an enlarged picture, on the first device pixels of each cell.
void blendGrid(QImage &shown, const ViewMapping &mapping, const QRect &device,
               const QColor &colour);

} // namespace pixelplumb
