// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/textoutlines.h"
#include "tests/support/framespec.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/scenes/spacescenes.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/canvasbench.h"
#include "widgets/files/svgexport.h"

#include <QTest>
#include <QXmlStreamReader>

#include <ctime>

namespace tst_canvaspainting {

using namespace pixelplumb;

namespace {

/// The texts of a figure, which must be well-formed.
QStringList textsIn(const QByteArray &figure)
{
    QXmlStreamReader reader(figure);
    QStringList texts;
    while (!reader.atEnd()) {
        if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == u"text")
            texts << reader.readElementText().trimmed();
    }
    return reader.hasError() ? QStringList(reader.errorString()) : texts;
}

} // namespace

/// What the canvas paints, and the figure that it exports.
class TestCanvasPainting : public QObject {
    Q_OBJECT

private slots:
    void showsTheFramesOwnColours()
    {
        CanvasBench bench(firstScene());
        bench.playhead.seek(bench.playhead.end());
        bench.options.setGridShown(false);
        const QImage frame = bench.playhead.frame()->image();
        const QImage grabbed = bench.canvas.grab().toImage();

        for (const QPoint &pixel : {QPoint(2, 2), QPoint(20, 12), QPoint(30, 20), QPoint(26, 36)})
            QCOMPARE(shownAt(grabbed, bench.canvas, pixel), frame.pixel(pixel.x(), 47 - pixel.y()));
    }

    void cellsHaveWholeDevicePixelsInsideAWindow()
    {
        CanvasBench bench(firstScene());
        QWidget window;
        window.resize(800, 600);
        bench.canvas.setParent(&window);
        bench.canvas.move(33, 17); // between two device pixels at a ratio of 1.5
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

    void largeCellsHoldTheirValuesInEitherNotation()
    {
        CanvasBench bench(firstScene());
        bench.playhead.seek(bench.playhead.end());
        bench.options.setGridShown(false);
        // Whether a cell in the middle of the view has anything but its colour to the left and
        // right of the sample.
        const auto inked = [&bench](int first = 0) {
            const QPoint pixel = *bench.canvas.pixelAt(bench.canvas.view().center());
            const QImage grabbed = bench.canvas.grab().toImage();
            const QRect cell = bench.canvas.mapping().deviceCellOf(pixel);
            const QRgb colour = *bench.playhead.frame()->view().at(pixel.x(), pixel.y());
            int ink = 0;
            for (int y = cell.top(); y <= cell.bottom(); ++y) {
                for (int x = cell.left() + first; x < cell.center().x(); ++x)
                    ink += grabbed.pixel(x, y) != colour ? 1 : 0;
            }
            return ink;
        };
        bench.canvas.setZoom(16);
        QCOMPARE(inked(), 0);
        for (const int zoom : {36, 40, 48}) {
            bench.canvas.setZoom(zoom);
            QCOMPARE(inked(zoom / 2 - 3), 0); // they keep off the sample
        }
        bench.canvas.setZoom(64);
        const int decimal = inked();
        if (bench.canvas.devicePixelRatioF() >= 2) {
            QCOMPARE(decimal, 0); // even the largest cells have no room
            return;
        }
        QVERIFY(decimal > 20);
        bench.options.setHexadecimal(true);
        QVERIFY(inked() > 20);
        QVERIFY(inked() != decimal);
    }

    void differencesAppearOnlyWhenDecided()
    {
        Scene scene = firstScene();
        scene.settings.rounding = ByteRounding::Truncate;
        CanvasBench exact(scene);
        scene.settings.arithmetic = Arithmetic::Fixed16;
        CanvasBench bench(scene);
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

    void theClippedPolygonIsDrawnWhereItIsWanted()
    {
        // The third vertex lies behind the eye: clipping leaves four corners, so two triangles.
        CanvasBench bench(sceneOf({triangle3({-1, -0.5, 2}, {1, -0.5, 2}, {0, 1, 5.5})}));
        const TracedScene &traced = *bench.playhead.traced();
        const auto corners = clippedPolygon(traced.scene, *traced.primitives.sourceOf(0));
        QCOMPARE(corners.size(), 4U);
        QCOMPARE(traced.trace->primitiveCount(), 2U);
        const auto shown = [&](std::size_t triangle, bool isWanted) {
            bench.playhead.seek(traced.trace->indexOfSetUp(triangle) + 1);
            bench.options.setClippingShown(isWanted);
            return bench.canvas.grab().toImage();
        };
        const auto middle = [&](const std::vector<std::size_t> &of) {
            QPointF sum;
            for (const std::size_t corner : of)
                sum += bench.canvas.positionOf(corners[corner]) / double(of.size());
            return sum.toPoint();
        };
        const auto differsAt = [](const QImage &a, const QImage &b, const QPoint &place) {
            const QPoint device = place * a.devicePixelRatio();
            const QRect around(device - QPoint(2, 2), QSize(5, 5));
            return a.copy(around) != b.copy(around);
        };

        const QImage plain = shown(0, false);
        const QImage marked = shown(0, true);
        QVERIFY(differsAt(plain, marked, middle({2, 3})));
        QVERIFY(differsAt(plain, marked, middle({3, 0})));
        QVERIFY(!differsAt(plain, marked, middle({0, 1, 2})));
        QVERIFY(!differsAt(plain, marked, middle({0, 2, 3})));
        QVERIFY(shown(0, false) == plain);
        // The other triangle's outline is drawn; of the polygon, its edges and the fan's inner
        // edge.
        QVERIFY(differsAt(shown(1, false), shown(1, true), middle({0, 1})));
    }

    void figureHoldsCellsNamesAndColumn()
    {
        CanvasBench bench(firstScene());
        bench.playhead.seekToSpan(20);
        const QByteArray figure = svgFigure(bench.playhead, bench.options);

        const QStringList texts = textsIn(figure);
        for (const char *text : {"P0", "P1", "P2", "y", "B", "T", "10", "60"})
            QVERIFY2(texts.contains(QLatin1String(text)), text);
        QCOMPARE(svgFigure(bench.playhead, bench.options), figure);
    }

    void figureNamesTheCornersOfAPolygon()
    {
        Shape polygon;
        polygon.kind = PrimitiveKind::Polygon;
        for (const auto &[x, y] :
             {std::pair(4, 4), std::pair(30, 6), std::pair(34, 30), std::pair(9, 28)})
            polygon.vertices.push_back({latticePixel(x, y), Colour{{255, 0, 0}}});
        CanvasBench bench(sceneOf(polygon, "polygon-parity", frameOf(40, 40)));

        const QStringList texts = textsIn(svgFigure(bench.playhead, bench.options));
        for (const char *text : {"P0", "P1", "P2", "P3"})
            QVERIFY2(texts.contains(QLatin1String(text)), text);
    }

    void figureHoldsTheLayers()
    {
        if (textFontFile().isEmpty())
            QSKIP("DejaVu Sans is not installed (fonts-dejavu-core)");
        CanvasBench bench(firstScene());
        const auto pathsOf = [&bench](const QStringList &layers) {
            bench.options.setLayers(layers);
            return svgFigure(bench.playhead, bench.options).count("<path");
        };
        const qsizetype none = pathsOf({});

        // An address for each pixel.
        QVERIFY(pathsOf({u"memory"_s}) >= none + 64 * 48);
        QCOMPARE(pathsOf({u"edge-table"_s}), none);
    }

    void figureHoldsWhatLayersSayBesideThem_data()
    {
        QTest::addColumn<QString>("layer");
        QTest::addColumn<QString>("said");
        QTest::newRow("whose numbers they are")
            << "half-planes"
            << "Half-planes: exact, since “Column scan” computes no edge functions";
        QTest::newRow("what stands in a cell") << "levels"
                                               << "R, G, B";
        QTest::newRow("what there is no room for")
            << "affine-map"
            << "The weights stay, all areas are multiplied by";
    }
    void figureHoldsWhatLayersSayBesideThem()
    {
        QFETCH(QString, layer);
        QFETCH(QString, said);
        CanvasBench bench(firstScene());
        bench.playhead.seekToSpan(20);
        const auto isSaid = [&] {
            const QString texts
                = textsIn(svgFigure(bench.playhead, bench.options)).join(u' ').simplified();
            return texts.contains(said);
        };
        QVERIFY(!isSaid());
        bench.options.setLayers({layer});
        QVERIFY(isSaid());
    }

    void figureOfAHugeFrameIsRefused()
    {
        Scene scene = firstScene();
        scene.frame.width = 1024;
        scene.frame.height = 512;
        CanvasBench bench(scene);
        const QString reason = exportSvg(u"never.svg"_s, bench.playhead, bench.options);
        QVERIFY2(reason.contains(u"1024 × 512"_s), qPrintable(reason));
        QVERIFY(!QFile::exists(u"never.svg"_s));
    }

    void repaintsAHugeFrameQuickly()
    {
        Scene scene = firstScene();
        scene.frame.width = 4096;
        scene.frame.height = 4096;
        CanvasBench bench(scene);
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
};

PIXELPLUMB_TEST(TestCanvasPainting)

} // namespace tst_canvaspainting

#include "tst_canvaspainting.moc"
