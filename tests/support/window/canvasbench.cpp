// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/window/canvasbench.h"

#include "tests/support/scanning.h"

#include <QTest>
#include <QtWidgets>

namespace pixelplumb {

Scene firstScene()
{
    Scene scene;
    scene.triangles = {triangleAt(4, 5, 58, 12, 26, 44)};
    return scene;
}

CanvasBench::CanvasBench(const Scene &scene)
{
    QObject::connect(&document, &SceneDocument::sceneChanged, &playhead,
                     [this] { playhead.setTraced(traceScene(document.scene())); });
    document.reset(scene);
    canvas.resize(700, 520);
    canvas.show();
    canvas.activateWindow();
    canvas.setFocus();
    [[maybe_unused]] const bool active = QTest::qWaitForWindowActive(&canvas);
}

void CanvasBench::click(int x, int y, Qt::MouseButton button)
{
    QTest::mouseClick(&canvas, button, {}, at(x, y));
}

void CanvasBench::send(QEvent::Type type, const QPoint &position, Qt::MouseButton button,
                       Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers)
{
    QMouseEvent event(type, position, canvas.mapToGlobal(position), button, buttons, modifiers);
    QApplication::sendEvent(&canvas, &event);
}

void CanvasBench::drag(const QPoint &from, const QPoint &to, Qt::MouseButton button,
                       Qt::KeyboardModifiers modifiers)
{
    send(QEvent::MouseButtonPress, from, button, button, modifiers);
    for (int step = 1; step <= 8; ++step)
        send(QEvent::MouseMove, from + (to - from) * step / 8, Qt::NoButton, button, modifiers);
    send(QEvent::MouseButtonRelease, to, button, {}, modifiers);
}

QRgb shownAt(const QImage &grabbed, const Canvas &canvas, const QPoint &pixel)
{
    const QPointF device = canvas.positionOf(pixel) * grabbed.devicePixelRatio();
    return grabbed.pixel(device.toPoint());
}

} // namespace pixelplumb
