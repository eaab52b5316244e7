// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layermoment.h"
#include "core/methods/method.h"
#include "core/runs/explain/edgename.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/explain/pixelhistory.h"
#include "tests/support/scanning.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QRegularExpression>
#include <QTest>

namespace tst_refusals {

using namespace pixelplumb;

namespace {

/// Twice the signed area of the triangle a, b, p in square lattice units: 0 if p lies on the line
/// through a and b.
Int128 crossOf(const LatticePoint &a, const LatticePoint &b, const LatticePoint &p)
{
    return Int128(b.x - a.x) * (p.y - a.y) - Int128(b.y - a.y) * (p.x - a.x);
}

/// How often a ray to the left of (x, y) meets the contours, and how many more times downward than
/// upward: 1 inside a counter-clockwise contour. Under the top-left rule the sample is displaced a
/// little to the right and then a little down.
struct Crossings {
    int count = 0;
    int winding = 0;
};
Crossings crossingsLeftOf(const Shape &polygon, std::int64_t x, std::int64_t y)
{
    Crossings crossings;
    std::vector<std::size_t> starts = {0};
    starts.insert(starts.end(), polygon.laterContours.begin(), polygon.laterContours.end());
    starts.push_back(polygon.vertices.size());
    const LatticePoint sample = latticePixel(x, y);
    for (std::size_t contour = 0; contour + 1 < starts.size(); ++contour) {
        const std::size_t first = starts[contour];
        const std::size_t size = starts[contour + 1] - first;
        for (std::size_t i = 0; i < size; ++i) {
            const LatticePoint &a = polygon.vertices[first + i].position;
            const LatticePoint &b = polygon.vertices[first + (i + 1) % size].position;
            const bool isUpward = a.y < b.y;
            const LatticePoint &low = isUpward ? a : b;
            const LatticePoint &high = isUpward ? b : a;
            // Displaced down: a row through an end counts the edge that comes from below.
            if (!(low.y < sample.y && sample.y <= high.y))
                continue;
            if (crossOf(low, high, sample) > 0)
                continue; // the edge is to the right
            ++crossings.count;
            crossings.winding += isUpward ? -1 : 1;
        }
    }
    return crossings;
}

Shape square(int left, int bottom, int side)
{
    Shape polygon;
    polygon.kind = PrimitiveKind::Polygon;
    polygon.fill = ShapeFill::EvenOdd;
    for (const auto &[x, y] :
         {std::pair(left, bottom), std::pair(left + side, bottom),
          std::pair(left + side, bottom + side), std::pair(left, bottom + side)})
        polygon.vertices.push_back({latticePixel(x, y), {}});
    return polygon;
}

/// A pentagram, whose centre is enclosed twice, and a square with a hole.
Scene polygonScene(ShapeFill fill)
{
    Shape star = square(0, 0, 1);
    star.fill = fill;
    star.vertices.clear();
    for (const auto &[x, y] : {std::pair(3, 2), std::pair(10, 21), std::pair(17, 2),
                               std::pair(1, 14), std::pair(19, 14)})
        star.vertices.push_back({latticePixel(x, y), {}});
    Shape frame = square(20, 1, 10);
    frame.fill = fill;
    frame.laterContours = {4};
    // The hole's opposite winding removes it by winding number as well as by parity.
    for (const auto &[x, y] :
         {std::pair(23, 4), std::pair(23, 8), std::pair(27, 8), std::pair(27, 4)})
        frame.vertices.push_back({latticePixel(x, y), {}});
    Scene scene;
    scene.frame.width = 32;
    scene.frame.height = 24;
    scene.method = "polygon-parity";
    scene.settings.fillRule = FillRule::TopLeft;
    scene.shapes = {star, frame};
    return scene;
}

/// The sentence about each refused sample, and the sample's position.
struct Refusal {
    std::size_t primitive = 0;
    SampleRecord sample;
    QString sentence;
};
std::vector<Refusal> refusalsOf(const TracedScene &traced)
{
    std::vector<Refusal> refusals;
    for (std::size_t index = 0; index < traced.trace->stepCount(); ++index) {
        const TraceStep step = traced.trace->stepAt(index);
        if (step.kind != StepKind::Sample)
            continue;
        const SampleRecord sample = traced.trace->samples(
            step.span)[step.sample - traced.trace->firstSampleOf(step.span)];
        if (sample.fate != SampleFate::Written)
            refusals.push_back({step.primitive, sample, explainStep(traced, index).sentence});
    }
    return refusals;
}

} // namespace

/// What is said about samples that a method refuses, against independently computed facts.
class TestRefusals : public QObject {
    Q_OBJECT

private slots:
    void aPolygonsRefusalTellsItsCrossings_data()
    {
        QTest::addColumn<ShapeFill>("fill");
        QTest::newRow("even-odd") << ShapeFill::EvenOdd;
        QTest::newRow("non-zero") << ShapeFill::NonZero;
    }
    void aPolygonsRefusalTellsItsCrossings()
    {
        QFETCH(ShapeFill, fill);
        const auto traced = traceScene(polygonScene(fill));

        const std::vector<Refusal> refusals = refusalsOf(*traced);
        QVERIFY(refusals.size() > 20);
        for (const Refusal &refusal : refusals) {
            const Crossings crossings = crossingsLeftOf(traced->primitives.shape(refusal.primitive),
                                                        refusal.sample.x, refusal.sample.y);
            const QString count
                = crossings.count == 1 ? u"once"_s : u"%1 times"_s.arg(crossings.count);
            QVERIFY2(refusal.sentence.contains(u"contours %1"_s.arg(count)),
                     qPrintable(refusal.sentence));
            if (fill == ShapeFill::EvenOdd) {
                QCOMPARE(crossings.count % 2, 0);
                QVERIFY(refusal.sentence.contains(u"an even number, outside"_s));
            } else {
                QCOMPARE(crossings.winding, 0);
                QVERIFY(refusal.sentence.contains(u"winding number 0, outside"_s));
            }
        }
    }

    /// f(r) and f(a), as in the set-up.
    void theOffScreenPointsSideOfAnEdgeIsTold()
    {
        Scene scene;
        scene.method = "barycentric-off-screen";
        scene.settings.fillRule = FillRule::OffScreenPoint; // r = (−1, −1)
        scene.triangles
            = {triangleAtUnits(latticePixel(0, 0), latticePixel(6, 0), latticePixel(0, 6))};
        const auto traced = traceScene(scene);

        QCOMPARE(pixelHistory(*traced, 3, 0).front().reason,
                 u"The sample lies exactly on P₀P₁, and the rule off-screen-point "
                 "gives it to the other side: the edge's function is 6 at the off-screen "
                 "point (−1, −1) and −36 at the vertex that faces it; their product, −216, "
                 "is not above 0."_s);
        // On two edges, both of which face away from r.
        const QString corner = pixelHistory(*traced, 0, 0).front().reason;
        QVERIFY2(
            corner.startsWith(u"The sample lies exactly on P₀P₁, and the rule off-screen-point "
                              u"gives it to the other side: "),
            qPrintable(corner));
        QVERIFY2(
            corner.contains(u"; it lies exactly on P₂P₀, and the rule off-screen-point gives it "
                            u"to the other side: "),
            qPrintable(corner));
        const SetUpRecord setUp = traced->trace->setUp(0);
        const NamedNumbers numbers(traced->trace->numbers().setUp, setUp.cells);
        QCOMPARE(numbers[u"f_c"_s], Quantity::integer(-36));
    }

    void aSampleThatRoundingRefusesIsToldByWhichNumber()
    {
        Scene scene;
        scene.method = "barycentric-incremental";
        scene.settings.arithmetic = Arithmetic::Float64;
        scene.triangles
            = {triangleAtUnits(latticePixel(1, 1), latticePixel(31, 11), latticePixel(11, 28))};
        const auto traced = traceScene(scene);
        const PixelAttempt attempt = pixelHistory(*traced, 13, 5).front(); // on P0P1
        QVERIFY(!attempt.written && attempt.verdict.covered);
        QVERIFY2(
            attempt.reason.startsWith(
                u"Missing: the truth covers it, but the kernel refused the sample. Refused: γ = −")
                && attempt.reason.endsWith(u" is negative."),
            qPrintable(attempt.reason));
    }

    /// From (2, 10) to (12, 5): halfway between pixels in column 3, Bresenham's line goes down and
    /// the truth does not.
    void aPixelNextToALineShowsTheDecidingNumber()
    {
        const auto traced
            = traceScene(sceneOf(lineAt(2, 10, 12, 5), "line-bresenham", frameOf(16, 12)));
        const QString decided = u" Column 3: p_k = 2Δy·x_k + 2Δx·y_k + c = "_s;
        const PixelAttempt missing = pixelHistory(*traced, 3, 10).front();
        QVERIFY(missing.verdict.covered);
        QVERIFY2(
            missing.reason.startsWith(u"Missing: the truth covers it, but the line's pixel here is "
                                      "another."_s
                                      + decided)
                && missing.reason.contains(u" = 0, a tie: step diagonally to the pixel (3, 9)"),
            qPrintable(missing.reason));
        const QString beside = pixelHistory(*traced, 3, 7).front().reason;
        QVERIFY2(beside.startsWith(u"The line does not cover it."_s + decided), qPrintable(beside));
    }

    void theExactLevelsBesideATriangleAreToldToBeItsPlanes()
    {
        Scene scene;
        scene.method = "midpoint-outline-fill";
        scene.triangles
            = {triangleAtUnits(latticePixel(1, 1), latticePixel(20, 8), latticePixel(3, 14))};
        const auto traced = traceScene(scene);
        int extra = 0;
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 22; ++x) {
                const PixelAttempt attempt = pixelHistory(*traced, x, y).front();
                if (!attempt.written || attempt.verdict.covered)
                    continue;
                QVERIFY2(attempt.reason.contains(u"the true levels are those of the triangle's "
                                                 u"plane outside of it"),
                         qPrintable(attempt.reason));
                ++extra;
            }
        }
        QVERIFY(extra > 0);
    }

    void aSampleOnAPolygonsEdgeIsToldThatTheRuleDecides()
    {
        Scene scene = polygonScene(ShapeFill::EvenOdd);
        Shape &polygon = scene.shapes.front();
        polygon.vertices
            = {{latticePixel(3, 1), {}}, {latticePixel(9, 5), {}}, {latticePixel(3, 11), {}}};
        scene.shapes.resize(1);
        for (const char *method :
             {"polygon-parity", "polygon-fan", "polygon-delaunay", "polygon-tessellation"}) {
            scene.method = method;
            const auto traced = traceScene(scene);
            QVERIFY2(pixelHistory(*traced, 6, 8)
                         .front()
                         .reason.endsWith(u" The sample lies exactly on edge 1, and the rule "
                                          "top-left leaves it outside."_s),
                     qPrintable(pixelHistory(*traced, 6, 8).front().reason));
            QVERIFY(!pixelHistory(*traced, 7, 8).front().reason.contains(u"exactly on"));
        }
    }

    void aPolygonsPixelTellsItsCrossings_data() { aPolygonsRefusalTellsItsCrossings_data(); }
    void aPolygonsPixelTellsItsCrossings()
    {
        QFETCH(ShapeFill, fill);
        const auto traced = traceScene(polygonScene(fill));
        for (std::size_t index = 0; index < traced->trace->stepCount(); ++index) {
            const TraceStep step = traced->trace->stepAt(index);
            if (step.kind != StepKind::Sample)
                continue;
            const SampleRecord sample = traced->trace->samples(
                step.span)[step.sample - traced->trace->firstSampleOf(step.span)];
            const Crossings crossings
                = crossingsLeftOf(traced->primitives.shape(step.primitive), sample.x, sample.y);
            const QString sentence = explainStep(*traced, index).sentence;
            // "… 2 times, at the edges 0 and 3: …"
            static const QRegularExpression edges(
                u"at the edges? ([0-9, and]+?)(:|, [0-9]+ downward)"_s);
            static const QRegularExpression number(u"\\d+"_s);
            const QString list = edges.match(sentence).captured(1);
            QCOMPARE(QString(list).split(number).size() - 1, qsizetype(crossings.count));
            if (sample.fate != SampleFate::Written)
                continue;
            QVERIFY2(sentence.startsWith(u"The ray from here to the left meets the contours"_s),
                     qPrintable(sentence));
            QVERIFY2(
                sentence.endsWith(fill == ShapeFill::EvenOdd
                                      ? u": an odd number, inside."_s
                                      : u": winding number %1, inside."_s.arg(
                                          QString::number(crossings.winding).replace(u'-', u'−'))),
                qPrintable(sentence));
        }
    }

    void aContourThatTurnsCounterClockwiseHasWindingNumberOne_data()
    {
        QTest::addColumn<FrameOrigin>("origin");
        QTest::addColumn<QString>("told");
        // The corners of square() ascend in x, then in y: counter-clockwise where y points up.
        QTest::newRow("y up") << FrameOrigin::BottomLeft
                              << u"1 downward, 0 upward: winding number 1, inside."_s;
        QTest::newRow("y down") << FrameOrigin::TopLeft
                                << u"0 downward, 1 upward: winding number −1, inside."_s;
    }
    void aContourThatTurnsCounterClockwiseHasWindingNumberOne()
    {
        QFETCH(FrameOrigin, origin);
        QFETCH(QString, told);
        Scene scene;
        scene.frame.origin = origin;
        scene.method = "polygon-parity";
        scene.settings.fillRule = FillRule::TopLeft;
        scene.shapes = {square(2, 2, 4)};
        scene.shapes[0].fill = ShapeFill::NonZero;
        const auto traced = traceScene(scene);

        std::size_t pixels = 0;
        for (std::size_t index = 0; index < traced->trace->stepCount(); ++index) {
            if (traced->trace->stepAt(index).kind != StepKind::Sample)
                continue;
            const QString sentence = explainStep(*traced, index).sentence;
            QVERIFY2(sentence.endsWith(told), qPrintable(sentence));
            ++pixels;
        }
        QCOMPARE(pixels, std::size_t(16));
    }

    void aPolygonsRowTellsItsCrossings()
    {
        const auto traced = traceScene(polygonScene(ShapeFill::EvenOdd));
        for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
            const SpanRecord record = traced->trace->span(span);
            const Crossings all = crossingsLeftOf(traced->primitives.shape(record.primitive), 1000,
                                                  record.place.coordinate);
            const QString sentence
                = explainStep(*traced, traced->trace->indexOfSpan(span)).sentence;
            QVERIFY2(sentence.startsWith(u"The row crosses %1 edges, at x = "_s.arg(all.count)),
                     qPrintable(sentence));
        }
    }

    void aTrianglesRefusalTellsTheTestThatFails_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<FillRule>("rule");
        for (const Method &method : methods()) {
            if (!method.draws(PrimitiveKind::Triangle) || !method.supports(Arithmetic::Exact))
                continue;
            for (const FillRule rule : method.fillRules)
                QTest::addRow("%s, %s", qPrintable(method.id), std::string(nameOf(rule)).c_str())
                    << method.id << rule;
        }
    }
    void aTrianglesRefusalTellsTheTestThatFails()
    {
        QFETCH(QString, method);
        QFETCH(FillRule, rule);
        Scene scene;
        scene.frame.width = scene.frame.height = 12;
        scene.method = method.toStdString();
        scene.settings.fillRule = rule;
        // Two triangles share an edge whose line passes through (−1, −1); many samples lie on
        // edges.
        scene.triangles = {triangleAt(1, 1, 9, 9, 9, 1), triangleAt(1, 1, 9, 9, 1, 9)};
        const auto traced = traceScene(scene);

        for (const Refusal &refusal : refusalsOf(*traced)) {
            const Triangle &triangle = traced->primitives.triangles[refusal.primitive];
            const LatticePoint sample = latticePixel(refusal.sample.x, refusal.sample.y);
            bool isBeyond = false;
            QStringList edgesThroughIt;
            bool isOnDiagonal = false;
            const Int128 turn
                = crossOf(triangle.vertices[0].position, triangle.vertices[1].position,
                          triangle.vertices[2].position);
            for (int from = 0; from < 3; ++from) {
                const int to = (from + 1) % 3;
                const LatticePoint &a = triangle.vertices[std::size_t(from)].position;
                const LatticePoint &b = triangle.vertices[std::size_t(to)].position;
                const Int128 side = crossOf(a, b, sample) * (turn > 0 ? 1 : -1);
                isBeyond = isBeyond || side < 0;
                if (side != 0)
                    continue;
                edgesThroughIt += edgeName(traced->trace->setUp(refusal.primitive), from, to);
                isOnDiagonal = isOnDiagonal || crossOf(a, b, latticePixel(-1, -1)) == 0;
            }
            const QByteArray told = refusal.sentence.toUtf8();
            // Beyond ab, Cramer's rule has u + v above 1.
            QCOMPARE(refusal.sentence.contains(u"negative"_s)
                         || refusal.sentence.contains(u"is above 1"_s),
                     isBeyond);
            if (isBeyond)
                continue;
            static const QRegularExpression named(u"exactly on (\\S+),"_s);
            const QString edge = named.match(refusal.sentence).captured(1);
            QVERIFY2(edgesThroughIt.contains(edge), told.constData());
            const bool isOwnedByNobody
                = rule == FillRule::Open || (rule == FillRule::OffScreenPoint && isOnDiagonal);
            const bool isNobodys = refusal.sentence.contains(u"neither side"_s);
            QVERIFY2(isNobodys == isOwnedByNobody || edgesThroughIt.size() > 1, told.constData());
        }
    }

    void aSampleInAHoleIsToldByItsParityOrWindingNumber_data()
    {
        QTest::addColumn<ShapeFill>("fill");
        QTest::addColumn<QString>("told");
        QTest::newRow("parity") << ShapeFill::EvenOdd
                                << u"2 times, at the edges 3 and 4: an even number"_s;
        QTest::newRow("winding number") << ShapeFill::NonZero << u"winding number 0"_s;
    }
    void aSampleInAHoleIsToldByItsParityOrWindingNumber()
    {
        QFETCH(ShapeFill, fill);
        QFETCH(QString, told);
        const auto traced = traceScene(polygonScene(fill));

        const QString inHole = pixelHistory(*traced, 25, 6)[1].reason;
        QVERIFY2(inHole.contains(told), qPrintable(inHole));
        const QString beside = pixelHistory(*traced, 31, 6)[1].reason;
        QVERIFY2(beside.startsWith(
                     u"The polygon does not cover it. Row 6: The row crosses 4 edges, at x = 20, "
                     "23, 27 and 30."_s),
                 qPrintable(beside));
    }

    void aRefusedSampleHasTheNearestSpanOfItsRow()
    {
        Scene scene = polygonScene(ShapeFill::NonZero);
        scene.method = "polygon-delaunay";
        scene.shapes = {square(2, 2, 8)};
        const auto traced = traceScene(scene);

        // On the right side, which the rule leaves out: of the second triangle, not the first.
        const PixelAttempt attempt = pixelHistory(*traced, 10, 5).front();
        QVERIFY(attempt.span);
        QCOMPARE(attempt.span->endSample, std::int64_t(10));
        QCOMPARE(attempt.span->upper, Quantity::integer(10));
        QCOMPARE(pixelHistory(*traced, 0, 5).front().span->firstSample, std::int64_t(2));

        // On edge 1, where the row of the second triangle ends without a sample.
        Shape narrow = square(0, 0, 1);
        narrow.vertices.clear();
        for (const auto &[x, y] :
             {std::pair(4, 5), std::pair(4, 0), std::pair(7, 6), std::pair(6, 5)})
            narrow.vertices.push_back({latticePixel(x, y), {}});
        scene.shapes = {narrow};
        const auto other = traceScene(scene);
        QCOMPARE(pixelHistory(*other, 5, 2).front().span->upper, Quantity::integer(5));
    }

    void edgesHaveTheNamesOfTheMethodsOwnOrder()
    {
        Scene scene;
        scene.triangles = {triangleAt(9, 9, 1, 1, 5, 20)};
        const auto sorted = traceScene(scene);
        scene.method = "edge-equations";
        const auto plain = traceScene(scene);

        // By x: P₀ = (1, 1), P₁ = (5, 20), P₂ = (9, 9).
        QCOMPARE(edgeName(sorted->trace->setUp(0), 0, 1), u"L₀₂"_s);
        QCOMPARE(edgeName(sorted->trace->setUp(0), 1, 2), u"L₀₁"_s);
        QCOMPARE(edgeName(sorted->trace->setUp(0), 2, 0), u"L₁₂"_s);
        QCOMPARE(vertexName(sorted->trace->setUp(0), 0), u"P₂"_s);
        QCOMPARE(edgeName(plain->trace->setUp(0), 0, 1), u"P₀P₁"_s);
        QCOMPARE(edgeName(plain->trace->setUp(0), 2, 0), u"P₂P₀"_s);
        QVERIFY(pixelHistory(*sorted, 7, 2)[0].reason.contains(u"L₀₂"_s));
        QVERIFY(pixelHistory(*plain, 7, 2)[0].reason.contains(u"P₀P₁"_s));
    }
};

PIXELPLUMB_TEST(TestRefusals)

} // namespace tst_refusals

#include "tst_refusals.moc"
