// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/words/formulatext.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/tracedscene.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tst_curvewords {

using namespace pixelplumb;

namespace {

const FrameSpec frame = frameOf(40, 40);

/// A span of a run and what is said about it.
struct ToldSpan {
    const TracedScene &traced;
    std::size_t span;

    QString sentence() const
    {
        return explainStep(traced, traced.trace->indexOfSpan(span)).sentence;
    }
    Quantity cell(const char *id) const
    {
        const SpanRecord record = traced.trace->span(span);
        for (std::size_t i = 0; i < record.cells.size(); ++i) {
            if (traced.method->numbers.span[i].id == QLatin1String(id))
                return record.cells[i];
        }
        return {};
    }
    std::int64_t count(const char *id) const { return std::int64_t(cell(id).numerator()); }
    /// Whether a position along a or b lies in one of the squares that the piece may meet.
    bool isAmong(const QByteArray &coordinate, double place) const
    {
        return place > double(count(coordinate + "_low")) - 1e-9
            && place < double(count(coordinate + "_high")) + 1 + 1e-9;
    }
};

/// Calls a function with every span of a shape's run.
template <class Function>
void forEachSpan(const Shape &shape, const char *method, const Function &function,
                 Arithmetic arithmetic = Arithmetic::Exact)
{
    Scene scene = sceneOf(shape, method, frame);
    scene.settings.arithmetic = arithmetic;
    const auto traced = traceScene(scene);
    QVERIFY(traced->trace->spanCount() > 3);
    for (std::size_t span = 0; span < traced->trace->spanCount(); ++span)
        function(ToldSpan{*traced, span});
}

/// The pixels that a sentence names.
std::vector<LatticePoint> pixelsNamed(const QString &sentence)
{
    static const QRegularExpression pixel(QStringLiteral(R"(the pixel \((-?\d+), (-?\d+)\))"));
    std::vector<LatticePoint> pixels;
    for (const QRegularExpressionMatch &match : pixel.globalMatch(sentence))
        pixels.push_back({match.captured(1).toLongLong(), match.captured(2).toLongLong()});
    return pixels;
}

/// A coordinate of a curve, px.
double coordinateAt(const Shape &curve, Lattice LatticePoint::*axis, double t)
{
    std::vector<double> points;
    for (const Vertex &vertex : curve.vertices)
        points.push_back(double(vertex.position.*axis) / 256);
    for (std::size_t left = points.size() - 1; left > 0; --left) {
        for (std::size_t i = 0; i < left; ++i)
            points[i] += t * (points[i + 1] - points[i]);
    }
    return points[0];
}

} // namespace

/// What is said about the steps of circles and curves, against independently computed facts.
class TestCurveWords : public QObject {
    Q_OBJECT

private slots:
    void theMidpointsSideAndTheBranchAreTold_data()
    {
        QTest::addColumn<int>("a");
        QTest::addColumn<int>("b");
        QTest::newRow("circle") << 11 << 11;
        QTest::newRow("circle of 5, with a tie") << 5 << 5;
        QTest::newRow("flat ellipse") << 15 << 4;
        QTest::newRow("steep ellipse") << 3 << 14;
    }
    void theMidpointsSideAndTheBranchAreTold()
    {
        QFETCH(int, a);
        QFETCH(int, b);
        const Shape shape = ellipseAtUnits(latticePixel(20, 20), a * 256, b * 256);
        std::int64_t before = 0;
        forEachSpan(shape, "circle-midpoint", [&](const ToldSpan &step) {
            const QString sentence = step.sentence();
            const std::int64_t x = step.count("x_k"), y = step.count("y_k");
            const std::int64_t down = std::exchange(before, y) - y;
            const bool isSteep = a != b && step.count("arc") == 2;
            if (step.cell("p_k").isNone()) {
                QVERIFY2(sentence.contains(u"without a decision"_s), qPrintable(sentence));
                QCOMPARE(sentence.contains(u"x_k in rows and y_k in columns"_s), isSteep);
                return;
            }
            // 4·F at the midpoint below the previous row.
            const std::int64_t along = isSteep ? b : a, across = isSteep ? a : b;
            const std::int64_t row = 2 * (y + down) - 1;
            const std::int64_t f = 4 * across * across * x * x + along * along * row * row
                - 4 * along * along * across * across;
            const QString side = f > 0 ? u" > 0: the midpoint is outside,"_s
                : f < 0                ? u" < 0: the midpoint is inside,"_s
                                       : u"p_k = 0: the midpoint is on the curve,"_s;
            QVERIFY2(sentence.contains(side), qPrintable(sentence));
            QVERIFY2(
                sentence.contains(f > 0 ? u"inwards, to %1;"_s.arg(y) : u"y_k stays %1;"_s.arg(y)),
                qPrintable(sentence));
            QCOMPARE(f > 0, down > 0);
            QCOMPARE(sentence.contains(u"column"_s), isSteep && down > 0);
            if (down > 1)
                return;
            const bool isCircle = a == b;
            const std::int64_t increment = isCircle
                ? 2 * x + 1 - down * 2 * y
                : across * across * (2 * x + 1) - down * 2 * along * along * y;
            const QString radii
                = isSteep ? u"r_x²·(2x_k + 1) − 2r_y²·y_k"_s : u"r_y²·(2x_k + 1) − 2r_x²·y_k"_s;
            const QString formula = isCircle ? u"2x_k + 1 − 2y_k"_s : radii;
            const qsizetype stays = formula.indexOf(u" − "_s);
            QVERIFY2(
                sentence.endsWith(u"Δp = %1 = %2."_s.arg(down == 0 ? formula.first(stays) : formula)
                                      .arg(QString::number(increment).replace(u'-', u'−'))),
                qPrintable(sentence));
        });
    }

    /// Of the radius 4, F(x, y) = x² + y² − 16 from the centre.
    void theDecisionIsThatOfTheMidpointThatItsMeaningNames()
    {
        std::int64_t before = 0;
        int crossings = 0;
        forEachSpan(circleAt(20, 19, 4), "circle-midpoint", [&](const ToldSpan &step) {
            const auto x = double(step.count("x_k"));
            const std::int64_t y = step.count("y_k");
            if (!step.cell("p_k").isNone()) {
                const double middle = double(before) - 0.5;
                QCOMPARE(step.cell("p_k").toDouble(), x * x + middle * middle - 16);
                crossings += int(y < before);
            }
            before = y;
        });
        QVERIFY(crossings > 0);
        const auto &numbers = methodNamed(u"circle-midpoint")->numbers.span;
        const auto decision = std::ranges::find(numbers, u"p_k"_s, &NumberDescription::id);
        QVERIFY(decision->toolTip.contains(u"the y_k of the step before and the one inwards"));
    }

    void theRowsOfTheExplicitFormAreTold()
    {
        const Shape shape = ellipseAtUnits({20 * 256 + 70, 19 * 256 + 30}, 9 * 256, 13 * 256);
        for (const Arithmetic arithmetic : {Arithmetic::Exact, Arithmetic::Float64}) {
            forEachSpan(
                shape, "circle-explicit",
                [](const ToldSpan &step) {
                    const auto x = double(step.count("x"));
                    const double d = x - 20 - 70 / 256.0;
                    const double h = 13.0 / 9 * std::sqrt(81 - d * d);
                    const double centre = 19 + 30 / 256.0;
                    QVERIFY2(step.sentence().endsWith(u"which rounds to the rows %1 and %2."_s
                                                          .arg(std::lround(centre + h))
                                                          .arg(std::lround(centre - h))),
                             qPrintable(step.sentence()));
                    QVERIFY(step.sentence().startsWith(
                        u"On the column %1 the curve is h from y_c"_s.arg(x)));
                },
                arithmetic);
        }
    }

    void thePointOfTheParametricFormIsTold()
    {
        forEachSpan(
            circleAt(20, 18, 9), "circle-parametric",
            [](const ToldSpan &step) {
                const double angle = double(step.count("i")) / 9;
                const LatticePoint nearest = {std::lround(20 + 9 * std::cos(angle)),
                                              std::lround(18 + 9 * std::sin(angle))};
                QCOMPARE(pixelsNamed(step.sentence()), std::vector<LatticePoint>{nearest});
                QVERIFY(step.sentence().startsWith(u"At θ = %1 the curve is at (%2, %3)"_s.arg(
                    term(step.cell("theta")), term(step.cell("u")), term(step.cell("v")))));
            },
            Arithmetic::Float64);
    }

    void aPieceOfACurveHasThePixelsThatAreTold_data()
    {
        QTest::addColumn<Shape>("curve");
        QTest::newRow("quadratic") << bezierAt({{0, 9000}, {5000, -2000}, {9000, 9000}});
        QTest::newRow("cubic") << bezierAt({{0, 0}, {9000, 3000}, {-900, 9000}, {9000, 700}});
        QTest::newRow("through corners") << bezierAt({{128, 0}, {128, 700}, {128, 3000}});
    }
    void aPieceOfACurveHasThePixelsThatAreTold()
    {
        QFETCH(Shape, curve);
        forEachSpan(curve, "bezier-subdivision", [&](const ToldSpan &step) {
            const QString sentence = step.sentence();
            // A piece with more halvings than a fraction can hold has no numbers of its own.
            if (step.cell("t_from").isNone() || step.cell("t_to").isNone())
                return;
            const double from = step.cell("t_from").toDouble(), to = step.cell("t_to").toDouble();
            const int places = std::max(6, int(step.count("depth")) / 3 + 2);
            const QString ends = u"From t = %1 to t = %2 the curve "_s;
            QVERIFY2(sentence.startsWith(ends.arg(term(step.cell("t_from"), places),
                                                  term(step.cell("t_to"), places))),
                     qPrintable(sentence));
            QVERIFY(term(step.cell("t_from"), places) != term(step.cell("t_to"), places));
            const bool isWithinOne = step.count("a_low") == step.count("a_high")
                && step.count("b_low") == step.count("b_high");
            QCOMPARE(sentence.contains(u"stays within one diamond"_s), isWithinOne);
            const std::vector<LatticePoint> named = pixelsNamed(sentence);
            if (sentence.contains(u"passes one side"_s)) {
                static const QRegularExpression along(
                    u"diamond: (a only (grows|falls) .*, and b|b only (grows|falls) .*, and a) "
                    "stays within -?−?\\d+\\."_s);
                QVERIFY2(along.match(sentence).hasMatch(), qPrintable(sentence));
            }
            const bool isHalved = sentence.endsWith(u"it is halved."_s);
            QCOMPARE(step.count("decided"), std::int64_t(isHalved ? 0 : 1));
            if (isHalved) {
                QVERIFY(named.empty());
                return;
            }
            constexpr int parts = 64;
            for (int part = 1; part < parts; ++part) {
                const double t = from + (to - from) * part / parts;
                const double x = coordinateAt(curve, &LatticePoint::x, t);
                const double y = coordinateAt(curve, &LatticePoint::y, t);
                QVERIFY(step.isAmong("a", x + y + 0.5));
                QVERIFY(step.isAmong("b", y - x + 0.5));
                const LatticePoint pixel = {std::lround(x), std::lround(y)};
                const double distance
                    = std::abs(x - double(pixel.x)) + std::abs(y - double(pixel.y));
                if (distance < 0.5 - 1e-9)
                    QVERIFY2(std::ranges::find(named, pixel) != named.end(), qPrintable(sentence));
            }
            const CasePicture truth = truthOf(curve, frame);
            for (const LatticePoint &pixel : named)
                QVERIFY2(truth.isWritten(pixel.x, pixel.y), qPrintable(sentence));
        });
    }
};

PIXELPLUMB_TEST(TestCurveWords)

} // namespace tst_curvewords

#include "tst_curvewords.moc"
