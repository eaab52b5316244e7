// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "tests/support/testprogram.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/numberlayout.h"
#include "widgets/look/typesetting.h"

#include <QRegularExpression>
#include <QTest>

#include <limits>

namespace tst_numberformat {

using namespace pixelplumb;

class TestNumberFormat : public QObject {
    Q_OBJECT

private slots:
    void writesNumbersForTheEye_data()
    {
        QTest::addColumn<Quantity>("quantity");
        QTest::addColumn<QString>("expected");
        QTest::newRow("none") << Quantity() << QString();
        QTest::newRow("zero") << Quantity::integer(0) << u"0"_s;
        QTest::newRow("integer") << Quantity::integer(-17) << u"−17"_s;
        QTest::newRow("mixed") << Quantity::rational(139, 8) << u"17\u20093/8"_s;
        QTest::newRow("negative mixed") << Quantity::rational(-7, 3) << u"−2\u20091/3"_s;
        QTest::newRow("below one") << Quantity::rational(-3, 8) << u"−3/8"_s;
        QTest::newRow("six digits") << Quantity::rational(1, 999999) << u"1/999999"_s;
        QTest::newRow("seven digits") << Quantity::rational(1, 1000001) << u"0.0000009…"_s;
        QTest::newRow("float") << Quantity::of(0.1F) << u"0.1"_s;
        QTest::newRow("double") << Quantity::of(-0.1) << u"−0.1"_s;
        QTest::newRow("small float") << Quantity::of(1.5e-5F) << u"0.000015"_s;
        QTest::newRow("tiny double") << Quantity::of(1.5e-12) << u"1.5e−12"_s;
        QTest::newRow("infinite") << Quantity::of(-std::numeric_limits<double>::infinity())
                                  << u"−∞"_s;
        QTest::newRow("not a number")
            << Quantity::of(std::numeric_limits<float>::quiet_NaN()) << u"NaN"_s;
    }
    void writesNumbersForTheEye()
    {
        QFETCH(const Quantity, quantity);
        QTEST(displayText(quantity), "expected");
    }

    void fixedPointIsShownInDecimals_data()
    {
        QTest::addColumn<Quantity>("quantity");
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::addColumn<QString>("expected");
        const Quantity third = Quantity::of(FixedPoint16::fromRaw(21845));
        QTest::newRow("16.16") << third << Arithmetic::Fixed16 << u"0.333328…"_s;
        QTest::newRow("32.32") << third << Arithmetic::Fixed32 << u"0.33332824707…"_s;
        QTest::newRow("exact keeps fractions")
            << Quantity::rational(1, 3) << Arithmetic::Exact << u"1/3"_s;
        QTest::newRow("integers stay integers")
            << Quantity::of(FixedPoint16::fromInteger(7)) << Arithmetic::Fixed16 << u"7"_s;
    }
    void fixedPointIsShownInDecimals()
    {
        QFETCH(const Quantity, quantity);
        QFETCH(const Arithmetic, arithmetic);
        QTEST(displayText(quantity, arithmetic), "expected");
    }

    void decimalsAreDigitsOfTheNumberAndNotRounded_data()
    {
        QTest::addColumn<Quantity>("quantity");
        QTest::addColumn<int>("places");
        QTest::addColumn<QString>("expected");
        QTest::newRow("terminating") << Quantity::rational(139, 8) << 6 << u"17.375000"_s;
        QTest::newRow("two thirds") << Quantity::rational(2, 3) << 6 << u"0.666666…"_s;
        QTest::newRow("negative") << Quantity::rational(-7, 3) << 2 << u"−2.33…"_s;
        QTest::newRow("beyond a double")
            << Quantity::rational(1, 7) << 24 << u"0.142857142857142857142857…"_s;
        QTest::newRow("integer") << Quantity::integer(3) << 2 << u"3.00"_s;
        QTest::newRow("float") << Quantity::of(0.5F) << 3 << u"0.500"_s;
        // A double shows its shortest decimal; if that has more places, it is cut as in sentences.
        QTest::newRow("double") << Quantity::of(0.3) << 6 << u"0.300000"_s;
        QTest::newRow("double of many digits") << Quantity::of(8.0 / 3) << 6 << u"2.666666…"_s;
        QTest::newRow("little below 0") << Quantity::rational(-1, 2097152) << 6 << u"−0.0000004…"_s;
        // Numbers whose ceiling or floor must be credible from the digits.
        QTest::newRow("just above 12") << Quantity::of(12 + 0x1p-40) << 4 << u"12.0000000000009…"_s;
        QTest::newRow("just below 12") << Quantity::of(12 - 0x1p-40) << 4 << u"11.9999…"_s;
        QTest::newRow("just below −12")
            << Quantity::of(-12 - 0x1p-40) << 4 << u"−12.0000000000009…"_s;
        QTest::newRow("a fraction above 12")
            << Quantity::rational(12 * (Int128(1) << 40) + 1, Int128(1) << 40) << 6
            << u"12.0000000000009…"_s;
        QTest::newRow("whole") << Quantity::of(12.0) << 4 << u"12.0000"_s;
    }
    void decimalsAreDigitsOfTheNumberAndNotRounded()
    {
        QFETCH(const Quantity, quantity);
        QFETCH(const int, places);
        QTEST(displayDecimal(quantity, places), "expected");
    }

    void aDecimalInLittleRoomTellsHowFarFromAWholeNumberItIs_data()
    {
        QTest::addColumn<Quantity>("quantity");
        QTest::addColumn<QString>("expected");
        QTest::newRow("above") << Quantity::of(12 + 0x1p-49) << u"12 + 2e−15"_s;
        QTest::newRow("below zero") << Quantity::of(-12 - 0x1p-40) << u"−12 − 9e−13"_s;
        QTest::newRow("not near") << Quantity::of(12.34567) << u"12.3456…"_s;
        QTest::newRow("below") << Quantity::of(12 - 0x1p-40) << u"11.9999…"_s;
        QTest::newRow("a fraction") << Quantity::rational(37, 3) << u"12.3333…"_s;
        QTest::newRow("whole") << Quantity::of(12.0) << u"12.0000"_s;
    }
    void aDecimalInLittleRoomTellsHowFarFromAWholeNumberItIs()
    {
        QFETCH(const Quantity, quantity);
        QTEST(shortDecimal(quantity, 4), "expected");
    }

    void decimalsBesideANumberEqualItAreNearItOrSayNothing_data()
    {
        QTest::addColumn<Quantity>("quantity");
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::addColumn<QString>("expected");
        const auto none = Quantity();
        QTest::newRow("nothing") << none << Arithmetic::Exact << QString();
        QTest::newRow("integer") << Quantity::integer(255) << Arithmetic::Exact << QString();
        QTest::newRow("float") << Quantity::of(0.1F) << Arithmetic::Float32 << QString();
        QTest::newRow("eighths") << Quantity::rational(255, 8) << Arithmetic::Exact
                                 << u"= 31.875"_s;
        QTest::newRow("negative half")
            << Quantity::rational(-1, 2) << Arithmetic::Exact << u"= −0.5"_s;
        QTest::newRow("six places")
            << Quantity::rational(1, 64) << Arithmetic::Exact << u"= 0.015625"_s;
        QTest::newRow("seven places")
            << Quantity::rational(1, 128) << Arithmetic::Exact << u"≈ 0.007812…"_s;
        QTest::newRow("thirds") << Quantity::rational(17, 3) << Arithmetic::Exact
                                << u"≈ 5.666666…"_s;
        QTest::newRow("decimals already")
            << Quantity::rational(1, 1'000'003) << Arithmetic::Exact << QString();
        QTest::newRow("fixed point")
            << Quantity::rational(21845, 65536) << Arithmetic::Fixed16 << QString();
    }
    void decimalsBesideANumberEqualItAreNearItOrSayNothing()
    {
        QFETCH(const Quantity, quantity);
        QFETCH(const Arithmetic, arithmetic);
        QTEST(decimalBeside(quantity, arithmetic), "expected");
    }

    void toolTipsSetTheSubscriptsOfEveryNumber()
    {
        static const QRegularExpression lowered(u"_[\\p{L}\\p{N}]+"_s);
        int subscripts = 0;
        for (const Method &method : methods()) {
            for (const auto &numbers :
                 {method.numbers.setUp, method.numbers.span, method.numbers.sample}) {
                for (const NumberDescription &number : numbers) {
                    const QString written = number.toolTip + number.formula;
                    const QString shown = numberToolTip(number);
                    QVERIFY2(!shown.contains(lowered), qPrintable(shown));
                    QCOMPARE(shown.count(u"<sub>"_s), written.count(lowered));
                    subscripts += int(written.count(lowered));
                }
            }
        }
        QVERIFY(subscripts > 100);
    }

    void errorsCarryTheirSign_data()
    {
        QTest::addColumn<Quantity>("used");
        QTest::addColumn<Quantity>("exact");
        QTest::addColumn<QString>("expected");
        QTest::newRow("equal") << Quantity::of(0.5) << Quantity::rational(1, 2) << u"0"_s;
        QTest::newRow("above") << Quantity::of(0.75) << Quantity::rational(1, 2) << u"+2.5e−01"_s;
        QTest::newRow("below") << Quantity::of(0.25F) << Quantity::rational(1, 2) << u"−2.5e−01"_s;
        QTest::newRow("a row too many") << Quantity::integer(7) << Quantity::integer(6) << u"+1"_s;
        QTest::newRow("two rows too few")
            << Quantity::integer(4) << Quantity::integer(6) << u"−2"_s;
        QTest::newRow("nothing to compare") << Quantity::of(0.5) << Quantity() << QString();
    }
    void errorsCarryTheirSign()
    {
        QFETCH(const Quantity, used);
        QFETCH(const Quantity, exact);
        QTEST(displayError(used, exact), "expected");
    }

    void findsTheFirstDigitThatDiffers_data()
    {
        QTest::addColumn<QString>("used");
        QTest::addColumn<QString>("exactDecimal");
        QTest::addColumn<int>("expected");
        QTest::newRow("last digit") << "17.129631"
                                    << "17.129629…" << 7;
        QTest::newRow("a prefix agrees") << "17.1296"
                                         << "17.129629…" << -1;
        QTest::newRow("beyond what is known") << "17.1296291"
                                              << "17.129629…" << -1;
        QTest::newRow("zeros go on") << "5.0000005"
                                     << "5.000000" << 8;
        QTest::newRow("equal integers") << "5"
                                        << "5.000000" << -1;
        QTest::newRow("whole differs") << "4.9999995"
                                       << "5.000000" << 0;
        QTest::newRow("sign differs") << "−0.1"
                                      << "0.1" << 0;
    }
    void findsTheFirstDigitThatDiffers()
    {
        QFETCH(const QString, used);
        QFETCH(const QString, exactDecimal);
        QTEST(firstDifferingDigit(used, exactDecimal), "expected");
    }

    void takesNumbersApartWhereColumnsAlignThem_data()
    {
        QTest::addColumn<Quantity>("quantity");
        QTest::addColumn<QStringList>("expected"); // whole, numerator, denominator, decimals
        QTest::newRow("mixed") << Quantity::rational(-7, 3) << QStringList{"−2", "1", "3", ""};
        QTest::newRow("fraction") << Quantity::rational(3, 8) << QStringList{"", "3", "8", ""};
        QTest::newRow("negative fraction")
            << Quantity::rational(-3, 8) << QStringList{"−", "3", "8", ""};
        QTest::newRow("decimal") << Quantity::of(-2.5) << QStringList{"−2", "", "", ".5"};
        QTest::newRow("integer") << Quantity::integer(12) << QStringList{"12", "", "", ""};
    }
    void takesNumbersApartWhereColumnsAlignThem()
    {
        QFETCH(const Quantity, quantity);
        const NumberParts parts = partsOf(displayText(quantity));
        QTEST((QStringList{parts.whole, parts.numerator, parts.denominator, parts.decimals}),
              "expected");
    }

    void lowersWhatFollowsAnUnderscore_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("expected");
        QTest::newRow("letter") << u"⌈y_B⌉"_s << u"⌈y<sub>B</sub>⌉"_s;
        QTest::newRow("word") << u"x − x_start"_s << u"x − x<sub>start</sub>"_s;
        QTest::newRow("nothing to lower") << u"a_ < b"_s << u"a_ &lt; b"_s;
    }
    void lowersWhatFollowsAnUnderscore()
    {
        QFETCH(const QString, text);
        QTEST(SymbolText(text).html(), "expected");
    }
};

PIXELPLUMB_TEST(TestNumberFormat)

} // namespace tst_numberformat

#include "tst_numberformat.moc"
