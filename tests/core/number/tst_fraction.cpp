// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seededrandom.h"
#include "core/number/fraction.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_fraction {

using namespace pixelplumb;

namespace {

/// Of up to 120 bits above and below, or small, or whole.
Fraction randomFraction(SeededRandom &random)
{
    const auto bits = [&] {
        const Int128 high = random.between(-(std::int64_t(1) << 60), std::int64_t(1) << 60);
        const Int128 value = (high << 60) + random.between(0, std::int64_t(1) << 60);
        return value >> random.between(0, 118);
    };
    const Int128 below = random.between(0, 3) == 0 ? Int128(1) : bits();
    return {bits(), below == 0 ? Int128(1) : below};
}

} // namespace

/// Fractions are those of wide integers, whether 128 bits hold them or not.
class TestFraction : public QObject {
    Q_OBJECT

private slots:
    void computesWhatWideIntegersCompute()
    {
        SeededRandom random(3);
        int wide = 0;
        for (int i = 0; i < 20'000; ++i) {
            const Fraction a = randomFraction(random);
            const Fraction b = i % 7 == 0 ? a : randomFraction(random);
            const BigRational p = a.wide();
            const BigRational q = b.wide();
            QVERIFY((a + b).wide() == p + q);
            QVERIFY((a - b).wide() == p - q);
            QVERIFY((a * b).wide() == p * q);
            if (q != 0)
                QVERIFY((a / b).wide() == p / q);
            QCOMPARE(a < b, p < q);
            QCOMPARE(a == b, p == q);
            wide += (a * b).isNarrow() ? 0 : 1;
        }
        QVERIFY(wide > 1000);
    }

    void roundsDownAndUp()
    {
        QCOMPARE(Fraction(-7, 2).floor(), std::int64_t(-4));
        QCOMPARE(Fraction(-7, 2).ceil(), std::int64_t(-3));
        QCOMPARE(Fraction(7, -2).floor(), std::int64_t(-4));
        QCOMPARE(Fraction(-8, 2).floor(), std::int64_t(-4));
        // 3 + 2^-140 does not fit in 128 bits.
        const Fraction small = Fraction(1, Int128(1) << 70) * Fraction(1, Int128(1) << 70);
        QVERIFY(!small.isNarrow());
        QCOMPARE((Fraction(3) + small).floor(), std::int64_t(3));
        QCOMPARE((Fraction(3) + small).ceil(), std::int64_t(4));
        QCOMPARE((Fraction(-3) - small).floor(), std::int64_t(-4));
        QCOMPARE((Fraction(-3) - small).ceil(), std::int64_t(-3));
        QVERIFY((Fraction(3) + small - small).isNarrow());
    }

    void putsTwoOverOneDenominator()
    {
        const auto both = overOneDenominator(Fraction(5, 6), Fraction(-3, 4));
        QVERIFY(both.has_value());
        QVERIFY(both->first.below() == both->second.below());
        QVERIFY(both->first == Fraction(5, 6) && both->second == Fraction(-3, 4));
    }
};

PIXELPLUMB_TEST(TestFraction)

} // namespace tst_fraction

#include "tst_fraction.moc"
