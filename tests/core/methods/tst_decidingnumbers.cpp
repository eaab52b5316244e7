// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/words/formulatext.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/explain/pixelhistory.h"
#include "core/runs/explain/stepmoment.h"
#include "core/runs/tracedscene.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_decidingnumbers {

using namespace pixelplumb;

namespace {

/// a, b, c or P₀, P₁, P₂, clockwise where y points upward, so the slides' sides must be exchanged.
Scene slideTriangle(const char *method, FillRule rule = FillRule::Closed)
{
    Scene scene;
    scene.frame = frameOf(12, 10);
    scene.triangles = {Triangle{{{{latticePixel(2, 1), {{255, 0, 0}}},
                                  {latticePixel(9, 2), {{0, 255, 0}}},
                                  {latticePixel(3, 8), {{0, 0, 255}}}}}}};
    scene.method = method;
    scene.settings.fillRule = rule;
    return scene;
}

Quantity numberOf(const std::vector<NumberDescription> &numbers, const std::vector<Quantity> &cells,
                  const char *title)
{
    const auto found
        = std::ranges::find(numbers, QString::fromUtf8(title), &NumberDescription::title);
    return found == numbers.end() ? Quantity() : cells[std::size_t(found - numbers.begin())];
}

Quantity inSetUp(const TracedScene &traced, const char *title)
{
    return numberOf(traced.trace->numbers().setUp, traced.trace->setUp(0).cells, title);
}
Quantity inSpan(const TracedScene &traced, std::size_t span, const char *title)
{
    return numberOf(traced.trace->numbers().span, traced.trace->span(span).cells, title);
}

/// The index of the line of an explanation that works out this number, or −1.
qsizetype placeOf(const Explanation &explanation, const char *title)
{
    const auto found = std::ranges::find_if(explanation.lines, [title](const FormulaLine &line) {
        return line.symbols.startsWith(QString::fromUtf8(title) + u" = "_s);
    });
    return found == explanation.lines.end() ? -1 : found - explanation.lines.begin();
}

} // namespace

/// Wherever a slide decides, the deciding number is shown. Values by hand.
class TestDecidingNumbers : public QObject {
    Q_OBJECT

private slots:
    void anEdgesSidesAreTestedBeforeTheyAreExchanged()
    {
        const auto traced = traceScene(slideTriangle("edge-equations"));
        const Explanation setUp = explainStep(*traced, 0);

        // 1·3 − 7·8 + 5: P₂ is on the negative side of P₀P₁.
        QCOMPARE(inSetUp(*traced, "sidedness₀"), Quantity::integer(-48));
        QCOMPARE(inSetUp(*traced, "s₀"), Quantity::integer(-1));
        QCOMPARE(inSetUp(*traced, "a₀"), Quantity::integer(-1));
        QCOMPARE(inSetUp(*traced, "F₀"), Quantity::integer(48));
        const qsizetype side = placeOf(setUp, "sidedness₀");
        const qsizetype sign = placeOf(setUp, "s₀");
        QVERIFY(side >= 0 && side < sign && sign < placeOf(setUp, "a₀"));
        const FormulaLine &sided = setUp.lines[std::size_t(side)];
        QCOMPARE(sided.symbols, u"sidedness₀ = (y₁ − y₀)·x₂ + (x₀ − x₁)·y₂ + (x₁·y₀ − x₀·y₁)"_s);
        QCOMPARE(sided.substituted, u"(2 − 1)·3 + (2 − 9)·8 + (9·1 − 2·2)"_s);
        QCOMPARE(setUp.lines[std::size_t(sign)].substituted, u"−1 if (−48) < 0, else 1"_s);

        Scene turned = slideTriangle("edge-equations");
        std::swap(turned.triangles[0].vertices[1], turned.triangles[0].vertices[2]);
        QCOMPARE(inSetUp(*traceScene(turned), "s₀"), Quantity::integer(1));
    }

    void theOffScreenPointDecidesByNumbersThatAreShown_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QStringList>("titles");
        const QStringList lower
            = {u"f_bc(r)"_s, u"f_bc(a)·f_bc(r)"_s, u"f_ca(b)·f_ca(r)"_s, u"f_ab(c)·f_ab(r)"_s};
        QTest::newRow("off-screen") << u"barycentric-off-screen"_s << lower;
        QTest::newRow("incremental") << u"barycentric-incremental"_s << lower;
        QTest::newRow("relative") << u"barycentric-relative"_s << lower;
        QTest::newRow("Cramer's rule") << u"barycentric-cramer"_s
                                       << QStringList{u"f_bc(r)"_s, u"f_bc(A)·f_bc(r)"_s,
                                                      u"f_ca(B)·f_ca(r)"_s, u"f_ab(C)·f_ab(r)"_s};
    }
    void theOffScreenPointDecidesByNumbersThatAreShown()
    {
        QFETCH(QString, id);
        QFETCH(QStringList, titles);
        const auto traced = traceScene(slideTriangle(qPrintable(id), FillRule::OffScreenPoint));
        const auto number
            = [&](const QString &title) { return inSetUp(*traced, title.toUtf8().constData()); };

        // r = (−1, −1). f_bc = 6x + 6y − 66, f_ca = −7x + y + 13, f_ab = x − 7y + 5; each is −48 at
        // the opposite vertex.
        QCOMPARE(number(u"x_r"_s), Quantity::integer(-1));
        QCOMPARE(number(u"y_r"_s), Quantity::integer(-1));
        QCOMPARE(number(titles[0]), Quantity::integer(-78));
        QCOMPARE(number(titles[1]), Quantity::integer(-48 * -78));
        QCOMPARE(number(titles[2]), Quantity::integer(-48 * 19));
        QCOMPARE(number(titles[3]), Quantity::integer(-48 * 11));
        QCOMPARE(number(u"tie_bc"_s), Quantity::integer(1));
        QCOMPARE(number(u"tie_ca"_s), Quantity::integer(0));
        QCOMPARE(number(u"tie_ab"_s), Quantity::integer(0));
        const Explanation setUp = explainStep(*traced, 0);
        const qsizetype tie = placeOf(setUp, "tie_ca");
        QVERIFY(tie >= 0);
        QCOMPARE(setUp.lines[std::size_t(tie)].substituted, u"1 if (−912) > 0, else 0"_s);
    }

    /// One half of a square contains its smallest x and y, the other its largest: edges P₀P₁, P₁P₂
    /// and P₂P₀ are horizontal, slanting and vertical.
    void theListingSaysWhichEdgesOwnTheirSamples_data()
    {
        QTest::addColumn<FillRule>("rule");
        QTest::addColumn<FrameOrigin>("origin");
        QTest::addColumn<QString>("said");
        QTest::addColumn<std::vector<int>>("lower");
        QTest::addColumn<std::vector<int>>("upper");
        const auto add = [](FillRule rule, FrameOrigin origin, const char *said,
                            const std::vector<int> &lower, const std::vector<int> &upper) {
            QTest::addRow("%s, y %s", nameOf(rule).data(),
                          origin == FrameOrigin::TopLeft ? "down" : "up")
                << rule << origin << QString::fromUtf8(said) << lower << upper;
        };
        for (const FrameOrigin origin : {FrameOrigin::BottomLeft, FrameOrigin::TopLeft}) {
            add(FillRule::Closed, origin, "", {1, 1, 1}, {1, 1, 1});
            add(FillRule::Open, origin, "", {0, 0, 0}, {0, 0, 0});
            add(FillRule::HalfOpenColumn, origin,
                "tie₀ ← 1 if b₀ > 0, or b₀ = 0 and a₀ > 0, else 0; tie₁ and tie₂ likewise — an "
                "edge with the triangle at larger y, or an upright one with it at larger x",
                {1, 0, 1}, {0, 1, 0});
        }
        add(FillRule::TopLeft, FrameOrigin::BottomLeft,
            "tie₀ ← 1 if a₀ > 0, or a₀ = 0 and b₀ < 0, else 0; tie₁ and tie₂ likewise — a left "
            "edge, or a level one at the top",
            {0, 0, 1}, {1, 1, 0});
        add(FillRule::TopLeft, FrameOrigin::TopLeft,
            "tie₀ ← 1 if a₀ > 0, or a₀ = 0 and b₀ > 0, else 0; tie₁ and tie₂ likewise — a left "
            "edge, or a level one at the top",
            {1, 0, 1}, {0, 1, 0});
    }
    void theListingSaysWhichEdgesOwnTheirSamples()
    {
        QFETCH(FillRule, rule);
        QFETCH(FrameOrigin, origin);
        QFETCH(QString, said);
        QFETCH(std::vector<int>, lower);
        QFETCH(std::vector<int>, upper);
        Scene scene = slideTriangle("edge-equations", rule);
        scene.frame.origin = origin;
        const auto hasCorners = [&](const std::array<LatticePoint, 3> &corners,
                                    const std::vector<int> &owned) {
            for (std::size_t i = 0; i < corners.size(); ++i)
                scene.triangles[0].vertices[i].position = corners[i];
            const auto traced = traceScene(scene);
            QString read; // nothing where all edges are alike
            for (const PseudocodeLine &line : pseudocodeOf(*traced, 0)) {
                if (line.text.startsWith(u"tie"_s) && line.moments == std::vector{Moment::SetUp})
                    read += line.text;
            }
            QCOMPARE(read, said);
            QCOMPARE(inSetUp(*traced, "tie₀"), Quantity::integer(owned[0]));
            QCOMPARE(inSetUp(*traced, "tie₁"), Quantity::integer(owned[1]));
            QCOMPARE(inSetUp(*traced, "tie₂"), Quantity::integer(owned[2]));
        };
        hasCorners({latticePixel(2, 1), latticePixel(8, 1), latticePixel(2, 7)}, lower);
        hasCorners({latticePixel(8, 7), latticePixel(2, 7), latticePixel(8, 1)}, upper);
    }

    void noNumberOfThePointStandsUnderAnotherRule()
    {
        const auto traced = traceScene(slideTriangle("barycentric-rectangle", FillRule::TopLeft));
        QVERIFY(inSetUp(*traced, "x_r").isNone());
        QVERIFY(inSetUp(*traced, "f_bc(r)").isNone());
        const Explanation setUp = explainStep(*traced, 0);
        QCOMPARE(placeOf(setUp, "f_bc(r)"), qsizetype(-1));
        // f_a·a_bc = −48·6 < 0: the edge bc is a right one.
        QCOMPARE(setUp.lines[std::size_t(placeOf(setUp, "tie_bc"))].symbols,
                 u"tie_bc = 1 if f_a·a_bc > 0, else 0"_s);
        QCOMPARE(inSetUp(*traced, "tie_bc"), Quantity::integer(0));
    }

    /// No edge of the method decides, so the truth's edge is named as the truth's.
    void anOutlineTellsWhichPixelsOfItsColumnDecide()
    {
        Scene scene = slideTriangle("midpoint-outline-fill");
        scene.frame.origin = FrameOrigin::TopLeft;
        const Lattice half = halfPixel;
        scene.triangles[0].vertices[0].position = {3 * half, 3 * half};
        scene.triangles[0].vertices[1].position = {19 * half, 5 * half};
        scene.triangles[0].vertices[2].position = {21 * half / 2, 17 * half};
        const auto traced = traceScene(scene);
        const auto hasReason
            = [&](std::int64_t x, std::int64_t y, const char *truth, const char *column) {
                  const QString reason = pixelHistory(*traced, x, y).front().reason;
                  QVERIFY2(reason.contains(QString::fromUtf8(truth)), qPrintable(reason));
                  QVERIFY2(reason.contains(QString::fromUtf8(column)), qPrintable(reason));
                  QVERIFY2(!reason.contains(u"Refused by"_s), qPrintable(reason));
              };
        // In column 8 the outline has only rows 3 to 5; in column 10 it has (10, 3), its corner.
        hasReason(8, 2, "The truth refuses it by P₀P₁: the sample is at −5/16 px",
                  " Column 8: The outline reaches from row 3, ");
        hasReason(10, 3, "Extra: the truth does not cover it", "The truth refuses it by P₁P₂: ");
        hasReason(10, 3, "Writes R = 0", " Column 10: The outline is one pixel high: row 3, ");
    }

    /// The samples, or the area, decide; the centre has a position and no owner.
    void underAntialiasingNoFillRuleIsNamed_data()
    {
        QTest::addColumn<Antialiasing>("antialiasing");
        QTest::addColumn<QString>("reason");
        const auto at = u" The pixel's centre lies beyond L₁₂, at −3 px measured "
                        "along the column (−2.12132 px perpendicular to the edge)."_s;
        QTest::newRow("4 samples")
            << Antialiasing::Samples4 << u"No sample of the pixel lies in the triangle."_s + at;
        QTest::newRow("area") << Antialiasing::Area
                              << u"The triangle covers no part of the pixel's square."_s + at;
    }
    void underAntialiasingNoFillRuleIsNamed()
    {
        QFETCH(Antialiasing, antialiasing);
        QFETCH(QString, reason);
        Scene scene = slideTriangle("column-scan");
        scene.triangles[0].vertices[0].position = latticePixel(1, 1);
        scene.triangles[0].vertices[1].position = latticePixel(7, 1);
        scene.triangles[0].vertices[2].position = latticePixel(1, 7);
        scene.appearance.antialiasing = antialiasing;
        QCOMPARE(pixelHistory(*traceScene(scene), 6, 5).front().reason, reason);
    }

    /// (8, 6) to (12, 4) falls by ½ px per column: halfway between pixels at columns 9 and 11.
    void aLineThatPassesMidwayIsToldWithTheTruthsChoice_data()
    {
        QTest::addColumn<bool>("isSteep");
        QTest::newRow("along x") << false;
        QTest::newRow("along y") << true;
    }
    void aLineThatPassesMidwayIsToldWithTheTruthsChoice()
    {
        QFETCH(bool, isSteep);
        const Shape line = isSteep ? lineAt(6, 8, 4, 12) : lineAt(8, 6, 12, 4);
        const auto traced = traceScene(sceneOf(line, "line-bresenham", frameOf(16, 16)));
        const auto reasonAt = [&](std::int64_t along, std::int64_t across) {
            return pixelHistory(*traced, isSteep ? across : along, isSteep ? along : across)
                .front()
                .reason;
        };
        const QString tie
            = u" A tie: the exact line passes midway between %1 = 5 and %1 = 6 "
              "here, and the truth takes the greater one."_s.arg(QChar(isSteep ? u'x' : u'y'));
        QVERIFY2(reasonAt(9, 6).startsWith(u"Missing: "_s), qPrintable(reasonAt(9, 6)));
        QVERIFY2(reasonAt(9, 6).contains(tie), qPrintable(reasonAt(9, 6)));
        QVERIFY2(reasonAt(9, 5).contains(u" Extra: "_s), qPrintable(reasonAt(9, 5)));
        QVERIFY2(reasonAt(9, 5).contains(tie), qPrintable(reasonAt(9, 5)));
        for (const auto &[along, across] : {std::pair(10, 6), std::pair(9, 4), std::pair(9, 7)})
            QVERIFY2(!reasonAt(along, across).contains(u"A tie"_s),
                     qPrintable(reasonAt(along, across)));
    }

    /// Edge equations exchange the sides of P₀P₁, whose function was −48 at P₂; the solved system
    /// has different numbers.
    void aTieIsToldInTheMethodsOwnNumbers_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("told");
        QTest::newRow("exchanged")
            << "edge-equations"
            << "the edge's function is −11 at the off-screen point (−1, −1) and 48 at the vertex "
               "that faces it; their product, −528, is not above 0; ";
        QTest::newRow("as given")
            << "barycentric-all"
            << "the edge's function is 11 at the off-screen point (−1, −1) and −48 at the vertex "
               "that faces it; their product, −528, is not above 0; ";
        QTest::newRow("solved") << "edge-equations-solved"
                                << "the edge's function is −2 1/5 at the off-screen point (−1, −1) "
                                   "and 9 3/5 at the vertex that faces it; their product, "
                                   "−21 3/25, is not above 0; ";
    }
    void aTieIsToldInTheMethodsOwnNumbers()
    {
        QFETCH(QString, method);
        QFETCH(QString, told);
        const auto traced
            = traceScene(slideTriangle(method.toLatin1().constData(), FillRule::OffScreenPoint));
        const QString reason = pixelHistory(*traced, 2, 1).front().reason;
        QVERIFY2(reason.contains(told), qPrintable(reason));
        if (method == u"edge-equations"_s)
            QCOMPARE(inSetUp(*traced, "E₀(r)"), Quantity::integer(-11));
    }

    void aSegmentKeepsItsMiddleVertex_data()
    {
        QTest::addColumn<QString>("method");
        for (const char *method : {"column-scan", "row-walk", "row-walk-constant-rate"})
            QTest::newRow(method) << QString::fromLatin1(method);
    }
    void aSegmentKeepsItsMiddleVertex()
    {
        QFETCH(QString, method);
        Scene scene = slideTriangle(method.toLatin1().constData());
        scene.triangles[0].vertices[1].position = latticePixel(6, 3);
        scene.triangles[0].vertices[2].position = latticePixel(10, 5);
        const auto traced = traceScene(scene);
        QCOMPARE(inSetUp(*traced, "x₁"), Quantity::integer(6));
        QCOMPARE(inSetUp(*traced, "y₁"), Quantity::integer(3));
        QCOMPARE(inSetUp(*traced, "G₁"), Quantity::integer(255));
    }

    /// b = 8 along, a = 1 across: F(8, −½) = 64 + 16 − 64 = 16, and no row lies inward of y = 0.
    void anArcThatEndsOnTheAxisStaysThere()
    {
        const Shape ellipse = ellipseAtUnits(latticePixel(8, 10), unitsPerPixel, 8 * unitsPerPixel);
        const auto traced = traceScene(sceneOf(ellipse, "circle-midpoint", frameOf(20, 20)));
        int onAxis = 0;
        for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
            const StepWords words = traced->trace->spanWords(span);
            if (!words.sentence.contains(u"on the axis"_s))
                continue;
            ++onAxis;
            QVERIFY2(words.sentence.startsWith(
                         u"p_k = 16 > 0: the midpoint is outside, but y_k stays 0, "
                         "on the axis; "_s),
                     qPrintable(words.sentence));
            QCOMPARE(words.moment, Moment::Cross);
        }
        QCOMPARE(onAxis, 1);
    }

    /// From (1/4, 3/4) to (6 1/2, 3 3/8): y(1) = 3/4 + 3/4·21/50 = 1 13/200.
    /// 4·p₁ = 4·(5/4 − 7) + 4·3 = −11.
    void anArcThatTheFrameCutsShowsTheDecisionBeforeIt()
    {
        const Shape circle = circleAt(0, 0, 7);
        const auto cut = traceScene(sceneOf(circle, "circle-midpoint", frameOf(6, 6, 2, 2)));
        const auto whole = traceScene(sceneOf(circle, "circle-midpoint", frameOf(20, 20, -9, -9)));
        QCOMPARE(inSpan(*cut, 0, "p_k"), Quantity::rational(-11, 4));
        for (const char *title : {"p_k", "Δp", "p_k₊₁"})
            QCOMPARE(inSpan(*cut, 0, title), inSpan(*whole, 2, title));
        QVERIFY(!pixelHistory(*cut, 2, 7)[0].reason.contains(u"without a decision"_s));
        QVERIFY(inSpan(*whole, 0, "p_k").isNone());
    }

    void theFirstPixelOfALineBetweenPixelsTellsWhatIsRounded()
    {
        const Shape line = lineAtUnits({64, 192}, {1664, 864});
        const auto traced = traceScene(sceneOf(line, "line-bresenham-symmetric", frameOf(16, 8)));
        QCOMPARE(traced->trace->spanWords(0).sentence,
                 u"On the column 1 the line is at y = 1 13/200, which rounds to the "
                 "pixel (1, 1). p_k₊₁ = −3/16 < 0 decides about the next one."_s);
        QCOMPARE(inSpan(*traced, 0, "y_line"), Quantity::rational(213, 200));
    }

    /// f_bc(p) = −2·area(b, c, p): for P₁P₂, from (9, 1) to (9, 2), −10 at (−1, −1) and −7 at (2,
    /// 1).
    void anAcceptedTieTellsTheProduct()
    {
        Scene scene = slideTriangle("barycentric-off-screen", FillRule::OffScreenPoint);
        scene.triangles[0].vertices[1].position = latticePixel(9, 1);
        scene.triangles[0].vertices[2].position = latticePixel(9, 2);
        const QString reason = pixelHistory(*traceScene(scene), 9, 2).front().reason;
        QVERIFY2(reason.contains(
                     u" The sample lies exactly on P₁P₂, and the rule off-screen-point gives it to "
                     "this side: the edge's function is −10 at the off-screen point (−1, −1) and "
                     "−7 at the vertex that faces it; their product, 70, is above 0; it lies "
                     "exactly on P₂P₀, "_s),
                 qPrintable(reason));
        QVERIFY2(reason.contains(u"is −11 at the off-screen point (−1, −1) and −7 at "
                                 "the vertex that faces it; their product, 77, "_s),
                 qPrintable(reason));
        // No rule decides about a sample that lies on no edge.
        QVERIFY(!pixelHistory(
                     *traceScene(slideTriangle("barycentric-off-screen", FillRule::OffScreenPoint)),
                     4, 4)
                     .front()
                     .reason.contains(u"exactly on"_s));
    }

    void aRefusedTieTellsTheProduct()
    {
        const auto traced
            = traceScene(slideTriangle("barycentric-off-screen", FillRule::OffScreenPoint));
        const QString reason = pixelHistory(*traced, 2, 1).front().reason;
        QVERIFY2(reason.contains(u"off-screen point (−1, −1)"_s), qPrintable(reason));
        QVERIFY2(reason.contains(u"their product, −"_s), qPrintable(reason));
    }

    /// p_k = 2Δy·x_k − 2Δx·y_k + c, the slide's form before it drops what does not change.
    void bresenhamsConstantMakesEveryDecision_data()
    {
        QTest::addColumn<Shape>("line");
        QTest::addColumn<int>("constant");
        QTest::newRow("the slide's") << lineAt(20, 41, 30, 44) << 696;
        QTest::newRow("falling") << lineAt(20, 44, 30, 41) << -1004;
        QTest::newRow("steep") << lineAt(41, 20, 44, 30) << 696;
    }
    void bresenhamsConstantMakesEveryDecision()
    {
        QFETCH(Shape, line);
        QFETCH(int, constant);
        const auto traced = traceScene(sceneOf(line, "line-bresenham", frameOf(60, 60)));
        QCOMPARE(inSetUp(*traced, "c"), Quantity::integer(constant));
        const bool falls = line.vertices[0].position.y > line.vertices[1].position.y;
        for (std::size_t span = 1; span < traced->trace->spanCount(); ++span) {
            const double along = inSpan(*traced, span, "x_k").toDouble();
            const double across = inSpan(*traced, span, "y_k").toDouble();
            QCOMPARE(inSpan(*traced, span, "p_k").toDouble(),
                     6 * along + (falls ? 20 : -20) * across + constant);
            const QString whole = u"p_k = 2Δy·x_k %1 2Δx·y_k + c = 6·%2 %1 20·%3 + %4 = "_s
                                      .arg(QChar(falls ? u'+' : u'−'))
                                      .arg(along)
                                      .arg(across)
                                      .arg(operand(Quantity::integer(constant)));
            const QString sentence = traced->trace->spanWords(span).sentence;
            QVERIFY2(sentence.startsWith(whole), qPrintable(sentence));
        }
    }

    /// The slide's line as the lower edge of a triangle.
    void theMidpointOutlineShowsWhatLedToItsPixels()
    {
        Scene scene;
        scene.frame = frameOf(60, 60);
        scene.triangles = {Triangle{{{{latticePixel(20, 41), {{255, 0, 0}}},
                                      {latticePixel(30, 44), {{0, 255, 0}}},
                                      {latticePixel(30, 50), {{0, 0, 255}}}}}}};
        scene.method = "midpoint-outline-fill";
        const auto traced = traceScene(scene);
        QVERIFY(inSpan(*traced, 0, "p_low").isNone()); // no decision leads to the first pixel
        QList<double> decisions;
        for (std::size_t span = 1; span < traced->trace->spanCount(); ++span)
            decisions += inSpan(*traced, span, "p_low").toDouble();
        QCOMPARE(decisions, (QList<double>{-4, 2, -12, -6, 0, -14, -8, -2, 4, -10}));
        const auto says = [&](std::size_t span, const char *words) {
            return traced->trace->spanWords(span).sentence.contains(QString::fromUtf8(words));
        };
        QVERIFY(!says(0, "p_low"));
        QVERIFY(says(1, " p_low = −4 < 0: to (21, 41) the line stayed."));
        QVERIFY(says(2, " p_low = 2 ≥ 0: to (22, 42) the line went one across."));
        QCOMPARE(inSetUp(*traced, "Δ₀₁"), Quantity::integer(10));
        QCOMPARE(inSetUp(*traced, "δ₀₁"), Quantity::integer(3));
    }
};

PIXELPLUMB_TEST(TestDecidingNumbers)

} // namespace tst_decidingnumbers

#include "tst_decidingnumbers.moc"
