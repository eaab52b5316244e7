// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "widgets/canvaspicture.h"
#include "widgets/framepainter.h"
#include "widgets/ruler.h"
#include "widgets/viewmapping.h"

#include <QTest>

using namespace pixelplumb;

namespace {

FrameSpec frameOf(int width, int height)
{
    FrameSpec frame;
    frame.width = width;
    frame.height = height;
    return frame;
}

FrameSpec downwardFrame()
{
    FrameSpec frame = frameOf(64, 48);
    frame.origin = FrameOrigin::TopLeft;
    return frame;
}

FrameSpec farFrame()
{
    FrameSpec frame = frameOf(30, 20);
    frame.firstColumn = -7;
    frame.firstRow = 1000;
    return frame;
}

const FrameSpec upward = frameOf(64, 48);
const FrameSpec downward = downwardFrame();

struct Ratio {
    double devicePixelRatio;
    QPointF fraction; ///< of the widget's corner
};
const std::array ratios = {Ratio{1, {}}, Ratio{1.5, {}}, Ratio{1.5, {0.5, 0.5}}, Ratio{2, {}}};

/// A picture in which every pixel has a colour of its own.
QImage numbered(const FrameSpec &frame)
{
    QImage picture(frame.width, frame.height, QImage::Format_RGB32);
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x)
            picture.setPixel(x, y, QRgb(0xff000000U | unsigned(y * frame.width + x)));
    }
    return picture;
}

} // namespace

class ViewMappingTest : public QObject {
    Q_OBJECT

private slots:
    void thePositionOfAPixelReachesThatPixel_data() { addMappings(); }
    void thePositionOfAPixelReachesThatPixel();
    void aPositionReachesThePixelThatIsDrawnThere_data() { addMappings(); }
    void aPositionReachesThePixelThatIsDrawnThere();
    void samplePointsComeBack_data() { addMappings(); }
    void samplePointsComeBack();
    void cellsHaveWholeDevicePixels();
    void yGrowsUpOrDownAsTheFrameSays();
    void everySixteenthCanBeReached_data();
    void everySixteenthCanBeReached();
    void showsEveryPixelOfALargeFrameOnceBelowOneToOne();
    void fitsTheFrameIntoTheView_data();
    void fitsTheFrameIntoTheView();
    void zoomingKeepsThePixelUnderTheAnchor();
    void zoomingInAndOutComesBack();
    void movingLeavesPartOfTheFrameInView();
    void zoomStepsVisitEveryRung();
    void rulerStepsAreOneTwoFive_data();
    void rulerStepsAreOneTwoFive();
    void rulerTicksStandOnTheirMultiples();
    void linesAreClippedToARectangle_data();
    void linesAreClippedToARectangle();

private:
    static void addMappings();
};

void ViewMappingTest::addMappings()
{
    QTest::addColumn<ViewMapping>("mapping");
    const std::array frames = {std::pair{"y upward", upward}, std::pair{"y downward", downward},
                               std::pair{"far from the origin", farFrame()}};
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

void ViewMappingTest::thePositionOfAPixelReachesThatPixel()
{
    QFETCH(ViewMapping, mapping);
    if (mapping.zoom().framePixels > 1)
        return; // not every pixel is drawn
    const FrameSpec &frame = mapping.frame();
    std::vector<QPoint> missed;
    for (int y = frame.firstRow; y < frame.firstRow + frame.height; ++y) {
        for (int x = frame.firstColumn; x < frame.firstColumn + frame.width; ++x) {
            if (mapping.pixelAt(mapping.positionOf(QPoint(x, y))) != QPoint(x, y))
                missed.emplace_back(x, y);
        }
    }
    QCOMPARE(missed, std::vector<QPoint>());
}

void ViewMappingTest::aPositionReachesThePixelThatIsDrawnThere()
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
                reached.setPixel(
                    x, y,
                    picture.pixel(pixel->x() - frame.firstColumn, pictureLine(frame, pixel->y())));
        }
    }
    QCOMPARE(reached, shown);
    const QPointF outside = mapping.positionOfDevice(device.topLeft() - QPoint(1, 0));
    QCOMPARE(mapping.pixelAt(outside), std::nullopt);
    const QPointF below = mapping.positionOfDevice(device.bottomLeft() + QPoint(0, 1));
    QCOMPARE(mapping.pixelAt(below), std::nullopt);
}

void ViewMappingTest::samplePointsComeBack()
{
    QFETCH(ViewMapping, mapping);
    const FrameSpec &frame = mapping.frame();
    // A device pixel is this long; the point comes back to within one.
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

void ViewMappingTest::cellsHaveWholeDevicePixels()
{
    for (const Ratio &ratio : ratios) {
        const ViewMapping mapping(upward, ViewZoom::fromNumber(5), {2, 3}, ratio.devicePixelRatio,
                                  ratio.fraction);
        const QRectF cell = mapping.cellOf({10, 10});
        const QPointF corner = cell.topLeft() * ratio.devicePixelRatio + ratio.fraction;
        // 2 + 10·5 and 3 + (48 − 1 − 10)·5
        QCOMPARE(corner, QPointF(52, 188));
        QCOMPARE(cell.width() * ratio.devicePixelRatio, 5.0);
    }
}

void ViewMappingTest::yGrowsUpOrDownAsTheFrameSays()
{
    const ViewMapping up(upward, ViewZoom::fromNumber(10), {0, 0});
    QCOMPARE(up.pixelAt({5, 5}), std::optional(QPoint(0, 47)));
    QCOMPARE(up.positionOf(0, 47), QPointF(5, 5));
    const ViewMapping down(downward, ViewZoom::fromNumber(10), {0, 0});
    QCOMPARE(down.pixelAt({5, 5}), std::optional(QPoint(0, 0)));
    QCOMPARE(down.positionOf(0, 47), QPointF(5, 475));
}

void ViewMappingTest::everySixteenthCanBeReached_data()
{
    QTest::addColumn<int>("zoom");
    QTest::newRow("a device pixel each") << 16;
    QTest::newRow("four device pixels each") << 64;
}

void ViewMappingTest::everySixteenthCanBeReached()
{
    QFETCH(int, zoom);
    const ViewMapping mapping(upward, ViewZoom::fromNumber(zoom), {0, 0});
    for (Lattice sixteenth = 0; sixteenth < 32; ++sixteenth) {
        const LatticePoint point{sixteenth * 16, sixteenth * 16};
        QCOMPARE(mapping.latticeAt(mapping.positionOf(point)), point);
    }
}

void ViewMappingTest::showsEveryPixelOfALargeFrameOnceBelowOneToOne()
{
    const ViewMapping mapping(frameOf(10, 1), ViewZoom::fromNumber(-4), {0, 0});

    // Blocks of four: 0…3, 4…7, 8…9; each shows its middle pixel, the last what it has.
    QCOMPARE(mapping.devicePicture(), QRect(0, 0, 3, 1));
    QCOMPARE(mapping.pixelAt({0, 0}), std::optional(QPoint(2, 0)));
    QCOMPARE(mapping.pixelAt({1, 0}), std::optional(QPoint(6, 0)));
    QCOMPARE(mapping.pixelAt({2, 0}), std::optional(QPoint(9, 0)));
}

void ViewMappingTest::fitsTheFrameIntoTheView_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<double>("ratio");
    QTest::addColumn<int>("zoom");
    QTest::newRow("limited by height") << 64 << 48 << 1.0 << 8; // 400 / 48 = 8.3
    QTest::newRow("limited by width") << 100 << 10 << 1.0 << 6; // 600 / 100
    QTest::newRow("device pixels count") << 100 << 10 << 2.0 << 12;
    QTest::newRow("tiny frame") << 2 << 2 << 1.0 << 64;
    QTest::newRow("just fits") << 600 << 400 << 1.0 << 1;
    QTest::newRow("one column too many") << 601 << 400 << 1.0 << -2;
    QTest::newRow("large") << 4096 << 4096 << 1.0 << -11; // 4096 / 400 = 10.24
}

void ViewMappingTest::fitsTheFrameIntoTheView()
{
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(double, ratio);
    QFETCH(int, zoom);
    const QRectF view(40, 10, 600, 400);

    const ViewMapping mapping = ViewMapping::fitted(frameOf(width, height), view, ratio);

    QCOMPARE(mapping.zoom().number(), zoom);
    const QRect picture = mapping.devicePicture();
    const QRect device = mapping.deviceRect(view);
    QVERIFY(device.contains(picture));
    QVERIFY((picture.center() - device.center()).manhattanLength() <= 2);
}

void ViewMappingTest::zoomingKeepsThePixelUnderTheAnchor()
{
    for (const Ratio &ratio : ratios) {
        ViewMapping mapping(upward, ViewZoom::fromNumber(1), {7, 9}, ratio.devicePixelRatio,
                            ratio.fraction);
        const QPointF anchor = mapping.positionOf(QPoint(41, 17));
        for (int i = 0; i < 20; ++i) {
            mapping = mapping.zoomedAt(anchor, mapping.zoom().nextLarger());
            QCOMPARE(mapping.pixelAt(anchor), std::optional(QPoint(41, 17)));
        }
    }
}

void ViewMappingTest::zoomingInAndOutComesBack()
{
    const ViewMapping start(upward, ViewZoom::fromNumber(8), {7, 9});
    const QPointF anchor(200, 111);
    const ViewMapping there = start.zoomedAt(anchor, ViewZoom::fromNumber(32));
    QCOMPARE(there.zoomedAt(anchor, ViewZoom::fromNumber(8)), start);
}

void ViewMappingTest::movingLeavesPartOfTheFrameInView()
{
    const QRectF view(40, 10, 600, 400);
    const ViewMapping mapping = ViewMapping::fitted(upward, view, 1);
    for (const QPoint &move :
         {QPoint(9999, 0), QPoint(-9999, 0), QPoint(0, 9999), QPoint(0, -9999)}) {
        const ViewMapping moved = mapping.movedBy(move).keptInside(view);
        const QRect visible = moved.devicePicture() & moved.deviceRect(view);
        QVERIFY(visible.width() >= 24 && visible.height() >= 24);
    }
}

void ViewMappingTest::zoomStepsVisitEveryRung()
{
    std::vector<int> up;
    ViewZoom zoom = ViewZoom::fromNumber(-4);
    while (zoom.nextLarger() != zoom) {
        up.push_back(zoom.number());
        zoom = zoom.nextLarger();
    }
    up.push_back(zoom.number());
    std::vector<int> down;
    for (; zoom.number() > -4; zoom = zoom.nextSmaller())
        down.insert(down.begin(), zoom.number());
    down.insert(down.begin(), zoom.number());

    QCOMPARE(up, down);
    const std::vector<int> expected{-4, -3, -2, 1,  2,  3,  4,  5,  6, 8,
                                    10, 12, 16, 20, 24, 32, 40, 48, 64};
    QCOMPARE(up, expected);
}

void ViewMappingTest::rulerStepsAreOneTwoFive_data()
{
    QTest::addColumn<double>("pixelLength");
    QTest::addColumn<std::int64_t>("step");
    QTest::newRow("64 a pixel") << 64.0 << std::int64_t(1);
    QTest::newRow("40 a pixel") << 40.0 << std::int64_t(1);
    QTest::newRow("39 a pixel") << 39.0 << std::int64_t(2);
    QTest::newRow("8 a pixel") << 8.0 << std::int64_t(5);
    QTest::newRow("7 a pixel") << 7.0 << std::int64_t(10);
    QTest::newRow("a tenth a pixel") << 0.1 << std::int64_t(500);
}

void ViewMappingTest::rulerStepsAreOneTwoFive()
{
    QFETCH(double, pixelLength);
    QFETCH(std::int64_t, step);
    QCOMPARE(rulerStep(pixelLength, 40), step);
}

void ViewMappingTest::rulerTicksStandOnTheirMultiples()
{
    // Labels every 20 px (20·2 ≥ 40), ticks every 2 px (2·2 ≥ 4): 5 would miss the label at −20.
    const std::vector<RulerTick> ticks = rulerTicks(-21.5, -15, 2, 40, 4);
    const std::vector<RulerTick> expected{
        {-20, TickKind::Labelled}, {-18, TickKind::Plain}, {-16, TickKind::Plain}};
    QCOMPARE(ticks, expected);
}

void ViewMappingTest::linesAreClippedToARectangle_data()
{
    QTest::addColumn<QLineF>("line");
    QTest::addColumn<bool>("visible");
    QTest::addColumn<QLineF>("expected");
    QTest::newRow("inside") << QLineF(1, 1, 9, 9) << true << QLineF(1, 1, 9, 9);
    QTest::newRow("through") << QLineF(-10, 5, 1e9, 5) << true << QLineF(0, 5, 10, 5);
    QTest::newRow("over a corner") << QLineF(-5, 5, 5, 15) << true << QLineF(0, 10, 0, 10);
    QTest::newRow("beside") << QLineF(-5, -1, 20, -1) << false << QLineF();
    QTest::newRow("a point inside") << QLineF(3, 3, 3, 3) << true << QLineF(3, 3, 3, 3);
}

void ViewMappingTest::linesAreClippedToARectangle()
{
    QFETCH(QLineF, line);
    QFETCH(bool, visible);
    QFETCH(QLineF, expected);
    const std::optional<QLineF> part = clipped(line, QRectF(0, 0, 10, 10));
    QCOMPARE(part.has_value(), visible);
    if (visible)
        QCOMPARE(*part, expected);
}

QTEST_GUILESS_MAIN(ViewMappingTest)
#include "tst_viewmapping.moc"
