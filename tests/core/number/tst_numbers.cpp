// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/number/quantity.h"
#include "core/number/wideinteger.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

namespace tst_numbers {

using namespace pixelplumb;

/// Mixed numbers, fixed point, and their shared notation.
class TestNumbers : public QObject {
    Q_OBJECT

private slots:
    void dividesTowardsMinusInfinity()
    {
        QCOMPARE(floorDivide(-7, 2), -4);
        QCOMPARE(floorDivide(7, 2), 3);
        QCOMPARE(ceilDivide(-7, 2), -3);
        QCOMPARE(ceilDivide(7, 2), 4);
        QCOMPARE(ceilDivide(-8, 2), -4);
    }

    void addsQuotientsAndCarriesRemainders()
    {
        auto y = MixedNumber<std::int64_t>::fromFraction(-5, 8); // −1 + 3/8
        const auto slope = MixedNumber<std::int64_t>::fromFraction(7, 8);
        QCOMPARE(y.floor(), std::int64_t(-1));
        QCOMPARE(y.ceil(), std::int64_t(0));
        y.advance(slope); // 2/8
        QCOMPARE(y.floor(), std::int64_t(0));
        QCOMPARE(y.remainder, std::int64_t(2));
        for (int step = 0; step < 6; ++step)
            y.advance(slope); // 2/8 + 42/8 = 5 4/8
        QCOMPARE(y.whole, std::int64_t(5));
        QCOMPARE(y.remainder, std::int64_t(4));
    }

    void fixedPointRoundsToNearestAndWraps()
    {
        const FixedPoint16 third = FixedPoint16::fromInteger(1) / FixedPoint16::fromInteger(3);
        QCOMPARE(third.raw(), 21845); // 65536/3 = 21845.33
        const FixedPoint16 twoThirds = FixedPoint16::fromInteger(2) / FixedPoint16::fromInteger(3);
        QCOMPARE(twoThirds.raw(), 43691); // 43690.67
        QCOMPARE((FixedPoint16::fromInteger(-1) / FixedPoint16::fromInteger(3)).raw(), -21845);
        const FixedPoint16 large = FixedPoint16::fromInteger(32767);
        QCOMPARE((large + FixedPoint16::fromInteger(1)).floor(), std::int64_t(-32768));
        QCOMPARE(FixedPoint32::fromBinaryFraction(-3, 2).floor(), std::int64_t(-2));
        QCOMPARE(FixedPoint32::fromBinaryFraction(-3, 2).ceil(), std::int64_t(-1));
    }

    void spellsRationalsAsMixedNumbers_data()
    {
        QTest::addColumn<Quantity>("quantity");
        QTest::addColumn<QString>("text");
        QTest::newRow("whole and fraction") << Quantity::rational(139, 8) << "17 3/8";
        QTest::newRow("in lowest terms") << Quantity::rational(278, 16) << "17 3/8";
        QTest::newRow("negative, away from zero") << Quantity::rational(-7, 3) << "-2 1/3";
        QTest::newRow("below one") << Quantity::rational(-1, 3) << "-1/3";
        QTest::newRow("integer") << Quantity::integer(-12) << "-12";
        QTest::newRow("shortest float") << Quantity::of(0.1F) << "0.1";
        QTest::newRow("shortest double") << Quantity::of(0.1) << "0.1";
        QTest::newRow("fixed 16.16") << Quantity::of(FixedPoint16::fromRaw(0x18000)) << "1 1/2";
        QTest::newRow("none") << Quantity() << "";
        QTest::newRow("beyond 64 bits")
            << Quantity::integer((Int128(1) << 80)) << "1208925819614629174706176";
    }
    void spellsRationalsAsMixedNumbers()
    {
        QFETCH(Quantity, quantity);
        QTEST(toText(quantity), "text");
    }

    void minusSignsStandForHyphensOfNumbersAlone()
    {
        QCOMPARE(withMinus(u"column-scan of (-4, -1/3): 1e-07, off-screen 2-3 -inf"_s),
                 u"column-scan of (−4, −1/3): 1e−07, off-screen 2-3 −inf"_s);
    }

    void tellsTheErrorOfATinyDriftWithItsSign()
    {
        const Quantity exact = Quantity::rational(1, 10);
        // 0.1F = 0.100000001490116…
        QVERIFY(qAbs(errorOf(Quantity::of(0.1F), exact) - 1.490116119e-9) < 1e-17);
        QVERIFY(errorOf(Quantity::of(std::nextafter(20007.0, 0.0)), Quantity::integer(20007)) < 0);
        QCOMPARE(errorOf(exact, exact), 0.0);
        // A large whole part does not swallow the difference: 2^-28 of 2^30.
        const Quantity large = Quantity::rational((Int128(1) << 58) + 1, Int128(1) << 28);
        QCOMPARE(errorOf(large, Quantity::integer(1 << 30)), 1.0 / (1 << 28));
    }

    void aRationalIsTheDoubleNearestToIt()
    {
        using Rational = boost::multiprecision::cpp_rational;
        std::mt19937_64 random(7);
        const auto someInteger = [&random] {
            const Int128 wide = Int128(random() >> 1) << 63 | Int128(random() >> 1);
            return (wide >> int(random() % 126)) + 1;
        };
        const auto asRational = [](Int128 value) { return Rational(Int256(value)); };
        for (int run = 0; run < 20'000; ++run) {
            const Int128 numerator = random() % 2 == 0 ? someInteger() : -someInteger();
            const Int128 denominator = someInteger();
            const Rational exact = asRational(numerator) / asRational(denominator);
            const auto distance
                = [&exact](double value) -> Rational { return abs(Rational(value) - exact); };

            const double nearest = Quantity::rational(numerator, denominator).toDouble();

            const double infinity = std::numeric_limits<double>::infinity();
            QVERIFY(distance(nearest) <= distance(std::nextafter(nearest, infinity)));
            QVERIFY(distance(nearest) <= distance(std::nextafter(nearest, -infinity)));
        }
        QCOMPARE(Quantity::rational(-2, 99).toDouble(), -2.0 / 99);
        QCOMPARE(Quantity().toDouble(), 0.0);
    }

    void tellsTheNearestDoubleOfEveryError()
    {
        using Rational = boost::multiprecision::cpp_rational;
        std::mt19937_64 random(9);
        for (int run = 0; run < 5'000; ++run) {
            const Quantity exact
                = Quantity::rational(Int128(random() >> 4) - (Int128(1) << 59),
                                     (Int128(random() >> 20) << (random() % 60)) + 1);
            // Up to a few ulps away from it.
            double used = exact.toDouble();
            for (std::uint64_t step = random() % 4; step > 0; --step)
                used = std::nextafter(used, random() % 2 == 0 ? 1e30 : -1e30);
            const Rational error = Rational(used)
                - Rational(Int256(exact.numerator())) / Rational(Int256(exact.denominator()));

            const double told = errorOf(Quantity::of(used), exact);

            const Rational off = abs(Rational(Rational(told) - error));
            QVERIFY(off * (Int256(1) << 53) <= abs(error));
        }
    }

    void knowsIntegersExactly()
    {
        QVERIFY(Quantity::rational(16, 8).isInteger());
        QVERIFY(!Quantity::of(std::nextafter(17.0, 18.0)).isInteger());
        QVERIFY(!Quantity().isInteger());
    }
};

PIXELPLUMB_TEST(TestNumbers)

} // namespace tst_numbers

#include "tst_numbers.moc"
