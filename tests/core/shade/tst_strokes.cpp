// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seededrandom.h"
#include "core/oracle/truepicture.h"
#include "core/shade/strokes/strokestrip.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"
#include "tests/support/tracereplay.h"

#include <QTest>

#include <cmath>

namespace tst_strokes {

using namespace pixelplumb;

namespace {

constexpr std::array kindsOfAntialiasing
    = {Antialiasing::None, Antialiasing::Area, Antialiasing::Samples4, Antialiasing::Samples16};

Scene sceneOf(const std::vector<Shape> &shapes, const FrameSpec &frame, Antialiasing antialiasing)
{
    Scene scene;
    scene.frame = frame;
    scene.method = "stroke-coverage";
    scene.shapes = shapes;
    scene.appearance.antialiasing = antialiasing;
    return scene;
}

/// The red levels, row by row from the highest.
QString levelsText(const Scene &scene)
{
    const FrameBuffer frame(scene.frame);
    drawScene(scene, frame);
    QString text;
    for (std::int64_t y = frame.view().endRow() - 1; y >= frame.view().firstRow; --y) {
        for (std::int64_t x = frame.view().firstColumn; x < frame.view().endColumn(); ++x)
            text += u"%1 "_s.arg(qRed(*frame.view().at(x, y)), 3);
        text.back() = u'\n';
    }
    return text;
}

Shape whiteLine(const LatticePoint &a, const LatticePoint &b)
{
    Shape line;
    line.kind = PrimitiveKind::Line;
    line.vertices = {{a, {{255, 255, 255}}}, {b, {{255, 255, 255}}}};
    return line;
}

/// Shapes of every kind, some without length, on lattice points and between.
class RandomStrokes {
public:
    explicit RandomStrokes(std::uint64_t seed)
        : m_random(seed)
    {
        m_frame.width = std::int32_t(m_random.between(1, 24));
        m_frame.height = std::int32_t(m_random.between(1, 24));
        m_frame.background = m_random.colour();
        const std::int64_t where = m_random.between(0, 7);
        if (where == 0) { // as far away as a frame can be
            m_frame.firstColumn = std::int32_t(largestPixel - 30);
            m_frame.firstRow = std::int32_t(-largestPixel + 3);
        } else {
            m_frame.firstColumn = std::int32_t(m_random.between(-50, 50));
            m_frame.firstRow = std::int32_t(m_random.between(-50, 50));
        }
        m_frame.origin = m_random.coin() ? FrameOrigin::BottomLeft : FrameOrigin::TopLeft;
        m_reach = where == 1 ? largestCoordinate : unitsPerPixel * m_random.between(1, 60);
        for (std::int64_t i = m_random.between(1, 3); i > 0; --i)
            m_shapes.push_back(shape());
    }

    const FrameSpec &frame() const { return m_frame; }
    const std::vector<Shape> &shapes() const { return m_shapes; }

private:
    LatticePoint point()
    {
        constexpr std::array<Lattice, 3> steps = {1, halfPixel, unitsPerPixel};
        const Lattice step = steps[std::size_t(m_random.between(0, 2))];
        const auto coordinate = [&](std::int32_t first) {
            const Lattice from = m_random.between(-m_reach / step, m_reach / step) * step;
            return std::clamp<Lattice>(first * unitsPerPixel + from, -largestCoordinate,
                                       largestCoordinate);
        };
        return {coordinate(m_frame.firstColumn), coordinate(m_frame.firstRow)};
    }
    Vertex vertex() { return {point(), m_random.colour()}; }

    Shape shape()
    {
        Shape shape;
        const std::int64_t kind = m_random.between(0, 3);
        shape.kind = kind <= 1 ? PrimitiveKind::Line
            : kind == 2        ? PrimitiveKind::Ellipse
                               : PrimitiveKind::Bezier;
        const std::int64_t count = kind == 3 ? m_random.between(3, 4) : 2;
        for (std::int64_t i = 0; i < count; ++i)
            shape.vertices.push_back(vertex());
        if (shape.kind == PrimitiveKind::Ellipse) {
            const LatticePoint centre = shape.vertices[0].position;
            LatticePoint &corner = shape.vertices[1].position;
            corner = {std::max(corner.x, centre.x), std::max(corner.y, centre.y)};
        }
        if (m_random.between(0, 9) == 0)
            shape.vertices[1] = shape.vertices[0];
        return shape;
    }

    SeededRandom m_random;
    FrameSpec m_frame;
    Lattice m_reach = 0;
    std::vector<Shape> m_shapes;
};

/// The sum of the exact areas that a stroke covers of the frame's pixels.
double sumOfAreas(const Shape &shape, const FrameSpec &frame)
{
    const auto traced = traceScene(sceneOf({shape}, frame, Antialiasing::Area));
    std::size_t column = 0;
    while (traced->trace->numbers().sample[column].id != u"area"_s)
        ++column;
    double sum = 0;
    for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
        for (const SampleRecord &sample : traced->trace->samples(span))
            sum += sample.cells[column].toDouble();
    }
    return sum;
}

} // namespace

/// Lines and curves one pixel wide.
class TestStrokes : public QObject {
    Q_OBJECT

private slots:
    void aLevelLineOnSamplesCoversItsRowAndHalfOfItsEndPixels()
    {
        const Scene scene = sceneOf({whiteLine(latticePixel(1, 1), latticePixel(4, 1))},
                                    frameOf(6, 3), Antialiasing::Area);
        QCOMPARE(levelsText(scene),
                 u"  0   0   0   0   0   0\n"
                 "  0 128 255 255 128   0\n"
                 "  0   0   0   0   0   0\n"_s);
    }

    void aLineBetweenTwoRowsIsHalfInEach()
    {
        const Scene scene
            = sceneOf({whiteLine({-unitsPerPixel, halfPixel}, {9 * unitsPerPixel, halfPixel})},
                      frameOf(2, 3), Antialiasing::Area);
        QCOMPARE(levelsText(scene), u"  0   0\n128 128\n128 128\n"_s);
    }

    /// The sum equals that of four pictures with one sample per pixel, in which the line is shifted
    /// against the sample. Values without a mean (t, and the colour at the centre) are not shown.
    void aPixelOfFourSamplesShowsTheirSum()
    {
        const auto lineMovedBy = [](const LatticePoint &move) {
            Shape line = whiteLine(latticePixel(1, 1), latticePixel(9, 4));
            line.vertices[0].colour = {{250, 10, 0}};
            line.vertices[1].colour = {{10, 200, 90}};
            for (Vertex &vertex : line.vertices)
                vertex.position = {vertex.position.x - move.x, vertex.position.y - move.y};
            return line;
        };
        const FrameSpec frame = frameOf(12, 7);
        constexpr std::array<LatticePoint, 4> samples
            = {{{-32, -96}, {96, -32}, {-96, 32}, {32, 96}}};
        std::vector<std::unique_ptr<FrameBuffer>> pictures;
        for (const LatticePoint &sample : samples) {
            pictures.push_back(std::make_unique<FrameBuffer>(frame));
            drawScene(sceneOf({lineMovedBy(sample)}, frame, Antialiasing::None), *pictures.back());
        }
        const auto traced
            = traceScene(sceneOf({lineMovedBy({0, 0})}, frame, Antialiasing::Samples4));
        const auto &numbers = traced->trace->numbers().sample;
        QVERIFY(std::ranges::none_of(numbers, [](const NumberDescription &number) {
            return number.id == u"t"_s || number.id == u"s_R"_s;
        }));
        std::size_t shown = 0;
        for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
            for (const SampleRecord &sample : traced->trace->samples(span)) {
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    const QString id = u"sum_"_s + channelLetters[channel];
                    const auto column = std::size_t(
                        std::ranges::find(numbers, id, &NumberDescription::id) - numbers.begin());
                    int sum = 0;
                    for (const auto &picture : pictures)
                        sum += unpacked(*picture->view().at(sample.x, sample.y)).channels[channel];
                    QCOMPARE(sample.cells.at(column), Quantity::integer(sum));
                    ++shown;
                }
            }
        }
        QVERIFY(shown > 40);
    }

    void everyPictureIsTheTruth_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 0; seed < fewerIfSanitized(250); ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }
    void everyPictureIsTheTruth()
    {
        QFETCH(int, seed);
        const RandomStrokes strokes{std::uint64_t(seed)};
        for (const Antialiasing antialiasing : kindsOfAntialiasing) {
            const Scene scene = sceneOf(strokes.shapes(), strokes.frame(), antialiasing);
            const FrameBuffer drawn(scene.frame);
            const FrameBuffer truth(scene.frame);
            drawScene(scene, drawn);
            drawTruth(scene, truth);
            QCOMPARE(drawn.copy(), truth.copy());
        }
    }

    void aTraceIsThePictureStepByStep_data() { everyPictureIsTheTruth_data(); }
    void aTraceIsThePictureStepByStep()
    {
        QFETCH(int, seed);
        if (seed % 5 != 0)
            return;
        const RandomStrokes strokes{std::uint64_t(seed)};
        for (const Antialiasing antialiasing : kindsOfAntialiasing) {
            const Scene scene = sceneOf(strokes.shapes(), strokes.frame(), antialiasing);
            const FrameBuffer drawn(scene.frame);
            drawScene(scene, drawn);
            const auto traced = traceScene(scene);
            QCOMPARE(replayed(*traced->trace, scene.frame), drawn.copy());
            QCOMPARE(traced->differences.total(), 0);
        }
    }

    void aLineHasThePixelsOfItsReverse()
    {
        SeededRandom random(3);
        for (int i = 0; i < 100; ++i) {
            const auto anywhere = [&]() -> LatticePoint {
                return {random.between(-1000, 9000), random.between(-1000, 9000)};
            };
            const LatticePoint a = anywhere();
            const LatticePoint b = anywhere();
            const FrameSpec frame = frameOf(32, 32);
            QCOMPARE(levelsText(sceneOf({whiteLine(a, b)}, frame, Antialiasing::Area)),
                     levelsText(sceneOf({whiteLine(b, a)}, frame, Antialiasing::Area)));
        }
    }

    void aLinesAreasSumToItsLengthInEveryDirection()
    {
        for (int degrees = 0; degrees < 360; degrees += 5) {
            const double angle = degrees * std::acos(-1.0) / 180;
            const LatticePoint a = {77, -31};
            const LatticePoint b = {a.x + std::lround(5000 * std::cos(angle)),
                                    a.y + std::lround(5000 * std::sin(angle))};
            const double length = std::hypot(b.x - a.x, b.y - a.y) / double(unitsPerPixel);
            const double sum = sumOfAreas(whiteLine(a, b), frameOf(48, 48, -24, -24));
            // The half width is off by 2^-17 px along each axis.
            QVERIFY2(std::abs(sum / length - 1) < std::exp2(-15.5),
                     qPrintable(u"%1°: %2"_s.arg(degrees).arg(sum / length)));
        }
    }

    void aCirclesAreasSumToItsCircumference()
    {
        for (const std::int64_t radius : {2, 5, 11, 20}) {
            const double sum = sumOfAreas(circleAt(0, 0, radius), frameOf(48, 48, -24, -24));
            const double circumference = 2 * std::acos(-1.0) * double(radius);
            QVERIFY2(std::abs(sum / circumference - 1) < 1e-3,
                     qPrintable(u"%1: %2"_s.arg(radius).arg(sum / circumference)));
        }
    }

    void whatHasNoLengthHasNoPixels()
    {
        const std::vector<Shape> points
            = {whiteLine({300, 300}, {300, 300}), circleAt(3, 3, 0),
               bezierAt({{300, 300}, {300, 300}, {300, 300}, {300, 300}})};
        for (const Antialiasing antialiasing : kindsOfAntialiasing) {
            const auto traced = traceScene(sceneOf(points, frameOf(8, 8), antialiasing));
            QCOMPARE(traced->trace->writtenCount(), std::size_t(0));
            QVERIFY(traced->trace->setUpWords(0).sentence.contains(u"no length"_s));
        }
    }

    void aHalfWidthIsTheNearestToHalfAPixel()
    {
        QCOMPARE(strokeHalfWidth(3, 4), (StrokePoint{-26214, 19661}));
        QCOMPARE(strokeHalfWidth(-7, 0), (StrokePoint{0, -32768}));
        QCOMPARE(strokeHalfWidth(0, 0), StrokePoint{});
        const Int128 large = Int128(1) << 103;
        QCOMPARE(strokeHalfWidth(3 * large, 4 * large), strokeHalfWidth(3, 4));
    }
};

PIXELPLUMB_TEST(TestStrokes)

} // namespace tst_strokes

#include "tst_strokes.moc"
