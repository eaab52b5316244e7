// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/columnrecord.h"
#include "tests/support/defaultscene.h"
#include "widgets/displayoptions.h"
#include "widgets/pixelgrid.h"
#include "widgets/pixelgridscene.h"
#include "widgets/playhead.h"

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

using namespace pixelplumb;

namespace {

/// The grid around pixel (27, 20), the picked one, of the default scene.
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
        const QPointF place = grid.mapping().sample(pixel) / grid.devicePixelRatioF();
        QTest::mouseClick(&grid, button, {}, place.toPoint());
    }
};

} // namespace

class TestPixelGrid : public QObject {
    Q_OBJECT

private slots:
    void everyCellIsAWholeNumberOfDevicePixels_data();
    void everyCellIsAWholeNumberOfDevicePixels();
    void rowsGrowInTheDirectionOfTheFrame_data();
    void rowsGrowInTheDirectionOfTheFrame();
    void cellsShowTheFrameAtThePosition();
    void leftClickPicksAndGoesToTheWrite();
    void rightClickOnlyPicks();
    void arrowKeysNudgeAsTheFrameIsSeen_data();
    void arrowKeysNudgeAsTheFrameIsSeen();
    void wheelAndKeysChangeTheNumberOfCells();
    void candidatesAreTheRowsThatAreNotWrittenYet();
    void differencesAreShownOnceTheyAreDecided();
    void tiesAreMarkedWhereASampleLiesOnAnEdge();
};

void TestPixelGrid::everyCellIsAWholeNumberOfDevicePixels_data()
{
    QTest::addColumn<QSize>("area");
    QTest::addColumn<int>("count");
    QTest::newRow("fits") << QSize(90, 90) << 9;
    QTest::newRow("scale 1.5") << QSize(691, 377) << 9;
    QTest::newRow("scale 2") << QSize(921, 501) << 33;
    QTest::newRow("higher than wide") << QSize(200, 700) << 5;
    QTest::newRow("too small for its cells") << QSize(20, 20) << 33;
}

void TestPixelGrid::everyCellIsAWholeNumberOfDevicePixels()
{
    QFETCH(const QSize, area);
    QFETCH(const int, count);

    const PixelGridMapping mapping(area, {}, count, QPoint(40, 20), FrameOrigin::BottomLeft);

    QVERIFY(mapping.cellSize() >= 1);
    QCOMPARE(mapping.grid().size(), QSize(1, 1) * mapping.cellSize() * count);
    QCOMPARE(mapping.firstColumn(), 40 - count / 2);
    for (int x = mapping.firstColumn(); x < mapping.endColumn(); ++x) {
        for (int y = mapping.firstRow(); y < mapping.endRow(); ++y) {
            const QPoint pixel(x, y);
            const QRect cell = mapping.cell(pixel);
            QCOMPARE(mapping.pixelAt(cell.topLeft()), pixel);
            QCOMPARE(mapping.pixelAt(cell.bottomRight()), pixel);
            QCOMPARE(mapping.pixelAt(mapping.sample(pixel)), pixel);
        }
    }
    QVERIFY(!mapping.pixelAt(mapping.grid().topLeft() - QPoint(1, 0)));
}

void TestPixelGrid::rowsGrowInTheDirectionOfTheFrame_data()
{
    QTest::addColumn<FrameOrigin>("origin");
    QTest::addColumn<int>("upward");
    QTest::newRow("bottom left") << FrameOrigin::BottomLeft << 1;
    QTest::newRow("top left") << FrameOrigin::TopLeft << -1;
}

void TestPixelGrid::rowsGrowInTheDirectionOfTheFrame()
{
    QFETCH(const FrameOrigin, origin);
    QFETCH(const int, upward);

    const PixelGridMapping mapping(QSize(90, 90), {}, 9, QPoint(40, 20), origin);

    const QRect middle = mapping.cell(QPoint(40, 20));
    QCOMPARE(middle, QRect(40, 40, 10, 10));
    QCOMPARE(mapping.cell(QPoint(41, 20 + upward)), middle.translated(10, -10));
    QCOMPARE(mapping.sample(QPoint(40, 20)), QPointF(45, 45));
    QCOMPARE(mapping.position(40.5, 20 + 0.5 * upward), QPointF(50, 40));
}

void TestPixelGrid::cellsShowTheFrameAtThePosition()
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
        const QRect cell = grid.mapping().cell(written);
        return image.pixel(cell.right() - 1, cell.bottom() - 1); // clear of value, dot and signs
    };

    playhead.seek(0);
    playhead.pick(QPoint(27, 20));
    QCOMPARE(colourShown(), qRgb(0, 0, 0));

    playhead.seek(playhead.end());
    playhead.pick(QPoint(27, 20));
    QCOMPARE(colourShown(), *playhead.frame()->view().at(written.x(), written.y()));
}

void TestPixelGrid::leftClickPicksAndGoesToTheWrite()
{
    GridBench bench;
    Playhead &playhead = bench.playhead;

    bench.click(QPoint(29, 22), Qt::LeftButton);
    QCOMPARE(playhead.pickedPixel(), QPoint(29, 22));
    QCOMPARE(playhead.pixelInHand(), QPoint(29, 22));

    // A pixel that nothing writes is picked, and time stands still.
    playhead.pick(QPoint(4, 6));
    const std::size_t position = playhead.position();
    bench.click(QPoint(3, 8), Qt::LeftButton);
    QCOMPARE(playhead.pickedPixel(), QPoint(3, 8));
    QCOMPARE(playhead.position(), position);
}

void TestPixelGrid::rightClickOnlyPicks()
{
    GridBench bench;

    bench.click(QPoint(29, 22), Qt::RightButton);

    QCOMPARE(bench.playhead.pickedPixel(), QPoint(29, 22));
    QCOMPARE(bench.playhead.position(), std::size_t(0));
}

void TestPixelGrid::arrowKeysNudgeAsTheFrameIsSeen_data()
{
    rowsGrowInTheDirectionOfTheFrame_data();
}

void TestPixelGrid::arrowKeysNudgeAsTheFrameIsSeen()
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

void TestPixelGrid::wheelAndKeysChangeTheNumberOfCells()
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

void TestPixelGrid::candidatesAreTheRowsThatAreNotWrittenYet()
{
    Playhead playhead;
    DisplayOptions options;
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
    const PixelGridMapping mapping(QSize(90, 90), {}, 9, QPoint(33, 10), FrameOrigin::BottomLeft);
    playhead.seekToSpan(std::size_t(rowOf(33)));
    const ColumnRecord column(playhead.traced()->trace->span(std::size_t(rowOf(33))));

    const PixelGridScene entered = pixelGridScene(playhead, options, mapping);
    QCOMPARE(entered.firstCandidate, column.span().firstDrawn);
    QCOMPARE(entered.endCandidate, column.span().endDrawn);
    QVERIFY(!entered.pixelInHand);

    playhead.step(StepUnit::Sample, StepDirection::Forward);
    const PixelGridScene stepped = pixelGridScene(playhead, options, mapping);
    QCOMPARE(stepped.firstCandidate, column.span().firstDrawn + 1);
    QCOMPARE(stepped.pixelInHand, QPoint(33, int(column.span().firstDrawn)));
}

void TestPixelGrid::differencesAreShownOnceTheyAreDecided()
{
    // 16.16 loses the edge's last bits over a long run and colours other pixels than the truth.
    Scene scene = defaultSceneIn(Arithmetic::Fixed16);
    scene.frame.width = 2048;
    scene.frame.height = 700;
    scene.triangles = {{{vertexAt(0, 0, {{0, 0, 0}}), vertexAt(2047, 0, {{255, 200, 1}}),
                         vertexAt(2047, 683, {{3, 9, 255}})}}};
    Playhead playhead;
    DisplayOptions options;
    playhead.setTraced(traceScene(scene));
    const DifferenceMap &differences = playhead.traced()->differences;
    std::optional<QPoint> wrong;
    for (int x = 0; x < scene.frame.width && !wrong; ++x) {
        for (int y = 0; y < scene.frame.height && !wrong; ++y) {
            if (differences.at(x, y) != Difference::None)
                wrong = QPoint(x, y);
        }
    }
    QVERIFY(wrong);
    const PixelGridMapping mapping(QSize(90, 90), {}, 9, *wrong, FrameOrigin::BottomLeft);
    const auto signsThere = [&] {
        for (const GridCell &cell : pixelGridScene(playhead, options, mapping).cells) {
            if (cell.pixel == *wrong)
                return cell.signs.size();
        }
        return std::size_t(0);
    };

    playhead.seek(playhead.traced()->decidedAt(wrong->x(), wrong->y()) - 1);
    QCOMPARE(signsThere(), std::size_t(0));
    playhead.seek(playhead.traced()->decidedAt(wrong->x(), wrong->y()));
    QCOMPARE(signsThere(), std::size_t(1));
    options.setDifferencesShown(false);
    QCOMPARE(signsThere(), std::size_t(0));
}

void TestPixelGrid::tiesAreMarkedWhereASampleLiesOnAnEdge()
{
    Playhead playhead;
    DisplayOptions options;
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
    const PixelGridMapping mapping(QSize(90, 90), {}, 9, QPoint(4, 5), FrameOrigin::BottomLeft);

    QList<QPoint> ties;
    for (const GridCell &cell : pixelGridScene(playhead, options, mapping).cells) {
        if (std::ranges::find(cell.signs, Sign::Tie) != cell.signs.end())
            ties.append(cell.pixel);
    }

    QCOMPARE(ties, QList<QPoint>{QPoint(4, 5)}); // P0 itself
}

QTEST_MAIN(TestPixelGrid)
#include "tst_pixelgrid.moc"
