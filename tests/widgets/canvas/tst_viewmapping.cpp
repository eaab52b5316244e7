// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "tests/support/framespec.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/viewratios.h"
#include "widgets/canvas/canvaspainter.h"
#include "widgets/look/framepainter.h"

#include <QTest>

#include <cmath>

namespace tst_viewmapping {

using namespace pixelplumb;

namespace {

FrameSpec downwardFrame()
{
    FrameSpec frame = frameOf(64, 48);
    frame.origin = FrameOrigin::TopLeft;
    return frame;
}

const FrameSpec upward = frameOf(64, 48);
const FrameSpec downward = downwardFrame();

/// A picture in which every pixel has its own colour.
QImage numbered(const FrameSpec &frame)
{
    QImage picture(frame.width, frame.height, QImage::Format_RGB32);
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x)
            picture.setPixel(x, y, QRgb(0xff000000U | unsigned(y * frame.width + x)));
    }
    return picture;
}

void addMappings()
{
    QTest::addColumn<ViewMapping>("mapping");
    const std::array frames = {std::pair{"y upward", upward}, std::pair{"y downward", downward},
                               std::pair{"far from the origin", frameOf(30, 20, -7, 1000)}};
    for (const auto &[name, frame] : frames) {
        for (const int zoom : {1, 2, 3, 7, 8, 21, -3}) {
            for (const Ratio &ratio : ratios)
                QTest::addRow("%s, zoom %d, ratio %g, corner at %g", name, zoom,
                              ratio.devicePixelRatio, ratio.fraction.x())
                    << ViewMapping(frame, ViewZoom::fromNumber(zoom), {13, -5},
                                   ratio.devicePixelRatio, ratio.fraction);
        }
    }
}

} // namespace

/// Which pixel is drawn at a position, and where a pixel is drawn.
class TestViewMapping : public QObject {
    Q_OBJECT

private slots:
    void thePositionOfAPixelReachesItOrItsDrawnNeighbour_data() { addMappings(); }
    void thePositionOfAPixelReachesItOrItsDrawnNeighbour()
    {
        QFETCH(ViewMapping, mapping);
        // Only one of this many pixels in a row is drawn; it represents the others.
        const int drawnTogether = std::max(1, mapping.zoom().framePixels);
        const FrameSpec &frame = mapping.frame();
        std::vector<QPoint> missed;
        for (int y = frame.firstRow; y < frame.firstRow + frame.height; ++y) {
            for (int x = frame.firstColumn; x < frame.firstColumn + frame.width; ++x) {
                const std::optional<QPoint> reached
                    = mapping.pixelAt(mapping.positionOf(QPoint(x, y)));
                if (!reached || std::abs(reached->x() - x) >= drawnTogether
                    || std::abs(reached->y() - y) >= drawnTogether)
                    missed.emplace_back(x, y);
            }
        }
        QCOMPARE(missed, std::vector<QPoint>());
    }

    void aPositionReachesThePixelThatIsDrawnThere_data() { addMappings(); }
    void aPositionReachesThePixelThatIsDrawnThere()
    {
        QFETCH(ViewMapping, mapping);
        const FrameSpec &frame = mapping.frame();
        const QImage picture = numbered(frame);
        const QRect device = mapping.devicePicture();
        QImage shown;
        enlargePicture(picture, mapping, device, shown);

        QImage reached(shown.size(), shown.format());
        reached.fill(Qt::white);
        for (int y = 0; y < shown.height(); ++y) {
            for (int x = 0; x < shown.width(); ++x) {
                const QPointF position = mapping.positionOfDevice(device.topLeft() + QPoint(x, y));
                if (const std::optional<QPoint> pixel = mapping.pixelAt(position))
                    reached.setPixel(x, y,
                                     picture.pixel(pixel->x() - frame.firstColumn,
                                                   pictureLine(frame, pixel->y())));
            }
        }
        QCOMPARE(reached, shown);
        const QPointF outside = mapping.positionOfDevice(device.topLeft() - QPoint(1, 0));
        QCOMPARE(mapping.pixelAt(outside), std::nullopt);
        const QPointF below = mapping.positionOfDevice(device.bottomLeft() + QPoint(0, 1));
        QCOMPARE(mapping.pixelAt(below), std::nullopt);
    }

    void samplePointsComeBack_data() { addMappings(); }
    void samplePointsComeBack()
    {
        QFETCH(ViewMapping, mapping);
        const FrameSpec &frame = mapping.frame();
        // The length of a device pixel; the point comes back to within one.
        const double tolerance = unitsPerPixel / mapping.zoom().factor() + 1;
        for (const QPointF &offset : {QPointF(0, 0), QPointF(3.25, 5.5), QPointF(-20, 70)}) {
            const LatticePoint point{Lattice((frame.firstColumn + offset.x()) * unitsPerPixel),
                                     Lattice((frame.firstRow + offset.y()) * unitsPerPixel)};
            const LatticePoint back = mapping.latticeAt(mapping.positionOf(point));
            QVERIFY2(std::abs(double(back.x - point.x)) <= tolerance,
                     qPrintable(QString::number(back.x)));
            QVERIFY2(std::abs(double(back.y - point.y)) <= tolerance,
                     qPrintable(QString::number(back.y)));
        }
    }

    void layersStandWhereTheMappingSays_data() { addMappings(); }
    void layersStandWhereTheMappingSays()
    {
        QFETCH(ViewMapping, mapping);
        const LayerSurface surface = layerSurface(mapping, {}, QPalette(Qt::white));

        for (const QPointF &sample : {QPointF(0, 0), QPointF(-3.25, 1001), QPointF(17.5, 12)}) {
            const QPointF away
                = surface.fromSamples.map(sample) - mapping.positionOf(sample.x(), sample.y());
            QVERIFY(std::abs(away.x()) < 1e-9 && std::abs(away.y()) < 1e-9);
        }
    }

    void cellsHaveWholeDevicePixels()
    {
        for (const Ratio &ratio : ratios) {
            const ViewMapping mapping(upward, ViewZoom::fromNumber(5), {2, 3},
                                      ratio.devicePixelRatio, ratio.fraction);
            const QRectF cell = mapping.cellOf({10, 10});
            const QPointF corner = cell.topLeft() * ratio.devicePixelRatio + ratio.fraction;
            // 2 + 10·5 and 3 + (48 − 1 − 10)·5
            QCOMPARE(corner, QPointF(52, 188));
            QCOMPARE(cell.width() * ratio.devicePixelRatio, 5.0);
        }
    }

    void yGrowsUpOrDownAsTheFrameSays()
    {
        const ViewMapping up(upward, ViewZoom::fromNumber(10), {0, 0});
        QCOMPARE(up.pixelAt({5, 5}), std::optional(QPoint(0, 47)));
        QCOMPARE(up.positionOf(0, 47), QPointF(5, 5));
        const ViewMapping down(downward, ViewZoom::fromNumber(10), {0, 0});
        QCOMPARE(down.pixelAt({5, 5}), std::optional(QPoint(0, 0)));
        QCOMPARE(down.positionOf(0, 47), QPointF(5, 475));
    }

    void everySixteenthCanBeReached_data()
    {
        QTest::addColumn<int>("zoom");
        QTest::newRow("a device pixel each") << 16;
        QTest::newRow("four device pixels each") << 64;
    }
    void everySixteenthCanBeReached()
    {
        QFETCH(int, zoom);
        const ViewMapping mapping(upward, ViewZoom::fromNumber(zoom), {0, 0});
        for (Lattice sixteenth = 0; sixteenth < 32; ++sixteenth) {
            const LatticePoint point{sixteenth * 16, sixteenth * 16};
            QCOMPARE(mapping.latticeAt(mapping.positionOf(point)), point);
        }
    }

    void showsEveryPixelOfALargeFrameOnceBelowOneToOne()
    {
        const ViewMapping mapping(frameOf(10, 1), ViewZoom::fromNumber(-4), {0, 0});

        // Blocks of four: 0…3, 4…7, 8…9; each shows its middle pixel, the last one the nearest it
        // has.
        QCOMPARE(mapping.devicePicture(), QRect(0, 0, 3, 1));
        QCOMPARE(mapping.pixelAt({0, 0}), std::optional(QPoint(2, 0)));
        QCOMPARE(mapping.pixelAt({1, 0}), std::optional(QPoint(6, 0)));
        QCOMPARE(mapping.pixelAt({2, 0}), std::optional(QPoint(9, 0)));
    }
};

PIXELPLUMB_TEST(TestViewMapping)

} // namespace tst_viewmapping

#include "tst_viewmapping.moc"
