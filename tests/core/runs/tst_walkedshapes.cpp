// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/pixelhistory.h"
#include "core/runs/tracedscene.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <cstdlib>
#include <map>

namespace tst_walkedshapes {

using namespace pixelplumb;

namespace {

/// The reasons of the pixels that a run rightly leaves alone.
std::map<std::pair<int, int>, QString> refusalsOf(const Scene &scene)
{
    std::map<std::pair<int, int>, QString> reasons;
    const auto traced = traceScene(scene);
    const FrameSpec &frame = scene.frame;
    for (int x = frame.firstColumn; x < frame.firstColumn + frame.width; ++x) {
        for (int y = frame.firstRow; y < frame.firstRow + frame.height; ++y) {
            const PixelAttempt attempt = pixelAttempt(*traced, 0, x, y);
            if (!attempt.written && !attempt.verdict.covered)
                reasons[{x, y}] = attempt.reason;
        }
    }
    return reasons;
}

Shape withKind(PrimitiveKind kind, ShapeFill fill)
{
    Shape shape = bezierAt({latticePixel(3, 3), latticePixel(11, 4), latticePixel(7, 11)});
    shape.kind = kind;
    shape.fill = fill;
    return shape;
}

} // namespace

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
        QVERIFY2(reason.startsWith(u"The %1 does not cover it. "_s.arg(nameOf(shape.kind))),
                 qPrintable(reason));
        QVERIFY2(reason.contains(told), qPrintable(reason));
    }

    void everyRefusalHasAReason_data()
    {
        QTest::addColumn<Shape>("shape");
        QTest::addColumn<QByteArray>("method");
        const auto add = [](const Shape &shape, const std::vector<const char *> &methods) {
            for (const char *method : methods)
                QTest::addRow("%s of %s", qPrintable(nameOf(shape.kind)), method)
                    << shape << QByteArray(method);
        };
        add(lineAt(3, 3, 11, 7),
            {"line-dda", "line-slope-intercept", "line-parametric", "line-bresenham",
             "line-bresenham-symmetric", "stroke-coverage"});
        for (const Shape &round : {circleAt(8, 8, 4), ellipseAtUnits({2000, 1900}, 1100, 600)})
            add(round,
                {"circle-midpoint", "circle-explicit", "circle-parametric", "stroke-coverage"});
        add(circleAt(8, 8, 4, ShapeFill::NonZero), {"circle-fill"});
        add(withKind(PrimitiveKind::Bezier, ShapeFill::Outline),
            {"bezier-subdivision", "stroke-coverage"});
        add(withKind(PrimitiveKind::Bezier, ShapeFill::EvenOdd), {"bezier-fill"});
        add(withKind(PrimitiveKind::Polygon, ShapeFill::NonZero),
            {"polygon-parity", "polygon-fan", "polygon-delaunay", "polygon-tessellation"});
        add(withKind(PrimitiveKind::Polygon, ShapeFill::Outline), {"polygon-outline"});
        add(withKind(PrimitiveKind::Point, ShapeFill::Outline), {"point-address"});
    }
    void everyRefusalHasAReason()
    {
        QFETCH(Shape, shape);
        QFETCH(QByteArray, method);
        const auto refusals = refusalsOf(sceneOf(shape, method.constData(), frameOf(16, 16)));
        QVERIFY(refusals.size() > 100);
        for (const auto &[pixel, reason] : refusals)
            QVERIFY2(!reason.isEmpty() && !reason.endsWith(u"does not cover it."_s),
                     qPrintable(u"(%1, %2) %3"_s.arg(pixel.first).arg(pixel.second).arg(reason)));
    }

    void whereNothingPassesTheRowOrColumnIsToldWhatDoes_data()
    {
        QTest::addColumn<Shape>("shape");
        QTest::addColumn<QByteArray>("method");
        QTest::addColumn<QSize>("size");
        QTest::addColumn<QPoint>("pixel");
        QTest::addColumn<QString>("told");
        const auto add = [](const Shape &shape, const char *method, const QSize &size,
                            const QPoint &pixel, const char *told) {
            QTest::newRow(told) << shape << QByteArray(method) << size << pixel
                                << QString::fromUtf8(told);
        };
        // On its row 2 the line is at x = −1.
        add(lineAt(-1, 2, 3, 6), "line-dda", {8, 4}, {6, 0},
            "no step on the row 0: in the frame it has steps on the row 3.");
        add(lineAtUnits({2048, 896}, {3200, -1024}), "line-bresenham", {9, 8}, {1, 6},
            "no step on the row 6: in the frame it has steps on the row 4.");
        add(lineAt(3, 6, -1, 2), "line-slope-intercept", {8, 4}, {6, 0},
            "no step on the column 6: in the frame it has steps on the column 0.");
        const Shape disc = circleAt(5, 5, 4, ShapeFill::NonZero);
        add(disc, "circle-fill", {12, 12}, {11, 0},
            "The row 0 does not meet the circle, which meets the frame's rows 1 … 9.");
        add(disc, "circle-fill", {12, 12}, {11, 5},
            " Row 5: the row's bounds 1 and 9 give the samples 1 … 9.");
        add(circleAt(5, 5, 4), "circle-explicit", {12, 12}, {11, 5},
            "The column 11 does not meet the circle, which meets the frame's columns 1 … 9.");
        const Shape polygon = withKind(PrimitiveKind::Polygon, ShapeFill::EvenOdd);
        add(polygon, "polygon-parity", {16, 16}, {5, 1},
            "does not cover it. The row 1 crosses none of its edges.");
        add(polygon, "polygon-fan", {16, 16}, {5, 14}, "The row 14 crosses none of its triangles.");
        add(polygon, "polygon-fan", {16, 16}, {1, 7},
            " Row 7, triangle 0: the row's bounds 5 and ");
        add(withKind(PrimitiveKind::Point, ShapeFill::Outline), "point-address", {16, 16}, {4, 3},
            " Step 0: The point is nearest to the pixel (3, 3), whose address is 51.");
    }
    void whereNothingPassesTheRowOrColumnIsToldWhatDoes()
    {
        QFETCH(Shape, shape);
        QFETCH(QByteArray, method);
        QFETCH(QSize, size);
        QFETCH(QPoint, pixel);
        QFETCH(QString, told);
        const auto refusals
            = refusalsOf(sceneOf(shape, method.constData(), frameOf(size.width(), size.height())));
        const QString reason = refusals.at({pixel.x(), pixel.y()});
        QVERIFY2(reason.contains(told), qPrintable(reason));
    }

    /// The explicit form goes from column to column, so that no other column decides.
    void besideTheExplicitFormThePixelsColumnDecides()
    {
        std::size_t inside = 0;
        for (const auto &[pixel, reason] :
             refusalsOf(sceneOf(circleAt(5, 5, 4), "circle-explicit", frameOf(12, 12)))) {
            if (std::abs(pixel.first - 5) > 4)
                continue;
            ++inside;
            QVERIFY2(reason.count(u"On the column "_s) == 1
                         && reason.contains(u"On the column %1 the curve"_s.arg(pixel.first)),
                     qPrintable(reason));
        }
        QVERIFY(inside > 20);
    }
};

PIXELPLUMB_TEST(TestWalkedShapes)

} // namespace tst_walkedshapes

#include "tst_walkedshapes.moc"
