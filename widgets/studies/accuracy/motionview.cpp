// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/accuracy/motionview.h"

#include "core/compare/motionstudy.h"
#include "core/frame/framebuffer.h"
#include "core/runs/tracedscene.h"
#include "widgets/canvas/canvaspainter.h"
#include "widgets/look/framepainter.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"

namespace pixelplumb {

namespace {

constexpr double leastMarkedCell = 3; // logical pixels: a frame would hide a smaller one

} // namespace

MotionPicture motionPicture(const Scene &scene, int frame)
{
    const SceneRun moved(sceneAtFrame(scene, frame));
    const FrameBuffer buffer(scene.frame);
    const FrameBuffer truth(scene.frame);
    const FrameBuffer empty(scene.frame);
    moved.draw(buffer.view());
    moved.drawTruth(truth.view());
    MotionPicture picture{scene.frame, buffer.copy(), {}, {}, {}};
    for (const QPoint &at : toggledPixels(scene, frame))
        picture.toggled.emplace_back(scene.frame.firstColumn + at.x(),
                                     int(rowOfPictureLine(scene.frame, at.y())));
    forEachPixel(scene.frame, picture.image.rect(), [&](const QPoint &at) {
        const auto isPainted = [&](const FrameBuffer &drawn) {
            return *drawn.view().at(at.x(), at.y()) != *empty.view().at(at.x(), at.y());
        };
        if (isPainted(truth) && !isPainted(buffer))
            picture.missing.push_back(at);
    });
    for (std::size_t i = 0; i < moved.scene.triangles.size(); ++i) {
        const auto &[a, b, c] = moved.primitives.triangles[i].vertices;
        picture.outlines.push_back({a.position, b.position, c.position});
    }
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
        tr("%n pixels came or went", nullptr, int(picture.toggled.size())) + u", "_s
        + tr("%n pixels of the truth are missing", nullptr, int(picture.missing.size())));
    update();
}

void MotionView::paintEvent(QPaintEvent *)
{
    if (m_picture.image.isNull())
        return;
    QPainter painter(this);
    const ViewMapping mapping = ViewMapping::fitted(m_picture.frame, rect(), devicePixelRatioF());
    const QRect device = mapping.deviceRect(rect()) & mapping.devicePicture();
    QImage cells;
    enlargePicture(m_picture.image, mapping, device, cells);
    cells.setDevicePixelRatio(devicePixelRatioF());
    painter.drawImage(mapping.positionOfDevice(device.topLeft()), cells);
    FramePainter frame(painter, mapping, palette(), rect());
    for (const std::array<LatticePoint, 3> &outline : m_picture.outlines)
        frame.drawOutline(outline, {});
    if (cellSideOf(mapping) < leastMarkedCell)
        return;
    for (const QPoint &pixel : m_picture.missing)
        paintMark(painter, mapping.cellOf(pixel), Sign::Missing, palette());
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(signColour(Sign::Changed, palette()), 1.5));
    for (const QPoint &pixel : m_picture.toggled)
        painter.drawRect(mapping.cellOf(pixel).adjusted(1, 1, -1, -1));
}

} // namespace pixelplumb
