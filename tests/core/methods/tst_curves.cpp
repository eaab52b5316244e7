// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QRandomGenerator>
#include <QTest>

#include <cmath>
#include <complex>

namespace tst_curves {

using namespace pixelplumb;

namespace {

/// A path of pieces with three or four control points, in lattice units.
Shape pathOf(const std::vector<std::vector<LatticePoint>> &pieces, ShapeFill fill)
{
    Shape path = bezierAt(pieces.front());
    path.fill = fill;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        path.laterContours.push_back(path.vertices.size());
        for (const Vertex &vertex : bezierAt(pieces[i]).vertices)
            path.vertices.push_back(vertex);
    }
    return path;
}

/// A closed path of one to three pieces, most of which begin where the previous one ended.
Shape randomPath(QRandomGenerator &random, ShapeFill fill)
{
    const auto point = [&] {
        return LatticePoint{random.bounded(40 * 256), random.bounded(40 * 256)};
    };
    std::vector<std::vector<LatticePoint>> pieces;
    const int count = random.bounded(1, 4);
    for (int i = 0; i < count; ++i) {
        const bool joins = i > 0 && random.bounded(4) > 0;
        std::vector<LatticePoint> piece = {joins ? pieces.back().back() : point()};
        for (int control = random.bounded(2, 4); control > 0; --control)
            piece.push_back(point());
        pieces.push_back(piece);
    }
    return pathOf(pieces, fill);
}

/// The path as very many points: an independent picture of it in floating point.
std::vector<std::complex<double>> pointsAlong(const Shape &path)
{
    std::vector<std::complex<double>> points;
    std::size_t first = 0;
    for (std::size_t piece = 0; piece <= path.laterContours.size(); ++piece) {
        const std::size_t end
            = piece < path.laterContours.size() ? path.laterContours[piece] : path.vertices.size();
        const std::size_t degree = end - first - 1;
        for (int step = 0; step <= 2000; ++step) {
            const double t = step / 2000.0;
            std::complex<double> sum = 0;
            for (std::size_t i = 0; i <= degree; ++i) {
                const double choices = i == 0 || i == degree ? 1.0 : double(degree);
                const LatticePoint &control = path.vertices[first + i].position;
                sum += choices * std::pow(t, double(i)) * std::pow(1 - t, double(degree - i))
                    * std::complex<double>(double(control.x) / 256, double(control.y) / 256);
            }
            points.push_back(sum);
        }
        first = end;
    }
    return points;
}

/// A position relative to a closed chain of points: how often the chain winds around it, by the
/// angles under which its steps are seen, and how near it comes.
struct Surroundings {
    int winding = 0;
    double distance = 1e9;

    Surroundings(const std::vector<std::complex<double>> &points, std::complex<double> place)
    {
        double turned = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto from = points[i] - place;
            const auto to = points[(i + 1) % points.size()] - place;
            turned += std::arg(to / from);
            const auto step = to - from;
            const double along = std::norm(step) > 0
                ? std::clamp(-(from * std::conj(step)).real() / std::norm(step), 0.0, 1.0)
                : 0.0;
            distance = std::min(distance, std::abs(from + along * step));
        }
        winding = int(std::lround(turned / (2 * M_PI)));
    }
};

} // namespace

/// The methods that draw Bézier curves against the truth, and what holds for all methods of curved
/// shapes.
class TestCurves : public QObject {
    Q_OBJECT

private slots:
    void aStraightCurveIsItsLine()
    {
        const Shape curve
            = bezierAt({latticePixel(2, 3), latticePixel(12, 3), latticePixel(22, 3)});
        const FrameSpec frame = frameOf(30, 8);
        const CasePicture line = truthOf(lineAt(2, 3, 22, 3), frame);
        QCOMPARE(textOf(truthOf(curve, frame)), textOf(line));
        QCOMPARE(textOf(pictureBy(u"bezier-subdivision", curve, frame)), textOf(line));
    }

    void aFilledPathsTruthIsWhatItWindsAround()
    {
        QRandomGenerator random(31);
        int inside = 0;
        for (int round = 0; round < 60; ++round) {
            const Shape path
                = randomPath(random, round % 2 == 0 ? ShapeFill::EvenOdd : ShapeFill::NonZero);
            const auto points = pointsAlong(path);
            const CasePicture truth = truthOf(path, frameOf(42, 42, -1, -1));
            const CasePicture drawn = pictureBy(u"bezier-fill", path, frameOf(42, 42, -1, -1));
            for (int sample = 0; sample < 40; ++sample) {
                const std::int64_t x = random.bounded(40), y = random.bounded(40);
                const Surroundings around(points, {double(x), double(y)});
                if (around.distance < 0.001)
                    continue; // too near for the sampled points
                const bool isInside = path.fill == ShapeFill::NonZero ? around.winding != 0
                                                                      : around.winding % 2 != 0;
                const bool isCovered = truth.isWritten(x, y);
                QVERIFY2(isCovered == isInside,
                         qPrintable(nameOf(path) + u" at %1, %2"_s.arg(x).arg(y)));
                // Chords deviate from the curve by up to 1/32 px, their ends from the lattice by up
                // to half a step.
                QVERIFY2(around.distance < 1.0 / 32 + 0.003 ? true
                                                            : drawn.isWritten(x, y) == isCovered,
                         qPrintable(nameOf(path) + u" by chords at %1, %2"_s.arg(x).arg(y)));
                inside += isInside ? 1 : 0;
            }
        }
        QVERIFY(inside > 200);
    }

    void aPathOfStraightPiecesIsItsPolygon()
    {
        // Control points halfway along straight pieces; samples lie on edges and vertices.
        const auto path = [](ShapeFill fill) {
            return pathOf(
                {{{512, 512}, {2048, 512}, {3584, 512}}, {{3584, 512}, {2048, 2048}, {512, 3584}}},
                fill);
        };
        for (const FrameOrigin origin : {FrameOrigin::BottomLeft, FrameOrigin::TopLeft}) {
            FrameSpec frame = frameOf(16, 16);
            frame.origin = origin;
            Shape polygon = path(ShapeFill::EvenOdd);
            polygon.kind = PrimitiveKind::Polygon;
            polygon.laterContours.clear();
            const QString expected = textOf(truthOf(polygon, frame));
            QVERIFY(expected.contains(u'#'));
            for (const ShapeFill fill : {ShapeFill::EvenOdd, ShapeFill::NonZero}) {
                QCOMPARE(textOf(truthOf(path(fill), frame)), expected);
                QCOMPARE(textOf(pictureBy(u"bezier-fill", path(fill), frame)), expected);
            }
        }
    }

    void anOpenPathIsClosedByAnEdge()
    {
        // An arch with unconnected ends: an edge from the last to the first point closes it below.
        const Shape arch = pathOf({{latticePixel(1, 2), latticePixel(6, 12), latticePixel(11, 2)}},
                                  ShapeFill::EvenOdd);
        QCOMPARE(textOf(truthOf(arch, frameOf(13, 9))),
                 u".............\n"
                 ".............\n"
                 "....#####....\n"
                 "...#######...\n"
                 "...#######...\n"
                 "..#########..\n"
                 ".............\n"
                 ".............\n"
                 ".............\n"_s);
    }
};

PIXELPLUMB_TEST(TestCurves)

} // namespace tst_curves

#include "tst_curves.moc"
