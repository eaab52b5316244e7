// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/fastscan.h"
#include "core/scan/walks/columndrawing.h"
#include "tests/support/guardedframe.h"
#include "tests/support/sanitized.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <rapidcheck.h>

namespace tst_fastpath {

using namespace pixelplumb;

namespace {

/// A class of sizes: how far apart corners are, and on which lattice.
struct Family {
    Lattice width; ///< corners within ± this of a common point, lattice units
    Lattice height;
    Lattice grid; ///< all coordinates are multiples of this
    std::int32_t largestSide; ///< of the window, px
};

Triangle withColours(const std::array<Lattice, 8> &c, const std::array<std::uint32_t, 3> &colours,
                     bool flat)
{
    Triangle triangle = triangleAtUnits({c[0] + c[2], c[1] + c[3]}, {c[0] + c[4], c[1] + c[5]},
                                        {c[0] + c[6], c[1] + c[7]});
    for (std::size_t i = 0; i < 3; ++i)
        triangle.vertices[i].colour = unpacked(colours[flat ? 0 : i]);
    return triangle;
}

rc::Gen<Lattice> coordinatesWithin(Lattice extent, Lattice grid)
{
    return rc::gen::map(rc::gen::inRange<Lattice>(-extent / grid, extent / grid + 1),
                        [grid](Lattice n) { return n * grid; });
}

/// Levels are extreme more often than by chance: there clamping and wrapping would show.
rc::Gen<std::uint32_t> colours()
{
    const auto level = rc::gen::weightedOneOf<std::uint32_t>(
        {{2, rc::gen::element(0u, 255u)}, {3, rc::gen::inRange(0u, 256u)}});
    return rc::gen::apply(
        [](std::uint32_t r, std::uint32_t g, std::uint32_t b) { return r << 16 | g << 8 | b; },
        level, level, level);
}

rc::Gen<Triangle> triangles(const Family &family, const WindowSpec &window)
{
    // The common point lies in the window or a little outside, or anywhere from which a large
    // triangle's boundary can cross the window.
    const auto around = [&](Lattice first, Lattice side, Lattice extent) {
        const Lattice middle = (first + side / 2) * unitsPerPixel / family.grid * family.grid;
        const Lattice reach = std::max(side * unitsPerPixel * 3 / 4, extent * 7 / 8);
        return rc::gen::map(coordinatesWithin(reach, family.grid),
                            [middle](Lattice offset) { return middle + offset; });
    };
    const auto x = coordinatesWithin(family.width, family.grid);
    const auto y = coordinatesWithin(family.height, family.grid);
    const auto coordinates = rc::gen::apply(
        [](Lattice a, Lattice b, Lattice c, Lattice d, Lattice e, Lattice f, Lattice g, Lattice h) {
            return std::array<Lattice, 8>{a, b, c, d, e, f, g, h};
        },
        around(window.firstColumn, window.width, family.width),
        around(window.firstRow, window.height, family.height), x, y, x, y, x, y);
    return rc::gen::apply(withColours, coordinates,
                          rc::gen::container<std::array<std::uint32_t, 3>>(colours()),
                          rc::gen::weightedElement<bool>({{3, false}, {1, true}}));
}

rc::Gen<WindowSpec> windows(std::int32_t largestSide)
{
    return rc::gen::build<WindowSpec>(
        rc::gen::set(&WindowSpec::width, rc::gen::inRange(1, largestSide + 1)),
        rc::gen::set(&WindowSpec::height, rc::gen::inRange(1, largestSide + 1)),
        rc::gen::set(&WindowSpec::firstColumn, rc::gen::inRange(-3000, 3000)),
        rc::gen::set(&WindowSpec::firstRow, rc::gen::inRange(-3000, 3000)),
        rc::gen::set(&WindowSpec::padding, rc::gen::inRange(0, 20)),
        rc::gen::set(&WindowSpec::order,
                     rc::gen::element(RowOrder::Ascending, RowOrder::Descending)));
}

rc::Gen<ScanSettings> settingsIn(Arithmetic arithmetic)
{
    return rc::gen::build<ScanSettings>(
        rc::gen::set(&ScanSettings::arithmetic, rc::gen::just(arithmetic)),
        rc::gen::set(&ScanSettings::fillRule,
                     rc::gen::element(FillRule::Closed, FillRule::HalfOpenColumn, FillRule::Open)),
        rc::gen::set(&ScanSettings::rounding,
                     rc::gen::element(ByteRounding::Nearest, ByteRounding::Truncate)));
}

/// Compares both pictures of a scene; the second is drawn by each of the machine's instruction sets
/// in turn.
void expectSamePicture(const std::vector<Triangle> &scene, const ScanSettings &settings,
                       const WindowSpec &window, int threads = 1)
{
    GuardedFrame plain(window);
    drawColumns(scene, settings, plain.view());
    for (const InstructionSet set : supportedInstructionSets()) {
        GuardedFrame fast(window);
        drawFast(scene, settings, fast.view(), {threads, set});
        if (!(fast == plain)) {
            std::ostringstream what;
            for (const Triangle &triangle : scene)
                what << triangle << '\n';
            RC_LOG() << what.str() << window << "\nrule " << nameOf(settings.fillRule)
                     << ", rounding " << nameOf(settings.rounding) << ", " << nameOf(set)
                     << ": first different pixel " << firstDifference(fast, plain) << '\n';
            RC_FAIL("the pictures differ");
        }
    }
}

constexpr Lattice px = unitsPerPixel;

void addFamilies()
{
    QTest::addColumn<Family>("family");
    const auto add = [](const char *name, Lattice width, Lattice height, Lattice grid, int side) {
        QTest::newRow(name) << Family{width, height, grid, side};
    };
    add("points and segments", px, px, px, 40);
    add("below a pixel", px / 2, px / 2, 1, 40);
    add("4 px, whole pixels", 2 * px, 2 * px, px, 70);
    add("4 px, 1/256 px", 2 * px, 2 * px, 1, 70);
    add("50 px, whole pixels", 7 * px, 7 * px, px, 90);
    add("50 px, 1/256 px", 7 * px, 7 * px, 1, 90);
    add("blocks of 63 rows, 1/256 px", 4 * px, 31 * px, 1, 90);
    add("1000 px, whole pixels", 35 * px, 35 * px, px, 150);
    add("1000 px, 1/16 px", 35 * px, 35 * px, 16, 150);
    add("1000 px, 1/256 px", 35 * px, 35 * px, 1, 150);
    add("tall slivers, whole pixels", 3 * px, 300 * px, px, 200);
    add("tall slivers, 1/256 px", 3 * px, 300 * px, 1, 200);
    add("wide slivers, whole pixels", 300 * px, 2 * px, px, 200);
    add("wide slivers, 1/256 px", 300 * px, 2 * px, 1, 200);
    add("half the frame, whole pixels", 900 * px, 900 * px, px, 700);
    add("half the frame, 1/256 px", 900 * px, 900 * px, 1, 700);
    add("3000 px, whole pixels", 3000 * px, 3000 * px, px, 300);
    add("10000 px, 1/256 px", 10000 * px, 10000 * px, 1, 100);
    add("2^15 px", 20000 * px, 20000 * px, 1, 60);
    add("beyond 2^15 px", 200000 * px, 200000 * px, 1, 40);
}

/// Small triangles all over a frame: enough work to start threads.
std::vector<Triangle> crowd(std::size_t count, std::int32_t side, unsigned seed)
{
    std::vector<Triangle> scene;
    unsigned state = seed;
    const auto random = [&](unsigned below) {
        state = state * 1664525u + 1013904223u;
        return std::int64_t(state >> 8) % std::int64_t(below);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t x = random(unsigned(side));
        const std::int64_t y = random(unsigned(side));
        const unsigned size = i % 64 == 0 ? unsigned(side) : 12;
        Triangle triangle
            = triangleAt(x, y, x + random(size), y + random(size), x - random(size), y + 3);
        for (Vertex &vertex : triangle.vertices)
            vertex.colour = unpacked(QRgb(random(1u << 24)));
        scene.push_back(triangle);
    }
    return scene;
}

} // namespace

/// The fast path against the plain kernel: the same bytes, and none changed outside the window.
class TestFastPath : public QObject {
    Q_OBJECT

private slots:
    void drawsThePlainKernelsPicture_data() { addFamilies(); }
    void drawsThePlainKernelsPicture()
    {
        QFETCH(Family, family);
        const bool same = rc::check(QTest::currentDataTag(), [&] {
            const WindowSpec window = *windows(family.largestSide);
            const ScanSettings settings = *settingsIn(Arithmetic::Exact);
            expectSamePicture(*rc::gen::container<std::vector<Triangle>>(
                                  *rc::gen::inRange<std::size_t>(1, 5), triangles(family, window)),
                              settings, window);
        });
        QVERIFY(same);
    }

    void drawsThePlainKernelsFloat32Picture_data() { addFamilies(); }
    void drawsThePlainKernelsFloat32Picture()
    {
        QFETCH(Family, family);
        const bool same = rc::check(QTest::currentDataTag(), [&] {
            const WindowSpec window = *windows(family.largestSide);
            const ScanSettings settings = *settingsIn(Arithmetic::Float32);
            expectSamePicture({*triangles(family, window)}, settings, window);
        });
        QVERIFY(same);
    }

    void fallsBackOnThePlainKernelForOtherArithmetics()
    {
        const bool same = rc::check("fixed point and float64", [] {
            const WindowSpec window = *windows(60);
            const ScanSettings settings = *settingsIn(
                *rc::gen::element(Arithmetic::Float64, Arithmetic::Fixed16, Arithmetic::Fixed32));
            expectSamePicture({*triangles({20 * px, 20 * px, 16, 60}, window)}, settings, window);
        });
        QVERIFY(same);
    }

    void drawsManyTrianglesInTheirOrder()
    {
        const bool same = rc::check("several batches over each other", [] {
            const WindowSpec window = *windows(60);
            const ScanSettings settings = *settingsIn(Arithmetic::Exact);
            const auto mixed = rc::gen::oneOf(triangles({2 * px, 2 * px, px, 60}, window),
                                              triangles({20 * px, 20 * px, px, 60}, window),
                                              triangles({60 * px, 60 * px, 1, 60}, window));
            expectSamePicture(*rc::gen::container<std::vector<Triangle>>(100, mixed), settings,
                              window);
        });
        QVERIFY(same);
    }

    void drawsBatchesOfSmallTrianglesOnWholePixels()
    {
        const bool same = rc::check("of up to 63 px, within a window and across its border", [] {
            const WindowSpec window = *windows(90);
            const ScanSettings settings = *settingsIn(Arithmetic::Exact);
            const Lattice side = *rc::gen::element<Lattice>(3, 8, 15, 31);
            expectSamePicture(*rc::gen::container<std::vector<Triangle>>(
                                  40, triangles({side * px, side * px, px, 90}, window)),
                              settings, window);
        });
        QVERIFY(same);
    }

    void doesNotDependOnTheNumberOfThreads_data()
    {
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::addColumn<int>("threads");
        for (const Arithmetic arithmetic : allArithmetics) {
            // The other arithmetics use one thread, however many are requested.
            for (int threads = arithmetic == Arithmetic::Exact ? 1 : 8; threads <= 8; ++threads)
                QTest::addRow("%s, %d threads", nameOf(arithmetic).data(), threads)
                    << arithmetic << threads;
        }
    }
    void doesNotDependOnTheNumberOfThreads()
    {
        QFETCH(Arithmetic, arithmetic);
        QFETCH(int, threads);
        // The other arithmetics use one thread, with any number of triangles.
        const int triangles = arithmetic == Arithmetic::Exact ? 20'000 : fewerIfSanitized(20'000);
        const std::vector<Triangle> scene = crowd(std::size_t(triangles), 301, 7);
        const ScanSettings settings{arithmetic, FillRule::Closed, ByteRounding::Nearest};
        for (const RowOrder order : {RowOrder::Ascending, RowOrder::Descending}) {
            const WindowSpec window{297, 283, 3, 5, 7, order};
            GuardedFrame plain(window);
            drawColumns(scene, settings, plain.view());
            GuardedFrame fast(window);
            const FastReport report
                = drawFast(scene, settings, fast.view(), {threads, std::nullopt});
            QCOMPARE(report.threads, arithmetic == Arithmetic::Exact ? threads : 1);
            QVERIFY(fast == plain);
        }
    }

    void aFrameThatNoCacheHoldsIsDrawnInBandsByOneThread()
    {
        const std::vector<Triangle> scene = crowd(2'000, 2101, 11);
        const WindowSpec window{2103, 2057, 3, 5, 7, RowOrder::Descending};
        GuardedFrame plain(window);
        drawColumns(scene, {}, plain.view());
        GuardedFrame fast(window);
        const FastReport report = drawFast(scene, {}, fast.view(), {1, std::nullopt});
        QCOMPARE(report.threads, 1);
        QVERIFY(report.bands > 1);
        QVERIFY(fast == plain);
    }
};

PIXELPLUMB_TEST(TestFastPath)

} // namespace tst_fastpath

#include "tst_fastpath.moc"
