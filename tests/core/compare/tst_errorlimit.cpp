// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/bounderrors.h"
#include "core/scan/kernelnumbers.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace tst_errorlimit {

using namespace pixelplumb;

namespace {

/// The exact y of an edge on a column, px.
Quantity exactOrdinate(const Vertex &a, const Vertex &b, std::int64_t column)
{
    const Int128 width = b.position.x - a.position.x;
    const Int128 along = column * unitsPerPixel - a.position.x;
    return Quantity::rational(a.position.y * width + along * (b.position.y - a.position.y),
                              width * unitsPerPixel);
}

/// How often a walked edge was farther from the exact one than the bound, and than the additions
/// alone allow.
struct Excess {
    int ofLimit = 0;
    int ofAdditions = 0;
};

/// Walks an edge by its rounded slope, from its first column or, if clipped, from a later one.
template <class A>
void walk(const Vertex &a, const Vertex &b, std::int64_t skipped, Excess &excess)
{
    const double largest = double(std::max(absolute(a.position.y), absolute(b.position.y))) / 256;
    const double extent = double(absolute(b.position.y - a.position.y)) / 256;
    const std::int64_t first = ceilPixel(a.position.x);
    const std::int64_t start = first + skipped;
    const typename A::Number slope = A::edgeSlope(a, b);
    typename A::Number y = A::edgeOrdinate(a, b, A::runTo(start, a), slope);
    for (std::int64_t column = start; column * unitsPerPixel <= b.position.x; ++column) {
        const double error = std::abs(errorOf(Quantity::of(y), exactOrdinate(a, b, column)));
        const auto additions = double(column - first + 1);
        excess.ofLimit += int(error > errorLimit(A::arithmetic, additions, largest, extent));
        excess.ofAdditions += int(error > errorLimit(A::arithmetic, additions, largest, 0));
        A::advance(y, slope);
    }
}

/// Every slope in eighths of a pixel, from several starts: near 0 and far from it, on samples and
/// off them.
template <class A>
Excess excessOverSmallEdges()
{
    Excess excess;
    for (const Lattice startX : {0, 1, 37, 255}) {
        for (const Lattice startY : {Lattice(0), Lattice(100), Lattice(-5) * 256 + 3,
                                     Lattice(1000) * 256 + 77, Lattice(8191) * 256 + 200}) {
            for (Lattice width = 32; width <= 12 * 256; width += 32) {
                for (Lattice height = -40 * 256; height <= 40 * 256; height += 97) {
                    const Vertex a{{startX, startY}, {}};
                    const Vertex b{{startX + width, startY + height}, {}};
                    walk<A>(a, b, 0, excess);
                    walk<A>(a, b, 5, excess);
                }
            }
        }
    }
    return excess;
}

} // namespace

/// How far rounding may accumulate (resources/numerics.md, 2.2), tested on every one of many edges.
class TestErrorLimit : public QObject {
    Q_OBJECT

private slots:
    void noWalkedEdgeLeavesTheBoundInFloat32()
    {
        const Excess excess = excessOverSmallEdges<RoundedArithmetic<float>>();
        QCOMPARE(excess.ofLimit, 0);
        // The slope's own rounding counts: without it the bound would be wrong.
        QVERIFY(excess.ofAdditions > 0);
    }
    void noWalkedEdgeLeavesTheBoundInFloat64()
    {
        const Excess excess = excessOverSmallEdges<RoundedArithmetic<double>>();
        QCOMPARE(excess.ofLimit, 0);
        QVERIFY(excess.ofAdditions > 0);
    }
    void noWalkedEdgeLeavesTheBoundInFixedPoint()
    {
        QCOMPARE(excessOverSmallEdges<RoundedArithmetic<FixedPoint16>>().ofLimit, 0);
        QCOMPARE(excessOverSmallEdges<RoundedArithmetic<FixedPoint32>>().ofLimit, 0);
    }
};

PIXELPLUMB_TEST(TestErrorLimit)

} // namespace tst_errorlimit

#include "tst_errorlimit.moc"
