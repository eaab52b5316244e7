// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/openwindow.h"

#include "tests/support/sourcetree.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/appearance.h"
#include "widgets/model/scenedocument.h"

#include <QTest>

namespace pixelplumb {

namespace {

void show(MainWindow &window)
{
    window.show();
    window.activateWindow();
    if (!QTest::qWaitForWindowActive(&window))
        QTest::qFail("the window does not become active", __FILE__, __LINE__);
    window.parts().canvas->setFocus();
}

} // namespace

std::unique_ptr<MainWindow> openedWindow()
{
    auto window = std::make_unique<MainWindow>();
    window->openDefaultScene();
    show(*window);
    return window;
}

std::unique_ptr<MainWindow> openedWindow(const Scene &scene)
{
    auto window = std::make_unique<MainWindow>();
    window->parts().document->reset(scene);
    show(*window);
    return window;
}

std::unique_ptr<MainWindow> openedWindow(const QString &sceneFile)
{
    auto window = std::make_unique<MainWindow>();
    if (!window->openScene(resource(QStringLiteral("/scenes/")) + sceneFile))
        QTest::qFail(qPrintable(sceneFile), __FILE__, __LINE__);
    show(*window);
    return window;
}

QAction *action(const MainWindow &window, const char *name) { return named<QAction>(window, name); }

void clickPixel(const MainWindow &window, const QPoint &pixel)
{
    Canvas *canvas = window.parts().canvas;
    QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->positionOf(pixel).toPoint());
}

void addPalettes()
{
    QTest::addColumn<QPalette>("palette");
    QTest::newRow("light") << lightPalette();
    QTest::newRow("dark") << darkPalette();
}

QImage grabbed(MainWindow &window, const QString &name)
{
    QImage picture = window.grab().toImage();
    const QByteArray folder = qgetenv("PIXELPLUMB_GRABS");
    if (!folder.isEmpty())
        picture.save(
            QStringLiteral("%1/%2-%3.png")
                .arg(QString::fromLocal8Bit(folder), name, QLatin1String(QTest::currentDataTag())));
    return picture;
}

} // namespace pixelplumb
