// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/colourplane.h"
#include "core/scan/biasarithmetic.h"
#include "core/scan/columnstate.h"
#include "tests/support/colourplaces.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_colourdomains {

using namespace pixelplumb;

namespace {

/// c₀ + g_x·Δx + g_y·Δy with β = 1/(4A), each operation rounded (resources/numerics.md, 3.3 c and
/// d).
template <class Float>
std::int64_t levelByPlane(const ColourPlace &place)
{
    const auto area = Float(place.area());
    const auto scale = Float(place.scale);
    const Float value = Float(place.levels[0])
        + Float(place.perColumn()) / area * (Float(place.x) / scale)
        + Float(place.perRow()) / area * (Float(place.y) / scale);
    return std::int64_t(std::floor(value + (Float(0.5) + Float(0.25) / area)));
}

/// Like levelByPlane(), but in the product's own arithmetic, which must not have fallen back on
/// integers.
std::int64_t levelByProduct(const ColourPlace &place)
{
    const Triangle triangle = place.triangle();
    const std::array<int, 3> order = sortedByColumn(triangle);
    const auto corner = [&](std::size_t i) { return triangle.vertices[std::size_t(order[i])]; };
    const std::array<Vertex, 3> corners = {corner(0), corner(1), corner(2)};
    using A = BiasArithmetic<BiasOrExactNumber>;
    const A::ColourRamp ramp(corners[0], corners[1], corners[2]);
    ColumnState<A> column;
    column.x = 0; // ColourPlace::triangle() puts the sample there
    const BiasOrExactNumber number = ramp.starts(column, 0)[0];
    return number.isExact ? -1 : A::level(number, ByteRounding::Nearest);
}

/// A word with F fraction bits at the first sample of the box, to which rounded gradients are added
/// modulo 2^64; the bias 1/(4A) itself is not rounded (3.3 b).
template <int F>
std::int64_t levelByWords(const ColourPlace &place)
{
    const Int128 area = place.area();
    const auto word = [&](Int128 numerator) {
        return std::uint64_t(floorDivide<Int128>(numerator * (Int128(2) << F) + area, 2 * area));
    };
    const Steps steps = place.stepsInBox();
    const Int128 start
        = place.numerator() - steps.right * place.perColumn() - steps.up * place.perRow();
    const auto sum = std::int64_t(word(start) + std::uint64_t(steps.right) * word(place.perColumn())
                                  + std::uint64_t(steps.up) * word(place.perRow()));
    const Int128 one = Int128(1) << F;
    return std::int64_t(floorDivide<Int128>(4 * area * sum + one * (2 * area + 1), 4 * area * one));
}

/// E < 1/(4A) with E = (|dx| + |dy| + 1)·2^−(F+1).
template <int F>
bool isInWordDomain(const ColourPlace &place)
{
    const Steps steps = place.stepsInBox();
    return 4 * place.area() * (steps.right + steps.up + 1) < Int128(2) << F;
}

/// 4 A (n + 1), which colourplane.h requires to be below 2^56.
double resolutionOf(const ColourPlace &place)
{
    const Steps box = place.boxInPixels();
    return 4 * double(place.area()) * double(box.right + box.up);
}

/// The product's 56-bit words; `resolution` is the value that they are given for the triangle.
std::int64_t levelByWideWords(const ColourPlace &place, double resolution)
{
    const Triangle triangle = place.triangle();
    const Steps steps = place.stepsInBox();
    const Steps box = place.boxInPixels();
    TriangleBatch batch;
    batch.size = 1;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vertex &vertex = triangle.vertices[corner];
        batch.x[corner][0] = std::int32_t(vertex.position.x);
        batch.y[corner][0] = std::int32_t(vertex.position.y);
        batch.colour[corner][0] = std::uint32_t(vertex.colour.red());
    }
    batch.firstColumn[0] = -std::int32_t(steps.right);
    batch.firstRow[0] = -std::int32_t(steps.up);
    batch.endColumn[0] = batch.firstColumn[0] + std::int32_t(box.right);
    batch.endRow[0] = batch.firstRow[0] + std::int32_t(box.up);
    batch.resolution[0] = resolution;
    const auto plane = ColourPlane::wide(batch, 0, ByteRounding::Nearest);
    return plane ? std::int64_t(plane->at(0, steps.right, steps.up) >> wideFractionBits) : -1;
}

std::int64_t levelByTrueWideWords(const ColourPlace &place)
{
    return levelByWideWords(place, resolutionOf(place));
}

/// Like levelByWideWords(), but made to assume that its bits suffice.
std::int64_t levelByDeceivedWideWords(const ColourPlace &place)
{
    return levelByWideWords(place, 0);
}

bool isInWideDomain(const ColourPlace &place)
{
    return resolutionOf(place) < resolutionLimit(wideFractionBits);
}
bool isOutsideWideDomain(const ColourPlace &place) { return !isInWideDomain(place); }
bool isAny(const ColourPlace &) { return true; }

constexpr std::uint64_t seed = 20261121;
constexpr int placeCount = 20000;

/// Draws places with W'·H' up to 2^bits and counts the wrong bytes among those in the domain.
QString wrongLevels(std::int64_t (*level)(const ColourPlace &), int bits, std::int64_t scale,
                    bool (*isMeant)(const ColourPlace &) = isAny)
{
    RandomNumbers random(seed);
    std::int64_t meant = 0;
    std::int64_t wrong = 0;
    QString first;
    for (int i = 0; i < placeCount; ++i) {
        const ColourPlace place = drawColourPlace(random, bits, scale);
        if (!isMeant(place))
            continue;
        ++meant;
        if (level(place) != place.exactLevel() && wrong++ == 0)
            first = place.text();
    }
    if (meant < placeCount / 20)
        return u"only %1 places in the domain"_s.arg(meant);
    if (wrong == 0)
        return {};
    return u"%1 of %2 wrong with seed %3, first %4"_s.arg(wrong).arg(meant).arg(seed).arg(first);
}

} // namespace

/// The exact colours of resources/numerics.md, 3.3, tested from both sides: inside the domain
/// proved for a form no byte is wrong, outside it some are.
class TestColourDomains : public QObject {
    Q_OBJECT

private slots:
    void wordsAreRightWhileTheirErrorIsBelowTheBias()
    {
        QCOMPARE(wrongLevels(levelByWords<24>, 14, 1, isInWordDomain<24>), QString());
        QCOMPARE(wrongLevels(levelByWords<24>, 17, 16, isInWordDomain<24>), QString());
        QCOMPARE(wrongLevels(levelByWords<48>, 30, 1, isInWordDomain<48>), QString());
        QCOMPARE(wrongLevels(levelByWords<48>, 36, 256, isInWordDomain<48>), QString());
    }
    void wordsFailBeyond()
    {
        QVERIFY(wrongLevels(levelByWords<24>, 18, 1).contains(QLatin1String("wrong")));
        QVERIFY(wrongLevels(levelByWords<48>, 40, 256).contains(QLatin1String("wrong")));
    }

    void theFastPathsWideWordsAreRightInTheirDomain()
    {
        QCOMPARE(wrongLevels(levelByTrueWideWords, 40, 256, isInWideDomain), QString());
    }
    void theFastPathsWideWordsFailBeyond()
    {
        QVERIFY(wrongLevels(levelByDeceivedWideWords, 46, 256, isOutsideWideDomain)
                    .contains(QLatin1String("wrong")));
    }

    void float64PlanesAreRightUpTo40Bits()
    {
        QCOMPARE(wrongLevels(levelByPlane<double>, 40, 1), QString());
        QCOMPARE(wrongLevels(levelByPlane<double>, 40, 256), QString());
    }
    void theBiasedColumnScansColoursAreRightUpTo40Bits()
    {
        QCOMPARE(wrongLevels(levelByProduct, 40, 256), QString());
    }
    /// Samples next to a half find errors that random ones do not (resources/numerics.md, 3.3 c).
    void float64PlanesFailAt44Bits()
    {
        QVERIFY(wrongLevels(levelByPlane<double>, 44, 256).contains(QLatin1String("wrong")));
    }

    void float32PlanesAreRightUpTo11Bits()
    {
        QCOMPARE(wrongLevels(levelByPlane<float>, 11, 1), QString());
        QCOMPARE(wrongLevels(levelByPlane<float>, 11, 16), QString());
    }
    void float32PlanesFailAt14Bits()
    {
        QVERIFY(wrongLevels(levelByPlane<float>, 14, 1).contains(QLatin1String("wrong")));
    }
};

PIXELPLUMB_TEST(TestColourDomains)

} // namespace tst_colourdomains

#include "tst_colourdomains.moc"
