// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/shapeoracle.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <set>

namespace tst_curvetruth {

using namespace pixelplumb;

namespace {

using PixelSet = std::set<std::pair<std::int64_t, std::int64_t>>;

PixelSet pixelsOf(const CasePicture &picture)
{
    PixelSet pixels;
    picture.forEachWritten([&](std::int64_t x, std::int64_t y) { pixels.insert({x, y}); });
    return pixels;
}

/// A point of a curve, units of 1/(256·parts^degree) px.
struct CurvePoint {
    Int128 x = 0;
    Int128 y = 0;
    Int128 pixel = 0;
};

/// B(part/parts) by the Bernstein sum.
CurvePoint pointOn(const Shape &curve, std::int64_t part, std::int64_t parts)
{
    const std::size_t degree = curve.vertices.size() - 1;
    const std::array<std::int64_t, 4> binomials = degree == 2
        ? std::array<std::int64_t, 4>{1, 2, 1, 0}
        : std::array<std::int64_t, 4>{1, 3, 3, 1};
    CurvePoint point;
    point.pixel = unitsPerPixel;
    for (std::size_t i = 0; i < degree; ++i)
        point.pixel *= parts;
    for (std::size_t i = 0; i <= degree; ++i) {
        Int128 weight = binomials[i];
        for (std::size_t factor = 0; factor < degree; ++factor)
            weight *= factor < i ? part : parts - part;
        point.x += weight * curve.vertices[i].position.x;
        point.y += weight * curve.vertices[i].position.y;
    }
    return point;
}

/// |Δx| + |Δy| to a pixel, in the point's units.
Int128 distance(const CurvePoint &point, std::int64_t x, std::int64_t y)
{
    return absolute(point.x - x * point.pixel) + absolute(point.y - y * point.pixel);
}

/// Adds the pixels that the definition assigns to a point: those nearer than 1/2 px or, at exactly
/// that distance, the upper and the right one.
void insertPixelsNear(PixelSet &pixels, const CurvePoint &point)
{
    const auto x = std::int64_t(floorDivide(point.x, point.pixel));
    const auto y = std::int64_t(floorDivide(point.y, point.pixel));
    for (std::int64_t column = x; column <= x + 1; ++column) {
        for (std::int64_t row = y; row <= y + 1; ++row) {
            const Int128 twice = 2 * distance(point, column, row);
            const bool isBelow = point.y < row * point.pixel;
            const bool isLeft = point.y == row * point.pixel && point.x < column * point.pixel;
            if (twice < point.pixel || (twice == point.pixel && (isBelow || isLeft)))
                pixels.insert({column, row});
        }
    }
}

/// The pixels of points of a curve at equal parameter steps, including its two ends.
PixelSet sampledPixels(const Shape &curve, std::int64_t parts)
{
    PixelSet pixels;
    for (std::int64_t part = 0; part <= parts; ++part)
        insertPixelsNear(pixels, pointOn(curve, part, parts));
    for (const Vertex &end : {curve.vertices.front(), curve.vertices.back()})
        pixels.insert(
            {floorPixel(end.position.x + halfPixel), floorPixel(end.position.y + halfPixel)});
    return pixels;
}

/// Whether a curve point at equal parameter steps comes within 1/2 px plus 1/64 px of the pixel.
bool comesNear(const Shape &curve, std::int64_t parts, std::int64_t x, std::int64_t y)
{
    for (std::int64_t part = 0; part <= parts; ++part) {
        const CurvePoint point = pointOn(curve, part, parts);
        if (64 * distance(point, x, y) <= 33 * point.pixel)
            return true;
    }
    return false;
}

} // namespace

/// The truth of a Bézier curve: the pixels that the definition assigns to its points, in integers.
class TestCurveTruth : public QObject {
    Q_OBJECT

private slots:
    void theTruthAtAPixelIsTheTruthOfThePicture()
    {
        QRandomGenerator random(29);
        const auto point = [&] {
            return LatticePoint{random.bounded(-4000, 4000), random.bounded(-4000, 4000)};
        };
        for (int round = 0; round < 24; ++round) {
            const std::vector<Shape> shapes
                = {lineAtUnits(point(), point()),
                   ellipseAtUnits(point(), random.bounded(1, 3000), random.bounded(1, 3000)),
                   ellipseAtUnits(point(), 2000, 2000, ShapeFill::EvenOdd),
                   bezierAt({point(), point(), point()}),
                   bezierAt({point(), point(), point(), point()})};
            const FrameSpec frame = frameOf(32, 32, -16, -16);
            for (const Shape &shape : shapes) {
                const CasePicture truth = truthOf(shape, frame);
                for (std::int64_t y = -16; y < 16; ++y) {
                    for (std::int64_t x = -16; x < 16; ++x)
                        QVERIFY2(oracle::covers(shape, FrameOrigin::BottomLeft, x, y)
                                     == truth.isWritten(x, y),
                                 qPrintable(u"seed 29, "_s + nameOf(shape)));
                }
            }
        }
    }

    void theTruthIsThePixelsThatDensePointsComeNearTo_data()
    {
        QTest::addColumn<Lattice>("step"); // of the control points; coarse steps make ties
        QTest::newRow("lattice") << Lattice(1);
        QTest::newRow("half pixels") << halfPixel;
        QTest::newRow("whole pixels") << unitsPerPixel;
    }
    void theTruthIsThePixelsThatDensePointsComeNearTo()
    {
        QFETCH(Lattice, step);
        QRandomGenerator random(53);
        constexpr std::int64_t parts = 3 * 4096; // thirds are exact points, too
        for (int round = 0; round < 12; ++round) {
            const Shape curve = randomCurve(random, step);
            const CasePicture picture = truthOf(curve, frameOf(64, 64, -2, -2));
            const PixelSet truth = pixelsOf(picture);
            const PixelSet sampled = sampledPixels(curve, parts);
            const QByteArray name = qPrintable(u"seed 53, "_s + nameOf(curve));
            QVERIFY2(std::ranges::includes(truth, sampled), name.constData());
            for (const auto &[x, y] : truth)
                QVERIFY2(sampled.contains({x, y}) || comesNear(curve, parts, x, y),
                         name.constData());
            QVERIFY2(isConnected(picture), name.constData());
        }
    }

    void aCurveThatTouchesADiamondKeepsToItsOwner_data()
    {
        QTest::addColumn<Shape>("curve");
        QTest::addColumn<QString>("picture");
        const auto add
            = [](const char *name, const std::vector<LatticePoint> &controls, const char *picture) {
                  QTest::newRow(name) << bezierAt(controls) << QString(picture);
              };
        // Between two rows and between two columns: the upper and the right pixels.
        add("along y = 1/2", {{0, 128}, {256, 128}, {512, 128}}, "....\n###.\n....\n....\n");
        add("along x = 1/2", {{128, 0}, {128, 256}, {128, 512}}, ".#..\n.#..\n.#..\n....\n");
        // Through left corners, at irrational parameters.
        add("down along x = 1/2", {{128, 512}, {128, 320}, {128, 0}}, ".#..\n.#..\n.#..\n....\n");
        // Its lowest point is the centre of (1, 1).
        add("touches y = 1 from above", {{0, 512}, {256, 0}, {512, 512}},
            "#.#.\n.#..\n....\n....\n");
        // Its highest point is the lower corner of (1, 1), which owns it, and the upper one of (1,
        // 0), which does not.
        add("touches y = 1/2 from below", {{0, -128}, {256, 384}, {512, -128}},
            "....\n.#..\n#.#.\n....\n");
        // Its highest point is the lower corner of (1, 1), at t = 1/3.
        add("touches y = 1/2 at a third", {{0, 32}, {384, 320}, {768, -256}},
            "....\n.#..\n#.#.\n...#\n");
        // Its lowest point is that corner.
        add("touches y = 1/2 from above", {{0, 384}, {256, -128}, {512, 384}},
            "#.#.\n###.\n....\n....\n");
        add("a point", {{200, 200}, {200, 200}, {200, 200}}, "....\n.#..\n....\n....\n");
    }
    void aCurveThatTouchesADiamondKeepsToItsOwner()
    {
        QFETCH(Shape, curve);
        QFETCH(QString, picture);
        const FrameSpec frame = frameOf(4, 4, 0, -1);
        QCOMPARE(textOf(truthOf(curve, frame)), picture);
        QCOMPARE(textOf(pictureBy(u"bezier-subdivision", curve, frame)), picture);
        QVERIFY(
            std::ranges::includes(pixelsOf(truthOf(curve, frame)), sampledPixels(curve, 3 * 1024)));
    }

    void straightCurvesAreTheirLines()
    {
        QRandomGenerator random(59);
        const FrameSpec frame = frameOf(34, 34, -1, -1);
        for (int round = 0; round < 100; ++round) {
            const std::int64_t x0 = random.bounded(32), y0 = random.bounded(32);
            const std::int64_t x1 = random.bounded(32), y1 = random.bounded(32);
            const LatticePoint middle = {(x0 + x1) * halfPixel, (y0 + y1) * halfPixel};
            const Shape curve = bezierAt({latticePixel(x0, y0), middle, latticePixel(x1, y1)});
            QVERIFY2(textOf(truthOf(curve, frame))
                         == textOf(truthOf(lineAt(x0, y0, x1, y1), frame)),
                     qPrintable(u"seed 59, "_s + nameOf(curve)));
        }
    }
};

PIXELPLUMB_TEST(TestCurveTruth)

} // namespace tst_curvetruth

#include "tst_curvetruth.moc"
