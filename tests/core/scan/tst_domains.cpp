// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/number/fixedpoint.h"
#include "core/scan/biasarithmetic.h"
#include "tests/support/randomnumbers.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_domains {

using namespace pixelplumb;

namespace {

/// An edge from (xa, ya) to (xa + dx, ya + dy), dx > 0, in units of 1/scale px, and a column in px
/// at which everything asks for y: N/D px with D = dx·scale.
struct Place {
    std::int64_t xa = 0, ya = 0, dx = 1, dy = 0;
    std::int64_t scale = 1;
    std::int64_t column = 0;

    std::int64_t run() const { return column * scale - xa; }
    Int128 numerator() const { return Int128(ya) * dx + Int128(run()) * dy; }
    Int128 denominator() const { return Int128(dx) * scale; }
    QString text() const
    {
        return u"(%1, %2) + (%3, %4), scale %5, column %6"_s.arg(xa)
            .arg(ya)
            .arg(dx)
            .arg(dy)
            .arg(scale)
            .arg(column);
    }
};

/// ⌊y⌋ and ⌈y⌉.
struct Rows {
    std::int64_t floor = 0;
    std::int64_t ceil = 0;
    friend bool operator==(const Rows &, const Rows &) = default;
};

Rows exactRows(const Place &place)
{
    return {std::int64_t(floorDivide(place.numerator(), place.denominator())),
            std::int64_t(ceilDivide(place.numerator(), place.denominator()))};
}

/// y₀ + (x − x₀)·m with β = 1/(2D), each operation rounded.
template <class Float>
Rows rowsByMultiplying(const Place &place)
{
    const auto scale = Float(place.scale);
    const Float slope = Float(place.dy) / Float(place.dx);
    const Float y = Float(place.ya) / scale + Float(place.run()) / scale * slope;
    const Float bias = Float(0.5) / (Float(place.dx) * scale);
    return {std::int64_t(std::floor(y + bias)), std::int64_t(std::ceil(y - bias))};
}

/// Like rowsByMultiplying(), but in the product's own arithmetic, which must not have fallen back
/// on integers.
Rows rowsByProduct(const Place &place)
{
    const Vertex a = {{place.xa, place.ya}, {}};
    const Vertex b = {{place.xa + place.dx, place.ya + place.dy}, {}};
    using A = BiasArithmetic<BiasOrExactNumber>;
    const BiasOrExactNumber y
        = A::edgeOrdinate(a, b, A::runTo(place.column, a), A::edgeSlope(a, b));
    if (y.isExact || place.scale != unitsPerPixel)
        return {1, 0}; // always wrong
    return {y.floor(), y.ceil()};
}

/// Fixed point: y at the edge's first column and the slope are rounded, then the slope is added
/// from column to column. Sums of fixed-point numbers are exact, so n additions equal one product.
/// The bias 1/(2D) itself is not rounded.
template <class Fixed>
Rows rowsByAdding(const Place &place)
{
    const auto rounded = [](Int128 numerator, Int128 denominator) {
        return floorDivide<Int128>(2 * numerator * Fixed::one + denominator, 2 * denominator);
    };
    Place first = place;
    first.column = ceilDivide(place.xa, place.scale);
    const Int128 raw = rounded(first.numerator(), first.denominator())
        + (place.column - first.column) * rounded(place.dy, place.dx);
    const Int128 one = Fixed::one;
    const Int128 twoD = 2 * place.denominator();
    return {std::int64_t(floorDivide<Int128>(raw * twoD + one, one * twoD)),
            std::int64_t(ceilDivide<Int128>(raw * twoD - one, one * twoD))};
}

/// The t with a·t ≡ 1 modulo m; a and m must be coprime.
std::int64_t inverse(std::int64_t a, std::int64_t m)
{
    std::int64_t r0 = m, r1 = ((a % m) + m) % m, t0 = 0, t1 = 1;
    while (r1 != 0) {
        const std::int64_t quotient = r0 / r1;
        r0 = std::exchange(r1, r0 - quotient * r1);
        t0 = std::exchange(t1, t0 - quotient * t1);
    }
    return ((t0 % m) + m) % m;
}

std::int64_t modulo(Int128 value, std::int64_t m) { return std::int64_t(((value % m) + m) % m); }

/// The range from which the numbers of one arithmetic are drawn: W' and Y' are extents in units of
/// 1/scale px.
struct Canvas {
    std::int64_t width = 0;
    std::int64_t height = 0;
    std::int64_t scale = 1;
};

/// An edge within the canvas (0 <= y <= Y', dx <= W') and a column at which y is an integer or 1/D
/// below or above one, where rounding has the least room; or any column.
Place drawPlace(RandomNumbers &random, const Canvas &canvas)
{
    Place place;
    place.scale = canvas.scale;
    do {
        place.dx = random.in(std::min<std::int64_t>(2, canvas.width), canvas.width);
        if (random.oneIn(2))
            place.dx = canvas.width - random.in(0, canvas.width / 8);
        place.dy = random.in(-(canvas.height - canvas.scale), canvas.height - canvas.scale);
    } while (greatestCommonDivisor(place.dx, place.dy) != 1);
    const std::int64_t lowest = std::max<std::int64_t>(0, -place.dy);
    const std::int64_t room = canvas.height - absolute(place.dy) - canvas.scale;
    place.ya = lowest + random.in(0, room);
    const std::int64_t offset = random.in(-1, 1); // of N from a multiple of D
    std::int64_t run = modulo(Int128(offset) * inverse(place.dy, place.dx), place.dx);
    if (random.oneIn(4)) {
        run = random.in(0, place.dx);
    } else {
        const Int128 rows = (Int128(run) * place.dy - offset) / place.dx;
        place.ya += modulo(-rows - place.ya, canvas.scale);
    }
    place.xa = modulo(-run, canvas.scale);
    place.column = (place.xa + run) / canvas.scale;
    return place;
}

/// Draws canvases and places on them; counts those whose rows are wrong and keeps the first.
template <class DrawCanvas>
QString wrongPlaces(Rows (*rows)(const Place &), std::uint64_t seed, int count,
                    const DrawCanvas &drawCanvas)
{
    RandomNumbers random(seed);
    std::int64_t wrong = 0;
    QString first;
    for (int i = 0; i < count; ++i) {
        const Place place = drawPlace(random, drawCanvas(random));
        if (rows(place) == exactRows(place))
            continue;
        if (wrong++ == 0)
            first = place.text();
    }
    if (wrong == 0)
        return {};
    return u"%1 of %2 wrong with seed %3, first %4"_s.arg(wrong).arg(count).arg(seed).arg(first);
}

/// A canvas with W'·Y' just below 2^bits, in all shapes from flat to steep; Y' is at least two
/// pixels.
auto canvasOfArea(int bits, std::int64_t scale)
{
    return [bits, scale](RandomNumbers &random) {
        const int lowestBits = scale == 1 ? 1 : 9; // 2^9 units: two pixels of 256
        const std::int64_t height = (std::int64_t(1) << random.in(lowestBits, bits - 2)) - 1
            + random.in(1, 1 << (lowestBits - 1));
        const std::int64_t width = ((std::int64_t(1) << bits) - 1) / height;
        return Canvas{std::min(width, largestCoordinate / 2), height, scale};
    };
}

/// A canvas with W' below 2^bits and at least half of it.
auto canvasOfWidth(int bits, std::int64_t scale)
{
    return [bits, scale](RandomNumbers &random) {
        const std::int64_t largest = (std::int64_t(1) << bits) - 1;
        return Canvas{random.in(largest / 2, largest), 4096 * scale, scale};
    };
}

constexpr std::uint64_t seed = 20261121;
constexpr int placeCount = 200000;

} // namespace

/// The half-quantum bias theorem (resources/numerics.md, 3.2) tested from both sides: inside the
/// domain proved for an arithmetic no ⌈y⌉ and no ⌊y⌋ is wrong, outside it some are.
class TestDomains : public QObject {
    Q_OBJECT

private slots:
    void float32MultiplyIsRightBelow21Bits()
    {
        for (const std::int64_t scale : {1, 256})
            QCOMPARE(
                wrongPlaces(rowsByMultiplying<float>, seed, placeCount, canvasOfArea(21, scale)),
                QString());
    }
    void float32MultiplyFailsAt23Bits()
    {
        QVERIFY(!wrongPlaces(rowsByMultiplying<float>, seed, placeCount, canvasOfArea(23, 1))
                     .isEmpty());
    }

    void float64MultiplyIsRightBelow50Bits()
    {
        for (const std::int64_t scale : {1, 256})
            QCOMPARE(
                wrongPlaces(rowsByMultiplying<double>, seed, placeCount, canvasOfArea(50, scale)),
                QString());
    }
    void float64MultiplyFailsAt52Bits()
    {
        QVERIFY(!wrongPlaces(rowsByMultiplying<double>, seed, placeCount, canvasOfArea(52, 1))
                     .isEmpty());
    }
    /// The product requires 2^40, because it computes the colours in the same numbers.
    void theBiasedColumnScanIsRightBelow40Bits()
    {
        QCOMPARE(wrongPlaces(rowsByProduct, seed, placeCount, canvasOfArea(40, unitsPerPixel)),
                 QString());
    }

    void fixed16IsRightBelow8Bits()
    {
        for (const std::int64_t scale : {1, 4, 16, 256})
            QCOMPARE(
                wrongPlaces(rowsByAdding<FixedPoint16>, seed, placeCount, canvasOfWidth(8, scale)),
                QString());
    }
    void fixed16FailsAt9Bits()
    {
        QVERIFY(!wrongPlaces(rowsByAdding<FixedPoint16>, seed, placeCount, canvasOfWidth(9, 1))
                     .isEmpty());
    }

    void fixed32IsRightBelow16Bits()
    {
        for (const std::int64_t scale : {1, 16, 256})
            QCOMPARE(
                wrongPlaces(rowsByAdding<FixedPoint32>, seed, placeCount, canvasOfWidth(16, scale)),
                QString());
    }
    void fixed32FailsAt17Bits()
    {
        QVERIFY(!wrongPlaces(rowsByAdding<FixedPoint32>, seed, placeCount, canvasOfWidth(17, 1))
                     .isEmpty());
    }

    void theSearchDrawsPlacesAtAndBesideIntegers()
    {
        RandomNumbers random(seed);
        std::array<int, 3> counts = {};
        for (int i = 0; i < 1000; ++i) {
            const Place place = drawPlace(random, canvasOfArea(30, 256)(random));
            const Int128 beside = (place.numerator() + 1) % place.denominator();
            if (beside >= 0 && beside <= 2)
                ++counts[std::size_t(beside)];
        }
        for (const int count : counts)
            QVERIFY2(count > 100, qPrintable(QString::number(count)));
    }
};

PIXELPLUMB_TEST(TestDomains)

} // namespace tst_domains

#include "tst_domains.moc"
