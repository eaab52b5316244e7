// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layermarks.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/canvasbench.h"
#include "tests/support/window/layerlook.h"
#include "widgets/canvas/canvasscene.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/look/framepainter.h"

#include <QTest>

#include <cstdlib>

namespace tst_canvaslayers {

using namespace pixelplumb;

namespace {

LayerTone toneOf(const Canvas &canvas)
{
    return layerSurface(canvas.mapping(), canvas.view(), canvas.palette()).tone;
}

/// Whether a colour is within a few device pixels of a position on the canvas; lines between two
/// device pixels are a little paler.
bool isSeenAt(const Canvas &canvas, const QImage &grabbed, const QPointF &place, LayerInk ink)
{
    const QColor colour = colourOf(ink, toneOf(canvas));
    const QPoint device = (place * grabbed.devicePixelRatio()).toPoint();
    for (int y = device.y() - 2; y <= device.y() + 2; ++y) {
        for (int x = device.x() - 2; x <= device.x() + 2; ++x) {
            const QColor found = grabbed.pixelColor(x, y);
            if (std::abs(found.red() - colour.red()) + std::abs(found.green() - colour.green())
                    + std::abs(found.blue() - colour.blue())
                < 60)
                return true;
        }
    }
    return false;
}

Shape square()
{
    Shape polygon;
    polygon.kind = PrimitiveKind::Polygon;
    polygon.fill = ShapeFill::EvenOdd;
    for (const QPoint &corner : {QPoint(10, 10), QPoint(50, 10), QPoint(50, 40), QPoint(10, 40)})
        polygon.vertices.push_back({latticePixel(corner.x(), corner.y()), Colour()});
    return polygon;
}

} // namespace

/// Layers among the canvas's own lines and signs: what a layer draws is visible.
class TestCanvasLayers : public QObject {
    Q_OBJECT

private slots:
    void theIntervalsAndActiveEdgesOfARowAreSeenInTheWindow()
    {
        CanvasBench bench(sceneOf(square(), "polygon-parity", {}));
        const ScanTrace &trace = *bench.playhead.traced()->trace;
        bench.playhead.seek(trace.indexOfSpan(*trace.spanOn(0, SpanAxis::Row, 20)) + 1);
        // Away from the names, which are at the edges' middles and the crossings.
        const QPointF onInterval = bench.canvas.positionOf(QPoint(30, 20));
        const QPointF onEdge = bench.canvas.positionOf(QPoint(50, 14));
        const auto isSeen = [&](const QPointF &place, LayerInk ink) {
            return isSeenAt(bench.canvas, bench.canvas.grab().toImage(), place, ink);
        };
        QVERIFY(!isSeen(onInterval, LayerInk::Inside));
        QVERIFY(!isSeen(onEdge, LayerInk::First));

        bench.options.setLayers({u"edge-table"_s});

        QVERIFY(isSeen(onInterval, LayerInk::Inside));
        QVERIFY(isSeen(onEdge, LayerInk::First));
    }

    void theDistancesOfADecisionAreSeenBesideThePlumbLine_data()
    {
        QTest::addColumn<Shape>("line");
        QTest::newRow("flat") << lineAt(4, 10, 60, 33);
        QTest::newRow("steep") << lineAt(20, 4, 37, 44);
    }
    void theDistancesOfADecisionAreSeenBesideThePlumbLine()
    {
        QFETCH(Shape, line);
        CanvasBench bench(sceneOf(line, "line-bresenham", {}));
        Canvas &canvas = bench.canvas;
        const TracedScene &traced = *bench.playhead.traced();
        bench.options.setLayers({u"decisions"_s});
        canvas.setZoom(48);
        std::size_t seen = 0;
        for (std::size_t span = 1; span < traced.trace->spanCount(); ++span) {
            bench.playhead.seek(traced.trace->indexOfSpan(span) + 1);
            LayerView view;
            view.traced = &traced;
            view.position = bench.playhead.position();
            const LayerDrawing drawing = drawingOf({u"decisions"_s}, view);
            const LayerSurface surface
                = layerSurface(canvas.mapping(), canvas.view(), canvas.palette());
            const QImage grabbed = canvas.grab().toImage();
            for (const LayerDrawing::Measure &measure : drawing.measures) {
                const QLineF beside = measureLine(measure, surface);
                if (beside.length() < 12
                    || !canvas.view().adjusted(90, 30, -90, -30).contains(beside.center()))
                    continue;
                QVERIFY(isSeenAt(canvas, grabbed, beside.center(), measure.ink));
                ++seen;
            }
        }
        QVERIFY(seen > 2);
    }

    void thePlumbLineStrikesNoNumberThrough()
    {
        CanvasBench bench(firstScene());
        bench.canvas.setZoom(int(48 * bench.canvas.devicePixelRatioF()));
        const ScanTrace &trace = *bench.playhead.traced()->trace;
        const std::size_t sample = trace.sampleCount() / 2;
        bench.playhead.seek(trace.indexOfSample(sample) + 1);
        const PixelChange change = trace.changes()[sample];
        // Along the line, in the cell of the current sample.
        const auto line = [&] {
            const QImage grabbed = bench.canvas.grab().toImage();
            const double ratio = grabbed.devicePixelRatio();
            const QPoint centre
                = (bench.canvas.positionOf(latticePixel(change.x, change.y)) * ratio).toPoint();
            std::vector<QRgb> pixels;
            for (int dy = int(-18 * ratio); dy <= int(18 * ratio); ++dy)
                pixels.push_back(grabbed.pixel(centre.x(), centre.y() + dy));
            return pixels;
        };
        bench.options.setLayers({u"memory"_s});
        const std::vector<QRgb> withNumber = line();
        bench.options.setLayers({u"weights"_s});
        const std::vector<QRgb> withOthers = line();

        // If the line were above them, it would hide both.
        QVERIFY(withNumber != withOthers);
    }

    void aVertexHasOneName()
    {
        CanvasBench bench(firstScene());
        const CanvasView view(&bench.document, &bench.canvas);
        const CanvasSources sources{&bench.document, &bench.playhead, &bench.options};
        OutlineChoice choice;
        choice.lookUp(bench.document, view.mapping(), view.area());
        const auto names = [&] { return canvasScene(sources, view, choice, {}).names.size(); };

        QCOMPARE(names(), std::size_t(3));
        bench.options.setLayers({u"vertices"_s}); // with their coordinates
        QCOMPARE(names(), std::size_t(0));
    }

    void whatIsAheadIsHiddenAndShownAgain()
    {
        CanvasBench bench(firstScene());
        bench.playhead.seekToSpan(20);
        bench.options.setLayers({u"isolines-red"_s});
        const QImage shown = bench.canvas.grab().toImage();

        bench.playhead.setForetold(true);
        QVERIFY(bench.canvas.grab().toImage() != shown);
        bench.playhead.setForetold(false);
        QCOMPARE(bench.canvas.grab().toImage(), shown);
    }

    void valuesOfTheCellsMakeRoomForSamples()
    {
        CanvasBench bench(firstScene());
        bench.playhead.seek(bench.playhead.end());
        bench.options.setGridShown(false);
        bench.canvas.setZoom(int(64 * bench.canvas.devicePixelRatioF()));
        bench.options.setLayers({u"samples"_s});
        const QPoint pixel = *bench.canvas.pixelAt(bench.canvas.view().center());
        const QImage grabbed = bench.canvas.grab().toImage();
        const QRect cell = bench.canvas.mapping().deviceCellOf(pixel);

        // Left of the sample the cell has a single colour.
        QImage side = grabbed.copy(cell.adjusted(2, 2, -cell.width() / 2 - 12, -2));
        QImage plain = side;
        plain.fill(side.pixelColor(0, 0));
        QCOMPARE(side, plain);
    }
};

PIXELPLUMB_TEST(TestCanvasLayers)

} // namespace tst_canvaslayers

#include "tst_canvaslayers.moc"
