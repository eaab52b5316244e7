// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testprogram.h"
#include "tests/support/window/canvasbench.h"

#include <QtTest>

namespace tst_offscreenpoint {

using namespace pixelplumb;

namespace {

Scene sceneWith(FillRule rule, PixelCentre centre)
{
    Scene scene = firstScene();
    scene.method = "edge-equations"; // it supports both rules
    scene.settings.fillRule = rule;
    scene.frame.pixelCentre = centre;
    return scene;
}

} // namespace

/// The point of the off-screen-point rule on the canvas.
class TestOffScreenPoint : public QObject {
    Q_OBJECT

private slots:
    void isDrawnWhereItIsUnderItsRuleAlone()
    {
        const Scene scene = sceneWith(FillRule::OffScreenPoint, PixelCentre::Integer);
        CanvasBench with(scene);
        CanvasBench without(sceneWith(FillRule::Closed, PixelCentre::Integer));
        const auto around = [](CanvasBench &bench) {
            const QImage whole = bench.canvas.grab().toImage();
            const QPoint at = bench.at(-1, -1) * whole.devicePixelRatio();
            return whole.copy(QRect(at - QPoint(9, 9), QSize(19, 19)));
        };
        QVERIFY(around(with) != around(without));
    }

    void anArrowAtTheBorderPointsToItWhereItIsOutOfView()
    {
        Scene scene = sceneWith(FillRule::OffScreenPoint, PixelCentre::Integer);
        scene.frame.offScreenPoint = latticePixel(5000, 20);
        CanvasBench far(scene);
        scene.frame.offScreenPoint = latticePixel(-5000, 20);
        CanvasBench farOnTheOtherSide(scene);
        QVERIFY(far.canvas.grab().toImage() != farOnTheOtherSide.canvas.grab().toImage());
    }

    void aDragMovesItAsOneEdit_data()
    {
        QTest::addColumn<PixelCentre>("centre");
        QTest::newRow("samples at whole coordinates") << PixelCentre::Integer;
        QTest::newRow("samples at halves") << PixelCentre::Half;
    }
    void aDragMovesItAsOneEdit()
    {
        QFETCH(PixelCentre, centre);
        CanvasBench bench(sceneWith(FillRule::OffScreenPoint, centre));
        const Scene before = bench.document.scene();
        const LatticePoint start = *bench.document.offScreenPoint();
        QCOMPARE(start, latticePixel(-1, -1));
        const QPoint pressed
            = bench.canvas.mapping().positionOf(offScreenSample(before.frame)).toPoint();

        bench.drag(pressed, pressed + bench.at(2, 30) - bench.at(0, 0));

        QCOMPARE(bench.document.offScreenPoint(), std::optional(latticePixel(1, 29)));
        QCOMPARE(bench.document.undoStack()->count(), 1);
        QVERIFY(bench.document.pendingVertices().empty());
        bench.document.undoStack()->undo();
        QCOMPARE(bench.document.scene(), before);
        bench.drag(pressed, pressed + QPoint(1, 0)); // a trembling hand
        QCOMPARE(bench.document.scene(), before);
    }

    void noEditPutsItOutOfRange()
    {
        CanvasBench bench(sceneWith(FillRule::OffScreenPoint, PixelCentre::Integer));
        const Scene before = bench.document.scene();
        QSignalSpy refused(&bench.document, &SceneDocument::refused);
        const LatticePoint tooFar = latticePixel(-(std::int64_t(1) << 30) - 1, 0);
        FrameSpec frame = before.frame;
        frame.offScreenPoint = tooFar;

        bench.document.setFrame(frame);
        bench.document.moveOffScreenPoint(tooFar, bench.document.newDrag());

        QCOMPARE(refused.count(), 2);
        QCOMPARE(bench.document.scene(), before);
    }
};

PIXELPLUMB_TEST(TestOffScreenPoint)

} // namespace tst_offscreenpoint

#include "tst_offscreenpoint.moc"
