// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/pixelhistory.h"
#include "core/runs/tracedscene.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_walkedshapes {

using namespace pixelplumb;

/// For a pixel that a walk along a shape left out, the panel names the step that passed it, with
/// its numbers.
class TestWalkedShapes : public QObject {
    Q_OBJECT

private slots:
    void aPixelBesideAWalkTellsTheStepsNextToIt_data()
    {
        QTest::addColumn<Shape>("shape");
        QTest::addColumn<QByteArray>("method");
        QTest::addColumn<QPoint>("pixel");
        QTest::addColumn<QString>("told");
        // Radius 5 about (8, 8), F(x, y) = x² + y² − 25 from the centre.
        const auto circle = [](const char *name, const QPoint &pixel, const char *told) {
            QTest::newRow(name) << circleAt(8, 8, 5) << QByteArray("circle-midpoint") << pixel
                                << QString::fromUtf8(told);
        };
        circle("below the top", QPoint(8, 12), "Step 0: The arc starts at (x_k, y_k) = (0, 5)");
        circle("F(2, 4 1/2) = −3/4", QPoint(10, 12), "Step 2: p_k = −3/4 < 0");
        circle("F(4, 3 1/2) = 3 1/4", QPoint(12, 12), "Step 4: p_k = 3 1/4 > 0");
        circle("mirrored", QPoint(4, 4), "Step 4: p_k = 3 1/4 > 0");
        circle("next to none", QPoint(8, 9), "Step 0: The arc starts at (x_k, y_k) = (0, 5)");
        // At t = 1/8 the line is at (2, 1½), half a pixel above.
        QTest::newRow("below a tie of P(t)")
            << lineAt(1, 1, 9, 5) << QByteArray("line-parametric") << QPoint(2, 1)
            << "Step 1: At t = 1/8 the line is at (2, 1 1/2), which rounds to the pixel (2, 2).";
        QTest::newRow("far above P(t)")
            << lineAt(1, 1, 9, 5) << QByteArray("line-parametric") << QPoint(1, 7)
            << "Step 3: At t = 3/8 the line is at (4, 2 1/2), which rounds to the pixel (4, 3).";
        // (1, 1), (4, 14), (14, 2): at t = 1/2 the curve is at (5¾, 7¾).
        const Shape curve
            = bezierAt({latticePixel(1, 1), latticePixel(4, 14), latticePixel(14, 2)});
        QTest::newRow("beside a curve") << curve << QByteArray("bezier-subdivision") << QPoint(6, 9)
                                        << "It has the pixel (6, 8).";
        QTest::newRow("far from a curve")
            << curve << QByteArray("bezier-subdivision") << QPoint(6, 15) << "It has the pixel (";
    }
    void aPixelBesideAWalkTellsTheStepsNextToIt()
    {
        QFETCH(Shape, shape);
        QFETCH(QByteArray, method);
        QFETCH(QPoint, pixel);
        QFETCH(QString, told);
        const auto traced = traceScene(sceneOf(shape, method.constData(), frameOf(16, 16)));
        const QString reason = pixelHistory(*traced, pixel.x(), pixel.y()).front().reason;
        QVERIFY2(
            reason.startsWith(QStringLiteral("The %1 does not cover it. ").arg(nameOf(shape.kind))),
            qPrintable(reason));
        QVERIFY2(reason.contains(told), qPrintable(reason));
    }
};

PIXELPLUMB_TEST(TestWalkedShapes)

} // namespace tst_walkedshapes

#include "tst_walkedshapes.moc"
