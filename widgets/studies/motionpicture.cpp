// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/motionpicture.h"

#include "core/compare/motionstudy.h"
#include "core/frame/framebuffer.h"
#include "core/runs/tracedscene.h"

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

} // namespace pixelplumb
