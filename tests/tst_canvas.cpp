// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas.h"
#include "widgets/displayoptions.h"
#include "widgets/playhead.h"
#include "widgets/svgexport.h"
#include "widgets/vertexdialog.h"

#include <QAccessible>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QXmlStreamReader>

#include <ctime>

using namespace pixelplumb;

namespace {

Triangle triangleOf(const LatticePoint &a, const LatticePoint &b, const LatticePoint &c)
{
    return {{{{a, {{255, 0, 0}}}, {b, {{0, 255, 0}}}, {c, {{0, 0, 255}}}}}};
}

/// The design's first scene without its fraction.
Scene firstScene()
{
    Scene scene;
    scene.triangles = {triangleOf(latticePixel(4, 5), latticePixel(58, 12), latticePixel(26, 44))};
    return scene;
}

/// A canvas in a window of its own, traced anew at every change as the real window does.
struct Bench {
    SceneDocument document;
    Playhead playhead;
    DisplayOptions options;
    Canvas canvas{&document, &playhead, &options};

    explicit Bench(const Scene &scene = {})
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

    QPoint at(int x, int y) const { return canvas.positionOf(QPoint(x, y)).toPoint(); }
    void click(int x, int y, Qt::MouseButton button = Qt::LeftButton)
    {
        QTest::mouseClick(&canvas, button, {}, at(x, y));
    }
    void send(QEvent::Type type, const QPoint &position, Qt::MouseButton button,
              Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = {})
    {
        QMouseEvent event(type, position, canvas.mapToGlobal(position), button, buttons, modifiers);
        QApplication::sendEvent(&canvas, &event);
    }
    void drag(const QPoint &from, const QPoint &to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = {})
    {
        send(QEvent::MouseButtonPress, from, button, button, modifiers);
        for (int step = 1; step <= 8; ++step)
            send(QEvent::MouseMove, from + (to - from) * step / 8, Qt::NoButton, button, modifiers);
        send(QEvent::MouseButtonRelease, to, button, {}, modifiers);
    }
    QPoint onColumnRuler(int x) const
    {
        return {at(x, 0).x(), canvas.columnRuler().center().toPoint().y()};
    }
    LatticePoint vertex(int triangle, int index) const
    {
        return document.vertexAt({triangle, index})->position;
    }
};

/// The colour shown in the middle of a pixel's cell.
QRgb shownAt(const QImage &grabbed, const Canvas &canvas, const QPoint &pixel)
{
    const QPointF device = canvas.positionOf(pixel) * grabbed.devicePixelRatio();
    return grabbed.pixel(device.toPoint());
}

} // namespace

class CanvasTest : public QObject {
    Q_OBJECT

private slots:
    void placesAVertexAtThePixelUnderTheClick_data();
    void placesAVertexAtThePixelUnderTheClick();
    void threeClicksDrawATriangle();
    void showsTheFramesOwnColours();
    void cellsHaveWholeDevicePixelsInsideAWindow();
    void showsTheTruthWhileShiftIsHeld();
    void aShortcutWithShiftDoesNotPeek();
    void dragsAVertexInOneCommand();
    void aPressOnAHandleSelectsItsVertex();
    void escapeEndsADragWithoutATrace();
    void escapeDiscardsPendingVertices();
    void clicksSnapToSixteenths();
    void halfPixelCentresKeepTheScenesCoordinates();
    void rightClickPicksThePixel();
    void rightClickOnAHandleOpensItsMenu();
    void doubleClickOnAHandleAsksForAColour();
    void doubleClickOnAnEmptyPlacePlacesVertices();
    void zoomsAtThePointer();
    void zoomsByKeysBetweenFitAndSixtyFour();
    void fitFollowsTheSizeOfTheWidget();
    void movesTheViewByDragging_data();
    void movesTheViewByDragging();
    void aClickOnTheRulerSeeksThatColumn();
    void aDoubleClickOnTheRulerTogglesABreakpoint();
    void keysAlonePlaceATriangle();
    void keysAloneMoveAVertexInOneCommandARun();
    void bracketsVisitEveryVertex();
    void deleteRemovesTheSelectedTriangle();
    void tabLeavesTheCanvas();
    void tellsWhereThePointerIs();
    void saysThePickedPixelToScreenReaders();
    void coordinatesCanBeTyped();
    void differencesAppearOnlyWhenDecided();
    void followsTheFrameOfTheDocument();
    void figureHoldsCellsNamesAndColumn();
    void figureOfAHugeFrameIsRefused();
    void repaintsAHugeFrameQuickly();
};

void CanvasTest::placesAVertexAtThePixelUnderTheClick_data()
{
    QTest::addColumn<int>("zoom");
    for (const int zoom : {4, 5, 9, 16, 64})
        QTest::addRow("zoom %d", zoom) << zoom;
}

void CanvasTest::placesAVertexAtThePixelUnderTheClick()
{
    QFETCH(int, zoom);
    Bench bench;
    bench.canvas.setZoom(zoom);
    QCOMPARE(bench.canvas.zoom(), zoom);
    const QPoint pixel = *bench.canvas.pixelAt(bench.canvas.view().center() + QPointF(9, -13));

    bench.click(pixel.x(), pixel.y());

    QCOMPARE(bench.document.pendingVertices().at(0).position, latticePixel(pixel.x(), pixel.y()));
}

void CanvasTest::threeClicksDrawATriangle()
{
    Bench bench;
    bench.click(4, 5);
    bench.click(58, 12);
    QCOMPARE(bench.document.pendingVertices().size(), 2U);
    bench.click(26, 44);

    QCOMPARE(bench.document.scene().triangles, firstScene().triangles);
    bench.document.undoStack()->undo();
    QCOMPARE(bench.document.pendingVertices().size(), 2U);
    bench.document.undoStack()->redo();
    QCOMPARE(bench.document.scene().triangles, firstScene().triangles);
}

void CanvasTest::showsTheFramesOwnColours()
{
    Bench bench(firstScene());
    bench.playhead.seek(bench.playhead.end());
    bench.options.setGridShown(false);
    const QImage frame = bench.playhead.frame()->image();
    const QImage grabbed = bench.canvas.grab().toImage();

    for (const QPoint &pixel : {QPoint(2, 2), QPoint(20, 12), QPoint(30, 20), QPoint(26, 36)})
        QCOMPARE(shownAt(grabbed, bench.canvas, pixel), frame.pixel(pixel.x(), 47 - pixel.y()));
}

void CanvasTest::cellsHaveWholeDevicePixelsInsideAWindow()
{
    Bench bench(firstScene());
    QWidget window;
    window.resize(800, 600);
    bench.canvas.setParent(&window);
    bench.canvas.move(33, 17); // at a ratio of 1.5 between two device pixels
    bench.playhead.seek(bench.playhead.end());
    bench.options.setGridShown(false);
    bench.canvas.show();
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));

    const QImage frame = bench.playhead.frame()->image();
    const QImage grabbed = window.grab().toImage();
    const double ratio = grabbed.devicePixelRatio();
    const QPoint corner(int(33 * ratio), int(17 * ratio));
    for (const QPoint &pixel : {QPoint(2, 2), QPoint(20, 12), QPoint(30, 20), QPoint(26, 36)}) {
        const QRect cell = bench.canvas.mapping().deviceCellOf(pixel).translated(corner);
        QImage expected(cell.size(), grabbed.format());
        expected.fill(frame.pixel(pixel.x(), 47 - pixel.y()));
        QImage shown = grabbed.copy(cell);
        shown.setDevicePixelRatio(1);
        QCOMPARE(shown, expected);
    }
    bench.canvas.setParent(nullptr);
}

void CanvasTest::showsTheTruthWhileShiftIsHeld()
{
    Bench bench(firstScene());
    bench.playhead.seek(0);
    QVERIFY(!bench.canvas.isTruthVisible());

    QTest::keyPress(&bench.canvas, Qt::Key_Shift, Qt::ShiftModifier);
    QTRY_VERIFY(bench.canvas.isTruthVisible());
    const QImage truth = bench.playhead.traced()->truth.image();
    QCOMPARE(shownAt(bench.canvas.grab().toImage(), bench.canvas, {30, 20}), truth.pixel(30, 27));

    QTest::keyRelease(&bench.canvas, Qt::Key_Shift);
    QVERIFY(!bench.canvas.isTruthVisible());
}

void CanvasTest::aShortcutWithShiftDoesNotPeek()
{
    Bench bench(firstScene());
    QTest::keyPress(&bench.canvas, Qt::Key_Shift, Qt::ShiftModifier);
    QVERIFY(!bench.canvas.isTruthVisible());
    QTest::keyClick(&bench.canvas, Qt::Key_F10, Qt::ShiftModifier);
    QTest::qWait(300);
    QVERIFY(!bench.canvas.isTruthVisible());
}

void CanvasTest::dragsAVertexInOneCommand()
{
    Bench bench(firstScene());
    const int commands = bench.document.undoStack()->count();

    bench.drag(bench.at(58, 12), bench.at(50, 30));

    QCOMPARE(bench.vertex(0, 1), latticePixel(50, 30));
    QCOMPARE(bench.document.undoStack()->count(), commands + 1);
    bench.document.undoStack()->undo();
    QCOMPARE(bench.document.scene(), firstScene());
}

void CanvasTest::aPressOnAHandleSelectsItsVertex()
{
    Bench bench(firstScene());
    bench.click(26, 44);

    QCOMPARE(bench.document.selectedVertex(), std::optional(VertexRef{0, 2}));
    QVERIFY(!bench.document.isModified());
}

void CanvasTest::escapeEndsADragWithoutATrace()
{
    Bench bench(firstScene());
    bench.send(QEvent::MouseButtonPress, bench.at(4, 5), Qt::LeftButton, Qt::LeftButton);
    bench.send(QEvent::MouseMove, bench.at(10, 10), Qt::NoButton, Qt::LeftButton);
    QCOMPARE(bench.vertex(0, 0), latticePixel(10, 10));

    QTest::keyClick(&bench.canvas, Qt::Key_Escape);
    bench.send(QEvent::MouseButtonRelease, bench.at(10, 10), Qt::LeftButton, {});

    QCOMPARE(bench.document.scene(), firstScene());
    QVERIFY(!bench.document.isModified());
}

void CanvasTest::escapeDiscardsPendingVertices()
{
    Bench bench;
    bench.click(4, 5);
    bench.click(20, 12);

    QTest::keyClick(&bench.canvas, Qt::Key_Escape);
    QVERIFY(bench.document.pendingVertices().empty());
    bench.document.undoStack()->undo();
    QCOMPARE(bench.document.pendingVertices().size(), 2U);
}

void CanvasTest::clicksSnapToSixteenths()
{
    Bench bench;
    bench.canvas.setZoom(64);
    bench.document.setSnap(Snap::Sixteenth);
    const QPoint pixel = *bench.canvas.pixelAt(bench.canvas.view().center());
    // A quarter to the right of and three sixteenths above the sample.
    const LatticePoint point{pixel.x() * unitsPerPixel + 64, pixel.y() * unitsPerPixel + 48};

    QTest::mouseClick(&bench.canvas, Qt::LeftButton, {}, bench.canvas.positionOf(point).toPoint());

    QCOMPARE(bench.document.pendingVertices().at(0).position, point);
}

void CanvasTest::halfPixelCentresKeepTheScenesCoordinates()
{
    Scene scene;
    scene.frame.origin = FrameOrigin::TopLeft;
    scene.frame.pixelCentre = PixelCentre::Half;
    Bench bench(scene);
    const LatticePoint corner = latticePixel(10, 20);

    QTest::mouseClick(&bench.canvas, Qt::LeftButton, {}, bench.canvas.positionOf(corner).toPoint());

    // The corner that the pixels (9, 19) and (10, 20) share.
    QCOMPARE(bench.document.pendingVertices().at(0).position, corner);
    const QPointF between
        = (bench.canvas.positionOf(QPoint(9, 19)) + bench.canvas.positionOf(QPoint(10, 20))) / 2;
    // Each of the two middles may be a device pixel off to the upper left.
    QVERIFY((bench.canvas.positionOf(corner) - between).manhattanLength() <= 2);
}

void CanvasTest::rightClickPicksThePixel()
{
    Bench bench(firstScene());
    bench.click(30, 20, Qt::RightButton);
    QCOMPARE(bench.playhead.pickedPixel(), std::optional(QPoint(30, 20)));
    QVERIFY(!bench.document.isModified());
}

void CanvasTest::rightClickOnAHandleOpensItsMenu()
{
    Bench bench(firstScene());
    QSignalSpy colourRequested(&bench.canvas, &Canvas::colourRequested);
    bench.click(58, 12, Qt::RightButton);
    auto *menu = bench.canvas.findChild<QMenu *>(QStringLiteral("canvasMenu"));
    QVERIFY(menu);
    QCOMPARE(bench.document.selectedVertex(), std::optional(VertexRef{0, 1}));

    menu->actions().first()->trigger();
    QCOMPARE(colourRequested.at(0).at(0).value<VertexRef>(), (VertexRef{0, 1}));
    menu->actions().last()->trigger();
    QVERIFY(bench.document.scene().triangles.empty());
    menu->close();
}

void CanvasTest::doubleClickOnAHandleAsksForAColour()
{
    Bench bench(firstScene());
    QSignalSpy colourRequested(&bench.canvas, &Canvas::colourRequested);

    QTest::mouseClick(&bench.canvas, Qt::LeftButton, {}, bench.at(58, 12));
    bench.send(QEvent::MouseButtonDblClick, bench.at(58, 12), Qt::LeftButton, Qt::LeftButton);
    bench.send(QEvent::MouseButtonRelease, bench.at(58, 12), Qt::LeftButton, {});

    QCOMPARE(colourRequested.count(), 1);
    QVERIFY(!bench.document.isModified());
}

void CanvasTest::doubleClickOnAnEmptyPlacePlacesVertices()
{
    Bench bench;
    QSignalSpy colourRequested(&bench.canvas, &Canvas::colourRequested);
    bench.click(10, 10);
    bench.send(QEvent::MouseButtonDblClick, bench.at(10, 10), Qt::LeftButton, Qt::LeftButton);
    bench.send(QEvent::MouseButtonRelease, bench.at(10, 10), Qt::LeftButton, {});
    QCOMPARE(colourRequested.count(), 0); // the first click placed the vertex under the second

    bench.send(QEvent::MouseButtonDblClick, bench.at(30, 10), Qt::LeftButton, Qt::LeftButton);
    bench.send(QEvent::MouseButtonRelease, bench.at(30, 10), Qt::LeftButton, {});
    QCOMPARE(bench.document.pendingVertices().size(), 2U);
}

void CanvasTest::zoomsAtThePointer()
{
    Bench bench(firstScene());
    const QPoint pointer = bench.at(20, 30);
    const auto turn = [&](int angle) {
        QWheelEvent event(pointer, bench.canvas.mapToGlobal(pointer), {}, {0, angle}, {}, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&bench.canvas, &event);
    };
    const int fitted = bench.canvas.zoom();
    QSignalSpy zoomChanged(&bench.canvas, &Canvas::zoomChanged);

    for (int notch = 0; notch < 3; ++notch) {
        turn(60); // half a notch of a fine wheel
        turn(60);
        QCOMPARE(bench.canvas.pixelAt(pointer), std::optional(QPoint(20, 30)));
    }
    QCOMPARE(zoomChanged.count(), 3);
    QVERIFY(bench.canvas.zoom() > fitted);
    for (int notch = 0; notch < 3; ++notch)
        turn(-120);
    QCOMPARE(bench.canvas.pixelAt(pointer), std::optional(QPoint(20, 30)));
}

void CanvasTest::zoomsByKeysBetweenFitAndSixtyFour()
{
    Bench bench;
    const int fitted = bench.canvas.zoom();
    for (int i = 0; i < 30; ++i)
        QTest::keyClick(&bench.canvas, Qt::Key_Plus, Qt::ShiftModifier);
    QCOMPARE(bench.canvas.zoom(), 64);
    QCOMPARE(bench.canvas.zoomText(), QStringLiteral("64×"));
    for (int i = 0; i < 30; ++i)
        QTest::keyClick(&bench.canvas, Qt::Key_Minus);
    QCOMPARE(bench.canvas.zoom(), 1);
    QTest::keyClick(&bench.canvas, Qt::Key_0);
    QCOMPARE(bench.canvas.zoom(), fitted);

    FrameSpec huge;
    huge.width = 4096;
    huge.height = 4096;
    bench.document.setFrame(huge);
    QVERIFY(bench.canvas.zoom() < -1);
    QVERIFY(bench.canvas.zoomText().startsWith(QStringLiteral("1:")));
}

void CanvasTest::fitFollowsTheSizeOfTheWidget()
{
    Bench bench;
    const int before = bench.canvas.zoom();
    bench.canvas.resize(1400, 1040);
    QTRY_VERIFY(bench.canvas.zoom() > before);

    bench.canvas.setZoom(7);
    bench.canvas.resize(700, 520);
    QTest::qWait(20);
    QCOMPARE(bench.canvas.zoom(), 7);
}

void CanvasTest::movesTheViewByDragging_data()
{
    QTest::addColumn<Qt::MouseButton>("button");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::newRow("middle button") << Qt::MiddleButton << Qt::KeyboardModifiers();
    QTest::newRow("Control and left button")
        << Qt::LeftButton << Qt::KeyboardModifiers(Qt::ControlModifier);
}

void CanvasTest::movesTheViewByDragging()
{
    QFETCH(Qt::MouseButton, button);
    QFETCH(Qt::KeyboardModifiers, modifiers);
    Bench bench(firstScene());
    const QPoint from = bench.at(30, 20);
    const QPoint to = from + QPoint(40, -30);

    bench.drag(from, to, button, modifiers);

    QCOMPARE(bench.canvas.pixelAt(to), std::optional(QPoint(30, 20)));
    QVERIFY(!bench.document.isModified());
}

void CanvasTest::aClickOnTheRulerSeeksThatColumn()
{
    Bench bench(firstScene());
    QTest::mouseClick(&bench.canvas, Qt::LeftButton, {}, bench.onColumnRuler(33));
    QCOMPARE(bench.playhead.columnXInHand(), std::optional(std::int64_t(33)));

    // The triangle begins at column 4.
    QTest::mouseClick(&bench.canvas, Qt::LeftButton, {}, bench.onColumnRuler(0));
    QCOMPARE(bench.playhead.columnXInHand(), std::optional(std::int64_t(4)));
    QVERIFY(!bench.document.isModified());
}

void CanvasTest::aDoubleClickOnTheRulerTogglesABreakpoint()
{
    Bench bench(firstScene());
    const QPoint ruler = bench.onColumnRuler(33);
    QTest::mouseDClick(&bench.canvas, Qt::LeftButton, {}, ruler);
    QCOMPARE(bench.playhead.columnBreakpoints(), std::set<std::int64_t>{33});
    QTest::mouseClick(&bench.canvas, Qt::RightButton, {}, ruler);
    QVERIFY(bench.playhead.columnBreakpoints().empty());
}

void CanvasTest::keysAlonePlaceATriangle()
{
    Bench bench;
    bench.playhead.pick({10, 10});
    QTest::keyClick(&bench.canvas, Qt::Key_Return);
    for (int i = 0; i < 5; ++i)
        QTest::keyClick(&bench.canvas, Qt::Key_Right);
    QTest::keyClick(&bench.canvas, Qt::Key_Insert);
    for (int i = 0; i < 5; ++i)
        QTest::keyClick(&bench.canvas, Qt::Key_Up);
    QTest::keyClick(&bench.canvas, Qt::Key_Enter, Qt::KeypadModifier);

    const std::vector expected{
        triangleOf(latticePixel(10, 10), latticePixel(15, 10), latticePixel(15, 15))};
    QCOMPARE(bench.document.scene().triangles, expected);
}

void CanvasTest::keysAloneMoveAVertexInOneCommandARun()
{
    Bench bench(firstScene());
    bench.document.selectVertex(VertexRef{0, 0});
    const auto send = [&](QEvent::Type type, int key, Qt::KeyboardModifiers modifiers) {
        QKeyEvent event(type, key, modifiers);
        QApplication::sendEvent(&bench.canvas, &event);
    };
    send(QEvent::KeyPress, Qt::Key_Control, Qt::ControlModifier);
    for (const int key : {Qt::Key_Right, Qt::Key_Right, Qt::Key_Right, Qt::Key_Up}) {
        send(QEvent::KeyPress, key, Qt::ControlModifier);
        send(QEvent::KeyRelease, key, Qt::ControlModifier);
    }
    send(QEvent::KeyRelease, Qt::Key_Control, {});
    QCOMPARE(bench.vertex(0, 0), latticePixel(7, 6));
    QCOMPARE(bench.document.undoStack()->count(), 1);

    bench.document.setSnap(Snap::Sixteenth);
    QTest::keyClick(&bench.canvas, Qt::Key_Down, Qt::ControlModifier);
    QCOMPARE(bench.vertex(0, 0), (LatticePoint{7 * 256, 6 * 256 - 16}));
    QCOMPARE(bench.document.undoStack()->count(), 2);
}

void CanvasTest::bracketsVisitEveryVertex()
{
    Bench bench(firstScene());
    std::vector<int> visited;
    for (int i = 0; i < 4; ++i) {
        QTest::keyClick(&bench.canvas, Qt::Key_BracketRight);
        visited.push_back(bench.document.selectedVertex()->vertex);
    }
    QTest::keyClick(&bench.canvas, Qt::Key_BracketLeft);
    visited.push_back(bench.document.selectedVertex()->vertex);

    QCOMPARE(visited, (std::vector{0, 1, 2, 0, 2}));
}

void CanvasTest::deleteRemovesTheSelectedTriangle()
{
    Bench bench(firstScene());
    QTest::keyClick(&bench.canvas, Qt::Key_Delete);
    QCOMPARE(bench.document.scene().triangles.size(), 1U);

    bench.document.selectVertex(VertexRef{0, 1});
    QTest::keyClick(&bench.canvas, Qt::Key_Delete);
    QVERIFY(bench.document.scene().triangles.empty());
    bench.document.undoStack()->undo();
    QCOMPARE(bench.document.scene(), firstScene());
}

void CanvasTest::tabLeavesTheCanvas()
{
    Bench bench;
    QWidget window;
    window.resize(900, 600);
    bench.canvas.setParent(&window);
    QLineEdit next(&window);
    QWidget::setTabOrder(&bench.canvas, &next);
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    bench.canvas.show();
    bench.canvas.setFocus();
    QVERIFY(bench.canvas.hasFocus());

    QTest::keyClick(&bench.canvas, Qt::Key_Tab);
    QVERIFY(next.hasFocus());
    QTest::keyClick(&next, Qt::Key_Backtab);
    QVERIFY(bench.canvas.hasFocus());
    bench.canvas.setParent(nullptr);
}

void CanvasTest::tellsWhereThePointerIs()
{
    Bench bench(firstScene());
    QSignalSpy hovered(&bench.canvas, &Canvas::hovered);
    using Point = std::optional<LatticePoint>;

    bench.send(QEvent::MouseMove, bench.at(33, 7), Qt::NoButton, {});
    QCOMPARE(hovered.takeLast().at(0).value<Point>(), Point(latticePixel(33, 7)));
    bench.send(QEvent::MouseMove, bench.onColumnRuler(33), Qt::NoButton, {});
    QCOMPARE(hovered.takeLast().at(0).value<Point>(), Point());
}

void CanvasTest::saysThePickedPixelToScreenReaders()
{
    Bench bench(firstScene());
    QAccessibleInterface *accessible = QAccessible::queryAccessibleInterface(&bench.canvas);
    QVERIFY(accessible);
    QVERIFY(!accessible->text(QAccessible::Name).isEmpty());
    QVERIFY(!accessible->text(QAccessible::Description).isEmpty());

    bench.playhead.pick({30, 20});
    QCOMPARE(accessible->text(QAccessible::Value), QStringLiteral("pixel (30, 20)"));
    bench.document.selectVertex(VertexRef{0, 1});
    QCOMPARE(accessible->text(QAccessible::Value),
             QStringLiteral("vertex 1 of triangle 0 at (58, 12)"));
}

void CanvasTest::coordinatesCanBeTyped()
{
    Bench bench(firstScene());
    VertexDialog dialog(&bench.document, {0, 2});
    auto *x = dialog.findChild<QLineEdit *>(QStringLiteral("vertexX"));
    auto *ok = dialog.findChild<QPushButton *>();

    x->setText(QStringLiteral("53/"));
    QVERIFY(!ok->isEnabled());
    x->setText(QStringLiteral("53/2"));
    QVERIFY(ok->isEnabled());
    dialog.accept();

    QCOMPARE(bench.vertex(0, 2), (LatticePoint{53 * 128, 44 * 256}));
}

void CanvasTest::differencesAppearOnlyWhenDecided()
{
    Scene scene = firstScene();
    scene.settings.rounding = ByteRounding::Truncate;
    Bench exact(scene);
    scene.settings.arithmetic = Arithmetic::Fixed16;
    Bench bench(scene);
    bench.options.setGridShown(false);
    const DifferenceMap &differences = bench.playhead.traced()->differences;
    QVERIFY(differences.total() > 0);
    QPoint pixel;
    for (int y = 12; y < 40 && pixel.isNull(); ++y) {
        for (int x = 20; x < 40 && pixel.isNull(); ++x) {
            if (differences.at(x, y) != Difference::None)
                pixel = {x, y};
        }
    }
    QVERIFY(!pixel.isNull());
    const std::size_t decided = bench.playhead.traced()->decidedAt(pixel.x(), pixel.y());
    const auto cellIsPlain = [&] {
        const QImage grabbed = bench.canvas.grab().toImage();
        const QRect cell = bench.canvas.mapping().deviceCellOf(pixel).adjusted(2, 2, -2, -2);
        const QImage inside = grabbed.copy(cell);
        QImage plain = inside;
        plain.fill(inside.pixelColor(0, 0));
        return inside == plain;
    };
    const auto moveFarOn = [&](std::size_t position) {
        bench.playhead.seek(position);
        bench.playhead.pick({0, 0});
    };

    moveFarOn(bench.playhead.end());
    QVERIFY(!cellIsPlain());
    bench.options.setDifferencesShown(false);
    QVERIFY(cellIsPlain());
    bench.options.setDifferencesShown(true);
    moveFarOn(bench.playhead.traced()->decidedAt(pixel.x() - 3, pixel.y()));
    QVERIFY(decided > bench.playhead.position());
    QVERIFY(cellIsPlain());
}

void CanvasTest::followsTheFrameOfTheDocument()
{
    Bench bench(firstScene());
    FrameSpec frame;
    frame.width = 10;
    frame.height = 8;
    bench.document.setFrame(frame);

    QCOMPARE(bench.canvas.mapping().frame(), frame);
    QCOMPARE(bench.canvas.pixelAt(bench.canvas.positionOf(QPoint(9, 7))),
             std::optional(QPoint(9, 7)));
    QCOMPARE(bench.canvas.mapping().devicePicture(),
             bench.canvas.mapping().devicePicture()
                 & bench.canvas.mapping().deviceRect(bench.canvas.view()));
}

void CanvasTest::figureHoldsCellsNamesAndColumn()
{
    Bench bench(firstScene());
    bench.playhead.seekToSpan(20);
    const QByteArray figure = svgFigure(bench.playhead, bench.options);

    QXmlStreamReader reader(figure);
    QStringList texts;
    while (!reader.atEnd()) {
        if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == u"text")
            texts << reader.readElementText().trimmed();
    }
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
    for (const char *text : {"P0", "P1", "P2", "y", "B", "T", "10", "60"})
        QVERIFY2(texts.contains(QLatin1String(text)), text);
    QCOMPARE(svgFigure(bench.playhead, bench.options), figure);
}

void CanvasTest::figureOfAHugeFrameIsRefused()
{
    Scene scene = firstScene();
    scene.frame.width = 1024;
    scene.frame.height = 512;
    Bench bench(scene);
    const QString reason = exportSvg(QStringLiteral("never.svg"), bench.playhead, bench.options);
    QVERIFY2(reason.contains(QStringLiteral("1024 × 512")), qPrintable(reason));
    QVERIFY(!QFile::exists(QStringLiteral("never.svg")));
}

void CanvasTest::repaintsAHugeFrameQuickly()
{
    Scene scene = firstScene();
    scene.frame.width = 4096;
    scene.frame.height = 4096;
    Bench bench(scene);
    QPixmap target(bench.canvas.size() * bench.canvas.devicePixelRatioF());
    for (const int zoom : {-8, 1, 7}) {
        bench.canvas.setZoom(zoom);
        bench.canvas.render(&target);
        const std::clock_t start = std::clock(); // processor time: the machine may be busy
        bench.canvas.render(&target);
        const double milliseconds = 1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC;
        // 16.7 million pixels one by one would take longer.
        QVERIFY2(milliseconds < 40, qPrintable(QString::number(milliseconds)));
    }
}

QTEST_MAIN(CanvasTest)
#include "tst_canvas.moc"
