// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/scenes/trianglepictures.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_triangletraces {

using namespace pixelplumb;

namespace {

Scene tracedSceneOf(const QString &id, const ScanSettings &settings)
{
    Scene scene;
    scene.frame.width = 20;
    scene.frame.height = 16;
    scene.frame.firstColumn = -3;
    scene.frame.firstRow = 2;
    scene.method = id.toStdString();
    scene.settings = settings;
    scene.triangles
        = {triangleOf({{{0, 1000}, {4100, 700}, {1500, 4000}}}),
           triangleOf({{latticePixel(-9, 3), latticePixel(30, 8), latticePixel(4, 40)}}),
           triangleOf({{latticePixel(2, 2), latticePixel(6, 6), latticePixel(4, 4)}}),
           triangleOf({{latticePixel(90, 2), latticePixel(96, 6), latticePixel(94, 9)}}),
           triangleOf({{latticePixel(5, 3), latticePixel(11, 3), latticePixel(8, 9)}})};
    return scene;
}

} // namespace

/// The traces of the triangle methods: drawing and explaining are the same code.
class TestTriangleTraces : public QObject {
    Q_OBJECT

private slots:
    void theSamplesOfAnEdgePixelStandInItsColumn_data()
    {
        QTest::addColumn<QString>("id");
        for (const Method *method : triangleMethods()) {
            if (method->supports(Effect::Antialiasing))
                QTest::newRow(qPrintable(method->id)) << method->id;
        }
    }
    void theSamplesOfAnEdgePixelStandInItsColumn()
    {
        QFETCH(QString, id);
        Scene scene = tracedSceneOf(id, {});
        scene.appearance.antialiasing = Antialiasing::Samples4;
        // The left edge passes between the centre and the outermost sample of a column.
        scene.triangles = {triangleOf({{{90, 600}, {90, 3000}, {1500, 1800}}})};
        const auto traced = traceScene(scene);
        const ScanTrace &trace = *traced->trace;
        std::size_t unbounded = 0;
        for (std::size_t span = 0; span < trace.spanCount(); ++span) {
            const std::int64_t x = trace.placeOf(span).coordinate;
            for (const SampleRecord &sample : trace.samples(span))
                QCOMPARE(sample.x, x);
            if (span > 0 && trace.primitiveOf(span - 1) == trace.primitiveOf(span))
                QVERIFY(trace.placeOf(span - 1).coordinate <= x);
            // Only off-centre samples reach the column: no edge meets it.
            if (trace.span(span).lower.isNone()) {
                ++unbounded;
                QVERIFY(trace.spanWords(span).sentence.startsWith(u"Only samples"_s));
            }
        }
        QVERIFY(unbounded > 0);
    }

    void barycentricOverAllPixelsVisitsThemAll()
    {
        const Scene scene = tracedSceneOf(u"barycentric-all"_s, {});
        const auto traced = traceScene(scene);
        QCOMPARE(traced->trace->sampleCount(), std::size_t(5 * 20 * 16));
    }

    void rowWalkSwitchesInTheThirdEdgeAtTheMiddleVertex()
    {
        Scene scene;
        scene.method = "row-walk";
        scene.triangles
            = {triangleOf({{latticePixel(2, 1), latticePixel(20, 11), latticePixel(9, 31)}})};
        const auto traced = traceScene(scene);
        const SetUpRecord setUp = traced->trace->setUp(0);
        QCOMPARE(setUp.order, (std::array<int, 3>{2, 1, 0}));
        QCOMPARE(setUp.longEdge, LongEdge::Below);
        QCOMPARE(traced->trace->spanCount(), std::size_t(31));
        for (std::size_t span = 0; span < 31; ++span) {
            const SpanPlace &place = traced->trace->placeOf(span);
            QCOMPARE(place.axis, SpanAxis::Row);
            QCOMPARE(place.coordinate, 31 - std::int64_t(span));
            QCOMPARE(place.part, place.coordinate > 11 ? 0 : 1);
        }
    }

    void rowWalkEntersNoRowsOutsideItsFrameAndRefusesInFixed16WhatDoesNotFit()
    {
        Scene scene;
        scene.method = "row-walk";
        scene.frame.width = 8;
        scene.frame.height = 8;
        scene.triangles = {triangleOf(
            {{latticePixel(-40000, -40000), latticePixel(40000, -7), latticePixel(0, 40000)}})};
        QCOMPARE(traceScene(scene)->trace->spanCount(), std::size_t(8));
        scene.settings.arithmetic = Arithmetic::Fixed16;
        QCOMPARE(traceScene(scene)->trace->setUp(0).rejection,
                 PrimitiveRejection::NotRepresentable);
    }

    void constantRateScanKeepsSliversColoursWithinTheirRange()
    {
        // A sliver on which the assignment's ΔR blows up in float32.
        Scene scene;
        scene.frame.width = 256;
        scene.frame.height = 224;
        scene.settings.arithmetic = Arithmetic::Float32;
        scene.triangles = {
            triangleOf({{latticePixel(0, 138), latticePixel(181, 198), latticePixel(255, 223)}})};
        scene.method = "column-scan";
        const auto literal = traceScene(scene);
        scene.method = "column-scan-constant-rate";
        const auto stable = traceScene(scene);
        QVERIFY(literal->trace->spanCount() == stable->trace->spanCount());
        const auto rateOf = [](const TracedScene &traced, std::size_t span) {
            const auto &columns = traced.method->numbers.span;
            for (std::size_t i = 0; i < columns.size(); ++i) {
                if (columns[i].title == u"ΔR"_s)
                    return traced.trace->span(span).cells[i].toDouble();
            }
            return 0.0;
        };
        const double exact
            = oracle::columnAt(scene.triangles[0], FillRule::Closed, 100)->colourRate[0].toDouble();
        double literalError = 0, stableError = 0;
        for (std::size_t span = 0; span < stable->trace->spanCount(); ++span) {
            literalError = std::max(literalError, std::abs(rateOf(*literal, span) - exact));
            stableError = std::max(stableError, std::abs(rateOf(*stable, span) - exact));
        }
        QVERIFY2(stableError < 1e-6 * std::abs(exact), qPrintable(QString::number(stableError)));
        QVERIFY2(literalError > 0.1 * std::abs(exact), qPrintable(QString::number(literalError)));
    }
};

PIXELPLUMB_TEST(TestTriangleTraces)

} // namespace tst_triangletraces

#include "tst_triangletraces.moc"
