// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/pixelhistory.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/canvasbench.h"

#include <QTest>

#include <cmath>

namespace tst_canvasinspecting {

using namespace pixelplumb;

namespace {

/// Works even at the screen's edge: the screen is small at a large device pixel ratio.
void point(CanvasBench &bench, const QPoint &position)
{
    bench.send(QEvent::MouseMove, position, Qt::NoButton, Qt::NoButton);
}

} // namespace

/// Looking at the canvas: the Inspect tool, and the readout next to the pointer.
class TestCanvasInspecting : public QObject {
    Q_OBJECT

private slots:
    void inspectingPicksAndLeavesTheSceneAlone()
    {
        CanvasBench bench(firstScene());
        bench.canvas.setTool(CanvasTool::Inspect);

        bench.click(30, 20);
        QCOMPARE(bench.playhead.pickedPixel(), std::optional(QPoint(30, 20)));
        bench.drag(bench.at(58, 12), bench.at(50, 30)); // from a vertex

        QCOMPARE(bench.playhead.pickedPixel(), std::optional(QPoint(50, 30)));
        QCOMPARE(bench.document.scene(), firstScene());
        QVERIFY(bench.document.pendingVertices().empty());
        QVERIFY(!bench.document.isModified());
        bench.canvas.setTool(CanvasTool::Draw);
        bench.click(10, 30);
        QCOMPARE(bench.document.pendingVertices().size(), 1U);
    }

    void inspectingFollowsTheHeldButton()
    {
        CanvasBench bench(firstScene());
        bench.canvas.setTool(CanvasTool::Inspect);
        bench.send(QEvent::MouseButtonPress, bench.at(10, 10), Qt::LeftButton, Qt::LeftButton);
        for (const QPoint &pixel : {QPoint(11, 10), QPoint(14, 12)}) {
            bench.send(QEvent::MouseMove, bench.at(pixel.x(), pixel.y()), Qt::NoButton,
                       Qt::LeftButton);
            QCOMPARE(bench.playhead.pickedPixel(), std::optional(pixel));
        }
        bench.send(QEvent::MouseButtonRelease, bench.at(14, 12), Qt::LeftButton, {});
        point(bench, bench.at(20, 20));
        QCOMPARE(bench.playhead.pickedPixel(), std::optional(QPoint(14, 12)));
    }

    void theReadoutNamesPixelColourPainterAndNearestEdge()
    {
        CanvasBench bench(firstScene());
        bench.playhead.seek(bench.playhead.end());
        point(bench, bench.at(30, 10));
        const QString colour = QColor::fromRgb(*bench.playhead.frame()->view().at(30, 10)).name();
        // The lower edge goes from (4, 5) to (58, 12): 5 + 26 · 7/54 at x = 30.
        const double along = 10 - (5 + 26 * 7.0 / 54);
        const QString distance = QString::number(along * 54 / std::hypot(54, 7), 'f', 2);

        QCOMPARE(bench.canvas.readout(),
                 u"(30, 10) %1\ntriangle 0 · %2 px from L₀₂"_s.arg(colour, distance));
        bench.playhead.seek(0); // by keys, while the pointer rests
        QCOMPARE(bench.canvas.readout(), QString());
        point(bench, bench.at(30, 10));
        QCOMPARE(
            bench.canvas.readout(),
            u"(30, 10) #000000\nnot painted yet · %1 px inside L₀₂ of triangle 0"_s.arg(distance));
    }

    void theReadoutSaysWhichEdgeKeepsAnUnpaintedPixelOut()
    {
        CanvasBench bench(firstScene());
        bench.playhead.seek(bench.playhead.end());
        point(bench, bench.at(31, 1));
        QVERIFY2(bench.canvas.readout().startsWith("(31, 1) #000000\nnot painted · "),
                 qPrintable(bench.canvas.readout()));
        QVERIFY(bench.canvas.readout().endsWith("px outside L₀₂ of triangle 0"));

        bench.send(QEvent::MouseButtonPress, bench.at(31, 1), Qt::LeftButton, Qt::LeftButton);
        QCOMPARE(bench.canvas.readout(), QString()); // a button is pressed
    }

    void theReadoutSaysThatASampleIsOnAnEdge()
    {
        // (14, 9) is in the middle of the edge from (8, 6) to (20, 12).
        Scene scene;
        scene.triangles = {triangleAt(8, 6, 20, 12, 8, 30)};
        scene.settings.fillRule = FillRule::Open;
        CanvasBench open(scene);
        open.playhead.seek(open.playhead.end());
        point(open, open.at(14, 9));
        QCOMPARE(open.canvas.readout(), u"(14, 9) #000000\nnot painted · on L₀₂ of triangle 0"_s);
        // The same words as in the Pixel panel.
        QVERIFY(pixelHistory(*open.playhead.traced(), 14, 9)
                    .front()
                    .reason.startsWith("The sample lies exactly on L₀₂"));

        scene.settings.fillRule = FillRule::Closed;
        CanvasBench closed(scene);
        closed.playhead.seek(closed.playhead.end());
        point(closed, closed.at(14, 9));
        QVERIFY2(closed.canvas.readout().endsWith("triangle 0 · on L₀₂"),
                 qPrintable(closed.canvas.readout()));
    }

    void theReadoutHasTheCoordinatesOfTheVertexUnderThePointer()
    {
        CanvasBench bench(firstScene());
        for (const CanvasTool tool : {CanvasTool::Draw, CanvasTool::Inspect}) {
            bench.canvas.setTool(tool);
            point(bench, bench.at(58, 12));
            QVERIFY2(bench.canvas.readout().startsWith(
                         u"vertex 1 of triangle 0 at (58, 12)\n(58, 12) #"_s),
                     qPrintable(bench.canvas.readout()));
        }
    }

    void theReadoutHasTheVertexWhereItIsNoPixel()
    {
        CanvasBench bench(firstScene());
        bench.canvas.setZoom(64);
        bench.document.setSnap(Snap::Sixteenth);
        const QPoint pixel = *bench.canvas.pixelAt(bench.canvas.view().center());
        const LatticePoint place{pixel.x() * unitsPerPixel + 64, pixel.y() * unitsPerPixel};
        point(bench, bench.canvas.positionOf(place).toPoint());

        QVERIFY2(bench.canvas.readout().startsWith(u"vertex (%1"_s.arg(pixel.x())),
                 qPrintable(bench.canvas.readout()));
        bench.canvas.setTool(CanvasTool::Inspect); // a click places none
        QVERIFY(bench.canvas.readout().startsWith(u"(%1, "_s.arg(pixel.x())));
    }
};

PIXELPLUMB_TEST(TestCanvasInspecting)

} // namespace tst_canvasinspecting

#include "tst_canvasinspecting.moc"
