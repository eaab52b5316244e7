// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/programs/tablefolder.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <cmath>
#include <set>
#include <utility>

namespace tst_subdivision {

using namespace pixelplumb;

namespace {

/// The point at a parameter, in px: precise enough to tell which pixel it rounds to, except at
/// borders.
std::array<double, 2> pointAt(const Shape &curve, double parameter)
{
    std::vector<std::array<double, 2>> points;
    for (const Vertex &vertex : curve.vertices)
        points.push_back(
            {double(vertex.position.x) / unitsPerPixel, double(vertex.position.y) / unitsPerPixel});
    for (; points.size() > 1; points.pop_back()) {
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            for (std::size_t axis = 0; axis < 2; ++axis)
                points[i][axis] += parameter * (points[i + 1][axis] - points[i][axis]);
        }
    }
    return points.front();
}

/// The pixels to which points of the curve round.
std::set<std::pair<int, int>> roundedPixels(const Shape &curve)
{
    constexpr int samples = 20'000;
    std::set<std::pair<int, int>> pixels;
    for (int i = 0; i <= samples; ++i) {
        const auto [x, y] = pointAt(curve, double(i) / samples);
        pixels.insert({int(std::floor(x + 0.5)), int(std::floor(y + 0.5))});
    }
    return pixels;
}

/// Why the kernel's picture is not the truth; empty if it is.
QString departureOf(const Shape &curve, const FrameSpec &frame)
{
    const QString parts
        = departure(pictureBy(u"bezier-subdivision", curve, frame), truthOf(curve, frame));
    return parts.isEmpty() ? parts : nameOf(curve) + u' ' + parts;
}

} // namespace

/// Bézier curves by subdivision: what they draw is the truth.
class TestSubdivision : public QObject {
    Q_OBJECT

private slots:
    void subdivisionIsTheTruth_data()
    {
        QTest::addColumn<Lattice>("step"); // of the control points; coarse steps make ties
        QTest::newRow("lattice") << Lattice(1);
        QTest::newRow("sixteenths") << Lattice(16);
        QTest::newRow("half pixels") << halfPixel;
        QTest::newRow("whole pixels") << unitsPerPixel;
    }
    void subdivisionIsTheTruth()
    {
        QFETCH(Lattice, step);
        QRandomGenerator random(41);
        const FrameSpec frame = frameOf(64, 64, -2, -2);
        for (int round = 0; round < fewerIfSanitized(60); ++round) {
            const Shape curve = randomCurve(random, step);
            QVERIFY2(departureOf(curve, frame).isEmpty(), qPrintable(departureOf(curve, frame)));
        }
    }

    void subdivisionIsTheTruthOnSmallCurvesOfQuarters()
    {
        const FrameSpec frame = frameOf(4, 4, -1, -1);
        // Ends and turning points always lie on borders and corners.
        for (int index = 0; index < 9 * 9 * 9 * 9 * 9; index += isSanitized ? 233 : 29) {
            int rest = index;
            const auto next = [&] { return Lattice(std::exchange(rest, rest / 9) % 9) * 64; };
            const LatticePoint middle = {next(), next()};
            const LatticePoint last = {next(), next()};
            const Shape curve = bezierAt({{next(), 128}, middle, last});
            QVERIFY2(departureOf(curve, frame).isEmpty(), qPrintable(departureOf(curve, frame)));
        }
    }

    void theTruthIsThinnerThanAllThatAParameterRoundsTo()
    {
        QRandomGenerator random(43);
        const FrameSpec frame = frameOf(64, 64, -2, -2);
        std::size_t rounded = 0;
        std::int64_t thin = 0;
        for (int round = 0; round < fewerIfSanitized(40); ++round) {
            const Shape curve = randomCurve(random, unitsPerPixel);
            const CasePicture truth = truthOf(curve, frame);
            QVERIFY2(isConnected(truth), qPrintable(nameOf(curve)));
            rounded += roundedPixels(curve).size();
            thin += truth.pixelCount();
        }
        // As with lines, 3/10 are saved: see resources/misprints.md.
        const double share = double(thin) / double(rounded);
        QVERIFY2(share > 0.65 && share < 0.75, qPrintable(QString::number(share)));
    }

    void aHugeCurveIsDrawnTrueWhereItPassesTheFrame()
    {
        QRandomGenerator random(43);
        const FrameSpec frame = frameOf(48, 48, -24, -24);
        const auto far = [&] { return Lattice(random.bounded(-90000, 90000)) * unitsPerPixel; };
        for (int round = 0; round < fewerIfSanitized(40); ++round) {
            const LatticePoint a = {far(), far()}, b = {far(), far()};
            // Through (0, 0) at t = ½.
            const Shape curve = bezierAt({a, b, {-a.x - 2 * b.x, -a.y - 2 * b.y}});
            const CasePicture truth = truthOf(curve, frame);
            QVERIFY(truth.isWritten(0, 0));
            const QString parts = departure(pictureBy(u"bezier-subdivision", curve, frame), truth);
            QVERIFY2(parts.isEmpty(), qPrintable(u"seed 43, "_s + nameOf(curve) + parts));
        }
    }

    /// The curve is halved 55 times, more often than a double has bits.
    void theEndsOfADeepPieceAreToldApartInFiles()
    {
        const Shape curve = bezierAt({{1664, 128}, {1280, -256}, {2048, 896}, {512, 1408}});
        const auto traced = traceScene(sceneOf(curve, "bezier-subdivision", frameOf(11, 10)));
        TraceExportOptions options;
        options.level = TraceLevel::Column;
        options.format = TableFormat::Csv;
        options.columns
            = {u"depth"_s, u"t_from_exact"_s, u"t_to_exact"_s, u"x_0_exact"_s, u"y_3_exact"_s};
        const QByteArray text = exported(*traced, options);
        QVERIFY(!text.isEmpty());
        int deepest = 0;
        const QList<QByteArray> lines = text.trimmed().split('\n');
        for (const QByteArray &line : lines.sliced(1)) {
            const QList<QByteArray> cells = line.trimmed().split(',');
            QCOMPARE(cells.size(), qsizetype(5));
            if (cells[1].isEmpty() || cells[2].isEmpty())
                continue; // of more than 120 bits
            deepest = std::max(deepest, cells[0].toInt());
            QVERIFY2(cells[1] != cells[2], line.constData());
        }
        QVERIFY(deepest > 53);
    }

    void hugeCurvesEndTheirSubdivision()
    {
        const Lattice far = largestCoordinate;
        const Shape curve = bezierAt({{-far, -far}, {far, -far}, {-far, far}, {far, far}});
        const FrameSpec frame = frameOf(64, 64, -32, -32);
        const CasePicture drawn = pictureBy(u"bezier-subdivision", curve, frame);
        const CasePicture truth = truthOf(curve, frame);
        QVERIFY(truth.isWritten(0, 0));
        QVERIFY2(departure(drawn, truth).isEmpty(), qPrintable(departure(drawn, truth)));
    }
};

PIXELPLUMB_TEST(TestSubdivision)

} // namespace tst_subdivision

#include "tst_subdivision.moc"
