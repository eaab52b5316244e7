// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/canvasbench.h"

#include <QTest>
#include <QtWidgets>

namespace tst_canvaskeys {

using namespace pixelplumb;

/// The canvas without a mouse, and for screen readers.
class TestCanvasKeys : public QObject {
    Q_OBJECT

private slots:
    void showsTheTruthWhileShiftIsHeld()
    {
        CanvasBench bench(firstScene());
        bench.playhead.seek(0);
        QVERIFY(!bench.canvas.isTruthVisible());

        QTest::keyPress(&bench.canvas, Qt::Key_Shift, Qt::ShiftModifier);
        QTRY_VERIFY(bench.canvas.isTruthVisible());
        const QImage truth = bench.playhead.traced()->truth.image();
        QCOMPARE(shownAt(bench.canvas.grab().toImage(), bench.canvas, {30, 20}),
                 truth.pixel(30, 27));

        QTest::keyRelease(&bench.canvas, Qt::Key_Shift);
        QVERIFY(!bench.canvas.isTruthVisible());
    }

    void aShortcutWithShiftDoesNotPeek()
    {
        CanvasBench bench(firstScene());
        QElapsedTimer held;
        held.start();
        QTest::keyPress(&bench.canvas, Qt::Key_Shift, Qt::ShiftModifier);
        // As long as a slow hand needs to reach the other key.
        QTest::qWait(450);
        if (held.elapsed() >= peekDelay.count())
            QSKIP("the machine is too busy to hold a key for half a second");
        QVERIFY(!bench.canvas.isTruthVisible());
        QTest::keyPress(&bench.canvas, Qt::Key_F10, Qt::ShiftModifier);
        QTest::keyRelease(&bench.canvas, Qt::Key_F10, Qt::ShiftModifier);
        QTest::qWait(int(peekDelay.count()) + 100); // Shift is still held
        QVERIFY(!bench.canvas.isTruthVisible());
    }

    void keysAlonePlaceATriangle()
    {
        CanvasBench bench;
        bench.playhead.pick({10, 10});
        QTest::keyClick(&bench.canvas, Qt::Key_Return);
        for (int i = 0; i < 5; ++i)
            QTest::keyClick(&bench.canvas, Qt::Key_Right);
        QTest::keyClick(&bench.canvas, Qt::Key_Insert);
        for (int i = 0; i < 5; ++i)
            QTest::keyClick(&bench.canvas, Qt::Key_Up);
        QTest::keyClick(&bench.canvas, Qt::Key_Enter, Qt::KeypadModifier);

        const std::vector expected{triangleAt(10, 10, 15, 10, 15, 15)};
        QCOMPARE(bench.document.scene().triangles, expected);
    }

    void keysAloneMoveAVertexInOneCommandARun()
    {
        CanvasBench bench(firstScene());
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

    void bracketsVisitEveryVertex()
    {
        CanvasBench bench(firstScene());
        std::vector<int> visited;
        for (int i = 0; i < 4; ++i) {
            QTest::keyClick(&bench.canvas, Qt::Key_BracketRight);
            visited.push_back(bench.document.selectedVertex()->vertex);
        }
        QTest::keyClick(&bench.canvas, Qt::Key_BracketLeft);
        visited.push_back(bench.document.selectedVertex()->vertex);

        QCOMPARE(visited, (std::vector{0, 1, 2, 0, 2}));
    }

    void deleteRemovesTheSelectedTriangle()
    {
        CanvasBench bench(firstScene());
        QTest::keyClick(&bench.canvas, Qt::Key_Delete);
        QCOMPARE(bench.document.scene().triangles.size(), 1U);

        bench.document.selectVertex(VertexRef{0, 1});
        QTest::keyClick(&bench.canvas, Qt::Key_Delete);
        QVERIFY(bench.document.scene().triangles.empty());
        bench.document.undoStack()->undo();
        QCOMPARE(bench.document.scene(), firstScene());
    }

    void tabLeavesTheCanvas()
    {
        CanvasBench bench;
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

    void saysThePickedPixelToScreenReaders()
    {
        CanvasBench bench(firstScene());
        QAccessibleInterface *accessible = QAccessible::queryAccessibleInterface(&bench.canvas);
        QVERIFY(accessible);
        QCOMPARE(accessible->text(QAccessible::Name), u"Canvas"_s);
        QVERIFY(
            accessible->text(QAccessible::Description).contains("Arrows move the picked pixel"));

        bench.playhead.pick({30, 20});
        QCOMPARE(accessible->text(QAccessible::Value), u"pixel (30, 20)"_s);
        bench.document.selectVertex(VertexRef{0, 1});
        QCOMPARE(accessible->text(QAccessible::Value), u"vertex 1 of triangle 0 at (58, 12)"_s);
    }
};

PIXELPLUMB_TEST(TestCanvasKeys)

} // namespace tst_canvaskeys

#include "tst_canvaskeys.moc"
