// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/testprogram.h"
#include "widgets/inspect/pixelgrid.h"
#include "widgets/look/cellvalues.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"

#include <QTest>
#include <QtWidgets>

namespace tst_pixelgrid {

using namespace pixelplumb;

namespace {

/// The grid around the picked pixel (27, 20) of the default scene.
struct GridBench {
    Playhead playhead;
    DisplayOptions options;
    PixelGrid grid{&playhead, &options};

    GridBench()
    {
        playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
        playhead.pick(QPoint(27, 20));
        grid.resize(440, 300);
    }

    void click(const QPoint &pixel, Qt::MouseButton button)
    {
        QTest::mouseClick(&grid, button, {}, grid.mapping().positionOf(pixel).toPoint());
    }
};

} // namespace

/// The pixel grid as a widget: what it paints, and what clicks, keys and the wheel do.
class TestPixelGrid : public QObject {
    Q_OBJECT

private slots:
    void cellsShowTheFrameAtThePosition()
    {
        Playhead playhead;
        DisplayOptions options;
        options.setGridShown(false);
        playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
        PixelGrid grid(&playhead, &options);
        grid.resize(440, 300);
        const QPoint written(24, 20);
        const auto colourShown = [&] {
            const QImage image = grid.grab().toImage();
            const QRect cell = grid.mapping().deviceCellOf(written);
            return image.pixel(cell.right() - 1,
                               cell.bottom() - 1); // away from value, dot and signs
        };

        playhead.seek(0);
        playhead.pick(QPoint(27, 20));
        QCOMPARE(colourShown(), qRgb(0, 0, 0));

        playhead.seek(playhead.end());
        playhead.pick(QPoint(27, 20));
        QCOMPARE(colourShown(), *playhead.frame()->view().at(written.x(), written.y()));
    }

    void leftClickPicksAndGoesToTheWrite()
    {
        GridBench bench;
        Playhead &playhead = bench.playhead;

        bench.click(QPoint(29, 22), Qt::LeftButton);
        QCOMPARE(playhead.pickedPixel(), QPoint(29, 22));
        QCOMPARE(playhead.currentPixel(), QPoint(29, 22));

        // A click picks a pixel that nothing writes; the position stays.
        playhead.pick(QPoint(4, 6));
        const std::size_t position = playhead.position();
        bench.click(QPoint(3, 8), Qt::LeftButton);
        QCOMPARE(playhead.pickedPixel(), QPoint(3, 8));
        QCOMPARE(playhead.position(), position);
    }

    void rightClickOnlyPicks()
    {
        GridBench bench;

        bench.click(QPoint(29, 22), Qt::RightButton);

        QCOMPARE(bench.playhead.pickedPixel(), QPoint(29, 22));
        QCOMPARE(bench.playhead.position(), std::size_t(0));
    }

    void arrowKeysNudgeAsTheFrameIsSeen_data()
    {
        QTest::addColumn<FrameOrigin>("origin");
        QTest::addColumn<int>("upward");
        QTest::newRow("bottom left") << FrameOrigin::BottomLeft << 1;
        QTest::newRow("top left") << FrameOrigin::TopLeft << -1;
    }
    void arrowKeysNudgeAsTheFrameIsSeen()
    {
        QFETCH(const FrameOrigin, origin);
        QFETCH(const int, upward);
        Scene scene = defaultSceneIn(Arithmetic::Exact);
        scene.frame.origin = origin;
        Playhead playhead;
        DisplayOptions options;
        playhead.setTraced(traceScene(scene));
        playhead.pick(QPoint(20, 20));
        PixelGrid grid(&playhead, &options);

        QTest::keyClick(&grid, Qt::Key_Up);
        QCOMPARE(playhead.pickedPixel(), QPoint(20, 20 + upward));
        QTest::keyClick(&grid, Qt::Key_Right);
        QCOMPARE(playhead.pickedPixel(), QPoint(21, 20 + upward));
    }

    void wheelAndKeysChangeTheNumberOfCells()
    {
        Playhead playhead;
        DisplayOptions options;
        PixelGrid grid(&playhead, &options);
        const auto turn = [&grid](int angle) {
            QWheelEvent event(QPointF(10, 10), QPointF(10, 10), {}, QPoint(0, angle), Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(&grid, &event);
        };
        QCOMPARE(grid.cellCount(), 9);

        turn(60);
        QCOMPARE(grid.cellCount(), 9); // half a notch
        turn(60);
        QCOMPARE(grid.cellCount(), 7);
        QTest::keyClick(&grid, Qt::Key_Minus);
        QCOMPARE(grid.cellCount(), 9);
        grid.setCellCount(1000);
        QCOMPARE(grid.cellCount(), PixelGrid::mostCells);
        grid.setCellCount(0);
        QCOMPARE(grid.cellCount(), PixelGrid::fewestCells);
    }

    void boundsStandBesideTheCellsAtEveryScale()
    {
        GridBench bench;
        bench.playhead.seekToSpan(*bench.playhead.traced()->trace->spanOn(0, SpanAxis::Column, 27));

        const QImage image = bench.grid.grab().toImage();

        const QRect cells = bench.grid.mapping().devicePicture();
        const QRect beside(cells.right() + 3, 0, image.width() - cells.right() - 3, image.height());
        const QImage labels = image.copy(beside);
        QImage empty(labels.size(), labels.format());
        empty.fill(bench.grid.palette().color(QPalette::Window));
        QVERIFY(beside.width() > 60);
        QVERIFY(labels != empty);
    }

    void theCellsHaveTheWholeWidthWhereNoColumnIsCurrent()
    {
        GridBench bench;
        bench.grid.resize(500, 300);
        bench.playhead.seek(0);
        const ViewMapping cells = bench.grid.mapping();
        QVERIFY(cells.devicePicture().right() > 500 - 2 * cells.zoom().devicePixels);
        QVERIFY(cells.devicePicture().left() < 50);
        QVERIFY(cells.frame().height <= 9);

        bench.playhead.seekToSpan(20);
        // The labels y_B and y_T are there.
        QVERIFY(bench.grid.mapping().devicePicture().right()
                < (500 - 100) * bench.grid.devicePixelRatioF());
    }

    void nothingRunsThroughTheDigits()
    {
        const QRgb colour = qRgb(200, 200, 200);
        const QRectF cell(0, 0, 60, 60);
        const auto drawnOver = [&](Qt::GlobalColor line) {
            QImage image(60, 60, QImage::Format_RGB32);
            image.fill(colour);
            QPainter painter(&image);
            painter.setPen(QPen(QColor(line), 4));
            painter.drawLine(0, 60, 30, 0); // an edge
            painter.drawEllipse(QPointF(30, 30), 5, 5); // a handle
            drawCellValues(painter, cell, colour, Qt::black, {});
            return image;
        };
        const QImage one = drawnOver(Qt::red);
        const QImage other = drawnOver(Qt::yellow);
        QVERIFY(one != other);
        for (const int middle : {10, 30, 49}) { // the lines of R, G and B
            const QRect digits(4, middle - 3, 17, 6);
            QCOMPARE(one.copy(digits), other.copy(digits));
        }
    }
};

PIXELPLUMB_TEST(TestPixelGrid)

} // namespace tst_pixelgrid

#include "tst_pixelgrid.moc"
