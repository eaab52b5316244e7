// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testprogram.h"
#include "tests/support/window/canvasbench.h"

#include <QtTest>

namespace tst_canvasview {

using namespace pixelplumb;

/// Which part of the frame the canvas shows, and its rulers.
class TestCanvasView : public QObject {
    Q_OBJECT

private slots:
    void zoomsAtThePointer()
    {
        CanvasBench bench(firstScene());
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

    void zoomsByKeysBetweenFitAndTheLargest()
    {
        CanvasBench bench;
        const int fitted = bench.canvas.zoom();
        for (int i = 0; i < 30; ++i)
            QTest::keyClick(&bench.canvas, Qt::Key_Plus, Qt::ShiftModifier);
        QCOMPARE(bench.canvas.zoom(), 128);
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
    }

    void fitFollowsTheSizeOfTheWidget()
    {
        CanvasBench bench;
        const int before = bench.canvas.zoom();
        bench.canvas.resize(1400, 1040);
        QTRY_VERIFY(bench.canvas.zoom() > before);

        bench.canvas.setZoom(7);
        bench.canvas.resize(700, 520);
        QTest::qWait(20);
        QCOMPARE(bench.canvas.zoom(), 7);
    }

    void movesTheViewByDragging_data()
    {
        QTest::addColumn<Qt::MouseButton>("button");
        QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
        QTest::newRow("middle button") << Qt::MiddleButton << Qt::KeyboardModifiers();
        QTest::newRow("Control and left button")
            << Qt::LeftButton << Qt::KeyboardModifiers(Qt::ControlModifier);
    }
    void movesTheViewByDragging()
    {
        QFETCH(Qt::MouseButton, button);
        QFETCH(Qt::KeyboardModifiers, modifiers);
        CanvasBench bench(firstScene());
        const QPoint from = bench.at(30, 20);
        const QPoint to = from + QPoint(40, -30);

        bench.drag(from, to, button, modifiers);

        QCOMPARE(bench.canvas.pixelAt(to), std::optional(QPoint(30, 20)));
        QVERIFY(!bench.document.isModified());
    }

    void aClickOnTheRulerSeeksThatColumn()
    {
        CanvasBench bench(firstScene());
        QTest::mouseClick(&bench.canvas, Qt::LeftButton, {}, bench.onColumnRuler(33));
        QCOMPARE(bench.playhead.currentColumnX(), std::optional(std::int64_t(33)));

        // The triangle begins at column 4.
        QTest::mouseClick(&bench.canvas, Qt::LeftButton, {}, bench.onColumnRuler(0));
        QCOMPARE(bench.playhead.currentColumnX(), std::optional(std::int64_t(4)));
        QVERIFY(!bench.document.isModified());
    }

    void aDoubleClickOnTheRulerTogglesABreakpoint()
    {
        CanvasBench bench(firstScene());
        const QPoint ruler = bench.onColumnRuler(33);
        QTest::mouseDClick(&bench.canvas, Qt::LeftButton, {}, ruler);
        QCOMPARE(bench.playhead.breakpoints().columns, std::set<std::int64_t>{33});
        QTest::mouseClick(&bench.canvas, Qt::RightButton, {}, ruler);
        QVERIFY(bench.playhead.breakpoints().isEmpty());
    }

    void tellsWhereThePointerIs()
    {
        CanvasBench bench(firstScene());
        QSignalSpy hovered(&bench.canvas, &Canvas::hovered);
        using Pixel = std::optional<QPoint>;

        bench.send(QEvent::MouseMove, bench.at(33, 7), Qt::NoButton, {});
        QCOMPARE(hovered.takeLast().at(0).value<Pixel>(), Pixel(QPoint(33, 7)));
        bench.send(QEvent::MouseMove, bench.onColumnRuler(33), Qt::NoButton, {});
        QCOMPARE(hovered.takeLast().at(0).value<Pixel>(), Pixel());
    }

    void followsTheFrameOfTheDocument()
    {
        CanvasBench bench(firstScene());
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

    void aFrameOfAnotherSizeIsSeenWholeAfterAZoom()
    {
        CanvasBench bench(firstScene());
        bench.canvas.setZoom(1);
        FrameSpec frame = bench.document.scene().frame;
        frame.width = 32;
        bench.document.setFrame(frame);
        const int zoom = bench.canvas.zoom();
        bench.canvas.fitToView();
        QVERIFY(zoom > 1);
        QCOMPARE(bench.canvas.zoom(), zoom);
    }

    void stepsAndChoicesOutsideTheViewMoveIt()
    {
        CanvasBench bench(firstScene());
        bench.canvas.setZoom(40);
        const auto isSeen = [&] {
            const QRectF cell = bench.canvas.mapping().cellOf(*bench.playhead.pickedPixel());
            return bench.canvas.view().contains(cell);
        };
        bench.playhead.seek(1); // the set-up is done
        for (int column = 0; column < 30; ++column) {
            bench.playhead.step(StepUnit::Span, StepDirection::Forward);
            const double x
                = bench.canvas
                      .positionOf(QPoint(int(bench.playhead.currentColumnX().value_or(4)), 0))
                      .x();
            QVERIFY(x >= bench.canvas.view().left() && x <= bench.canvas.view().right());
        }
        QVERIFY(isSeen());
        bench.playhead.pick(QPoint(2, 2));
        QVERIFY(isSeen());
        for (int i = 0; i < 25; ++i)
            QTest::keyClick(&bench.canvas, Qt::Key_Right);
        QVERIFY(isSeen());
        bench.playhead.setForetold(true); // only the column is shown
        bench.playhead.seekToSpan(50);
        QVERIFY(bench.canvas.view().contains(
            bench.canvas.positionOf(QPoint(int(*bench.playhead.currentColumnX()), 0)).x(),
            bench.canvas.view().center().y()));
    }

    void anEditDoesNotMoveTheView()
    {
        CanvasBench bench(firstScene());
        bench.canvas.setZoom(40);
        bench.playhead.pick(QPoint(26, 43));
        const QPoint origin = bench.canvas.mapping().origin();
        bench.document.moveVertex({0, 0}, latticePixel(9, 9), bench.document.newDrag());
        QCOMPARE(bench.canvas.mapping().origin(), origin);
    }
};

PIXELPLUMB_TEST(TestCanvasView)

} // namespace tst_canvasview

#include "tst_canvasview.moc"
