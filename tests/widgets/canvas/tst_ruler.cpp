// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testprogram.h"
#include "widgets/canvas/ruler.h"
#include "widgets/look/framepainter.h"

#include <QTest>

namespace tst_ruler {

using namespace pixelplumb;

/// Steps and ticks of the rulers, and lines cut off at a border.
class TestRuler : public QObject {
    Q_OBJECT

private slots:
    void rulerStepsAreOneTwoFive_data()
    {
        QTest::addColumn<double>("pixelLength");
        QTest::addColumn<std::int64_t>("step");
        QTest::newRow("64 a pixel") << 64.0 << std::int64_t(1);
        QTest::newRow("40 a pixel") << 40.0 << std::int64_t(1);
        QTest::newRow("39 a pixel") << 39.0 << std::int64_t(2);
        QTest::newRow("8 a pixel") << 8.0 << std::int64_t(5);
        QTest::newRow("7 a pixel") << 7.0 << std::int64_t(10);
        QTest::newRow("a tenth a pixel") << 0.1 << std::int64_t(500);
    }
    void rulerStepsAreOneTwoFive()
    {
        QFETCH(double, pixelLength);
        QFETCH(std::int64_t, step);
        QCOMPARE(rulerStep(pixelLength, 40), step);
    }

    void rulerTicksStandOnTheirMultiples()
    {
        // Labels every 20 px (20·2 ≥ 40), ticks every 2 px (2·2 ≥ 4): 5 would miss the label at
        // −20.
        const std::vector<RulerTick> ticks = rulerTicks(-21.5, -15, 2, 40, 4);
        const std::vector<RulerTick> expected{
            {-20, TickKind::Labelled}, {-18, TickKind::Plain}, {-16, TickKind::Plain}};
        QCOMPARE(ticks, expected);
    }

    void linesAreClippedToARectangle_data()
    {
        QTest::addColumn<QLineF>("line");
        QTest::addColumn<bool>("visible");
        QTest::addColumn<QLineF>("expected");
        QTest::newRow("inside") << QLineF(1, 1, 9, 9) << true << QLineF(1, 1, 9, 9);
        QTest::newRow("through") << QLineF(-10, 5, 1e9, 5) << true << QLineF(0, 5, 10, 5);
        QTest::newRow("over a corner") << QLineF(-5, 5, 5, 15) << true << QLineF(0, 10, 0, 10);
        QTest::newRow("beside") << QLineF(-5, -1, 20, -1) << false << QLineF();
        QTest::newRow("a point inside") << QLineF(3, 3, 3, 3) << true << QLineF(3, 3, 3, 3);
    }
    void linesAreClippedToARectangle()
    {
        QFETCH(QLineF, line);
        QFETCH(bool, visible);
        QFETCH(QLineF, expected);
        const std::optional<QLineF> part = clipped(line, QRectF(0, 0, 10, 10));
        QCOMPARE(part.has_value(), visible);
        if (visible)
            QCOMPARE(*part, expected);
    }
};

PIXELPLUMB_TEST(TestRuler)

} // namespace tst_ruler

#include "tst_ruler.moc"
