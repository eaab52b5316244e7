// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/window/openwindow.h"

#include "tests/support/sourcetree.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/appearance.h"
#include "widgets/model/scenedocument.h"
#include "widgets/window/paneldock.h"

#include <QTest>
#include <QtWidgets>

#include <algorithm>
#include <map>

namespace pixelplumb {

namespace {

void showActive(MainWindow &window)
{
    window.show();
    window.activateWindow();
    if (!QTest::qWaitForWindowActive(&window))
        QTest::qFail("the window does not become active", __FILE__, __LINE__);
}

void show(MainWindow &window)
{
    showActive(window);
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
    if (!window->openScene(resource(u"/scenes/"_s) + sceneFile))
        QTest::qFail(qPrintable(sceneFile), __FILE__, __LINE__);
    show(*window);
    return window;
}

std::unique_ptr<MainWindow> windowOf(const QSize &size)
{
    auto window = std::make_unique<MainWindow>();
    window->resize(size);
    action(*window, "resetLayout")->trigger();
    window->openDefaultScene();
    showActive(*window);
    settle();
    return window;
}

void settle()
{
    for (int round = 0; round < 6; ++round)
        QCoreApplication::processEvents();
}

void buildPanelsOf(const QObject &window)
{
    for (auto *dock : window.findChildren<PanelDock *>())
        dock->panel();
}

QAction *action(const MainWindow &window, const char *name) { return named<QAction>(window, name); }

void clickPixel(const MainWindow &window, const QPoint &pixel)
{
    Canvas *canvas = window.parts().canvas;
    QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->positionOf(pixel).toPoint());
}

bool isMarked(const MainWindow &window, const QPoint &pixel, Sign sign)
{
    Canvas &canvas = *window.parts().canvas;
    const QImage seen = canvas.grab(canvas.mapping().cellOf(pixel).toAlignedRect()).toImage();
    const QRgb colour = signColour(sign, canvas.palette()).rgb();
    for (int y = 0; y < seen.height(); ++y) {
        for (int x = 0; x < seen.width(); ++x) {
            if (seen.pixel(x, y) == colour)
                return true;
        }
    }
    return false;
}

void drop(MainWindow &window, const QMimeData &data)
{
    const QPoint place = window.rect().center();
    QDragEnterEvent enter(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent dropped(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &dropped);
}

void dropFile(MainWindow &window, const QString &path)
{
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    drop(window, data);
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
        picture.save(u"%1/%2-%3.png"_s.arg(QString::fromLocal8Bit(folder), name,
                                           QLatin1String(QTest::currentDataTag())));
    return picture;
}

QString readingFault(const QWidget &part)
{
    QWidget *whole = part.window();
    const QImage picture = whole->grab(QRect(part.mapTo(whole, QPoint()), part.size())).toImage();
    std::map<QRgb, int> pixelsOf;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x)
            ++pixelsOf[picture.pixel(x, y)];
    }
    using Frequency = std::pair<const QRgb, int>;
    const QColor ground
        = QColor::fromRgb(std::ranges::max_element(pixelsOf, {}, &Frequency::second)->first);
    const QColor window = QApplication::palette().color(QPalette::Window);
    if (contrastRatio(ground, window) > 1.5)
        return u"%1 is drawn on %2, the window on %3"_s.arg(part.objectName(), ground.name(),
                                                            window.name());
    int readable = 0;
    for (const auto &[colour, pixels] : pixelsOf)
        readable += contrastRatio(QColor::fromRgb(colour), ground) >= 4.5 ? pixels : 0;
    // A word has about 100 pixels.
    return readable >= 100
        ? QString()
        : u"%1 has %2 pixels that stand out"_s.arg(part.objectName()).arg(readable);
}

} // namespace pixelplumb
