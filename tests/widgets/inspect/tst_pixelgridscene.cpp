// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/testprogram.h"
#include "widgets/inspect/pixelgridscene.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"

#include <QTest>

namespace tst_pixelgridscene {

using namespace pixelplumb;

/// The positions and contents of the pixel grid's cells, without a widget.
class TestPixelGridScene : public QObject {
    Q_OBJECT

private slots:
    void everyCellIsAWholeNumberOfDevicePixels_data();
    void everyCellIsAWholeNumberOfDevicePixels();
    void rowsGrowInTheDirectionOfTheFrame_data();
    void rowsGrowInTheDirectionOfTheFrame();
    void boundsAreNamedAfterTheCurrentSpanAmongTheCells();
    void candidatesAreTheRowsThatAreNotWrittenYet();
    void differencesAreShownOnceTheyAreDecided();
    void tiesAreMarkedWhereASampleLiesOnAnEdge();
};

void TestPixelGridScene::everyCellIsAWholeNumberOfDevicePixels_data()
{
    QTest::addColumn<QSize>("area");
    QTest::addColumn<int>("count");
    QTest::newRow("fits") << QSize(90, 90) << 9;
    QTest::newRow("scale 1.5") << QSize(691, 377) << 9;
    QTest::newRow("scale 2") << QSize(921, 501) << 33;
    QTest::newRow("higher than wide") << QSize(200, 700) << 5;
    QTest::newRow("too small for its cells") << QSize(20, 20) << 33;
}

void TestPixelGridScene::everyCellIsAWholeNumberOfDevicePixels()
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

void TestPixelGridScene::rowsGrowInTheDirectionOfTheFrame_data()
{
    QTest::addColumn<FrameOrigin>("origin");
    QTest::addColumn<int>("upward");
    QTest::newRow("bottom left") << FrameOrigin::BottomLeft << 1;
    QTest::newRow("top left") << FrameOrigin::TopLeft << -1;
}

void TestPixelGridScene::rowsGrowInTheDirectionOfTheFrame()
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

void TestPixelGridScene::boundsAreNamedAfterTheCurrentSpanAmongTheCells()
{
    Playhead playhead;
    DisplayOptions options;
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
    playhead.seekToSpan(std::size_t(rowOf(27)));
    const auto boundsAround = [&](const QPoint &picked) {
        const PixelGridMapping mapping(QSize(90, 90), {}, 9, picked, FrameOrigin::BottomLeft);
        return pixelGridScene(playhead, options, mapping).boundsOf;
    };

    QCOMPARE(boundsAround({27, 20}), QStringLiteral("column 27"));
    QCOMPARE(boundsAround({23, 20}), QStringLiteral("column 27")); // the last of the visible cells
    QCOMPARE(boundsAround({32, 20}), QString());
}

void TestPixelGridScene::candidatesAreTheRowsThatAreNotWrittenYet()
{
    Playhead playhead;
    DisplayOptions options;
    playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
    const PixelGridMapping mapping(QSize(90, 90), {}, 9, QPoint(33, 10), FrameOrigin::BottomLeft);
    playhead.seekToSpan(std::size_t(rowOf(33)));
    const SpanRecord column = playhead.traced()->trace->span(std::size_t(rowOf(33)));

    const PixelGridScene entered = pixelGridScene(playhead, options, mapping);
    QCOMPARE(entered.firstCandidate, column.firstDrawn);
    QCOMPARE(entered.endCandidate, column.endDrawn);
    QVERIFY(!entered.currentPixel);

    playhead.step(StepUnit::Sample, StepDirection::Forward);
    const PixelGridScene stepped = pixelGridScene(playhead, options, mapping);
    QCOMPARE(stepped.firstCandidate, column.firstDrawn + 1);
    QCOMPARE(stepped.currentPixel, QPoint(33, int(column.firstDrawn)));
}

void TestPixelGridScene::differencesAreShownOnceTheyAreDecided()
{
    // Over a long run, 16.16 loses the edge's last bits and colours other pixels than the truth.
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

void TestPixelGridScene::tiesAreMarkedWhereASampleLiesOnAnEdge()
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

PIXELPLUMB_TEST(TestPixelGridScene)

} // namespace tst_pixelgridscene

#include "tst_pixelgridscene.moc"
