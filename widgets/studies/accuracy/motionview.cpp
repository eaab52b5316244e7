// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/accuracy/motionview.h"

#include "core/compare/motionstudy.h"
#include "core/frame/framebuffer.h"
#include "core/runs/tracedscene.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

/// The triangle's outline in pixels of the picture, from its top left corner.
QPolygonF outlineOf(const Triangle &triangle, const FrameSpec &frame)
{
    const double offset = double(sampleOffset(frame)) / unitsPerPixel;
    const int first = pictureLine(frame, frame.firstRow);
    const int perRow = pictureLine(frame, frame.firstRow + 1) - first;
    QPolygonF outline;
    for (const Vertex &vertex : triangle.vertices) {
        const double x = double(vertex.position.x) / unitsPerPixel - offset;
        const double y = double(vertex.position.y) / unitsPerPixel - offset;
        outline += QPointF(x - double(frame.firstColumn) + 0.5,
                           first + perRow * (y - double(frame.firstRow)) + 0.5);
    }
    return outline;
}

constexpr double leastMarkedCell = 3; // logical pixels: a frame would hide a smaller one
constexpr double leastSignCell = 7; // logical pixels: a smaller glyph is a blot
constexpr QColor outlineColour(150, 150, 150); // visible on black and on white

} // namespace

MotionPicture motionPicture(const Scene &scene, int frame)
{
    const SceneRun moved(sceneAtFrame(scene, frame));
    const FrameBuffer buffer(scene.frame);
    const FrameBuffer truth(scene.frame);
    const FrameBuffer empty(scene.frame);
    moved.draw(buffer.view());
    moved.drawTruth(truth.view());
    MotionPicture picture{buffer.copy(), toggledPixels(scene, frame), {}, {}};
    const QImage right = truth.copy();
    const QImage background = empty.copy();
    for (int y = 0; y < right.height(); ++y) {
        for (int x = 0; x < right.width(); ++x) {
            const QRgb unpainted = background.pixel(x, y);
            if (right.pixel(x, y) != unpainted && picture.image.pixel(x, y) == unpainted)
                picture.missing.emplace_back(x, y);
        }
    }
    for (const Triangle &triangle : moved.scene.triangles)
        picture.outlines.push_back(outlineOf(triangle, scene.frame));
    return picture;
}

MotionView::MotionView(QWidget *parent)
    : QWidget(parent)
{
    named(this, "motionView", tr("The current frame"));
}

void MotionView::setPicture(const MotionPicture &picture)
{
    m_picture = picture;
    setAccessibleDescription(
        tr("%n pixels came or went", nullptr, int(picture.toggled.size())) + QStringLiteral(", ")
        + tr("%n pixels of the truth are missing", nullptr, int(picture.missing.size())));
    update();
}

void MotionView::drawMissing(QPainter &painter, double cell) const
{
    const QColor colour = signColour(Sign::Missing, palette());
    QFont glyph = font();
    glyph.setPixelSize(std::max(1, int(cell * 0.9)));
    painter.setFont(glyph);
    for (const QPoint &pixel : m_picture.missing) {
        const QRectF place(pixel.x() * cell, pixel.y() * cell, cell, cell);
        painter.fillRect(place, palette().color(QPalette::Base));
        painter.setPen(colour);
        if (cell >= leastSignCell)
            painter.drawText(place, Qt::AlignCenter, signGlyph(Sign::Missing));
        else
            painter.fillRect(place.adjusted(1, 1, -1, -1), colour);
    }
}

void MotionView::paintEvent(QPaintEvent *)
{
    const QImage &image = m_picture.image;
    if (image.isNull())
        return;
    QPainter painter(this);
    const double fit = std::min(double(width()) / image.width(), double(height()) / image.height());
    const double cell = fit >= 1 ? std::floor(fit) : fit;
    painter.drawImage(QRectF(0, 0, cell * image.width(), cell * image.height()), image);
    painter.setClipRect(QRectF(0, 0, cell * image.width(), cell * image.height()));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(outlineColour, 1));
    for (const QPolygonF &outline : m_picture.outlines)
        painter.drawPolygon(QTransform::fromScale(cell, cell).map(outline));
    painter.setRenderHint(QPainter::Antialiasing, false);
    if (cell < leastMarkedCell)
        return;
    drawMissing(painter, cell);
    painter.setPen(QPen(signColour(Sign::Changed, palette()), 1.5));
    for (const QPoint &pixel : m_picture.toggled)
        painter.drawRect(QRectF(pixel.x() * cell + 1, pixel.y() * cell + 1, cell - 2, cell - 2));
}

} // namespace pixelplumb
