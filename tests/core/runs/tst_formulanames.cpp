// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/formulanames.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <random>

namespace tst_formulanames {

using namespace pixelplumb;

/// Formulas with numbers in place of their names.
class TestFormulaNames : public QObject {
    Q_OBJECT

private slots:
    void everyNameBecomesItsNumber()
    {
        FormulaNames names;
        names.add(u"y_B"_s, Quantity::rational(-3, 2), Quantity::integer(7));
        names.add(u"Δy"_s, Quantity::integer(-2));
        QCOMPARE(names.substituted(u"t = y_B′ + Δy·y_B"_s, u"t"_s), u"7 + (−2)·(−1 1/2)"_s);
    }

    /// In a sum close to a whole number, the shown digits add up to the same side of it.
    void theOperandsOfASumJustifyItsCeiling()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> place(-40, 40);
        for (int i = 0; i < 2000; ++i) {
            const int exponent = 8 + i % 33;
            const double beside
                = i / 33 % 2 == 0 ? std::ldexp(1, -exponent) : -std::ldexp(1, -exponent);
            const double a = place(random);
            const double b = 12 + beside - a;
            const double sum = a + b;
            if (sum == 12)
                continue;
            FormulaNames names;
            names.add(u"a"_s, Quantity::of(a));
            names.add(u"b"_s, Quantity::of(b));
            QString shown
                = names.substituted(u"s = a + b"_s, u"s"_s, placesOfOperands(Quantity::of(sum)));
            double shownSum = 0;
            for (QString operand : shown.split(u" + "_s))
                shownSum += operand.remove(u'(')
                                .remove(u')')
                                .remove(u'…')
                                .replace(u'−', u'-')
                                .toDouble();
            QVERIFY2((shownSum > 12) == (sum > 12),
                     qPrintable(u"%1 is %2"_s.arg(shown).arg(sum, 0, 'g', 17)));
        }
    }

    void anOrdinarySumHasSixDigits()
    {
        FormulaNames names;
        names.add(u"a"_s, Quantity::of(1 / 3.0));
        QCOMPARE(names.substituted(u"s = a"_s, u"s"_s, placesOfOperands(Quantity::of(12.3))),
                 u"0.333333…"_s);
    }
};

PIXELPLUMB_TEST(TestFormulaNames)

} // namespace tst_formulanames

#include "tst_formulanames.moc"
