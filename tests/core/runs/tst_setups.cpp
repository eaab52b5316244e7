// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/edgename.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/explain/pixelhistory.h"
#include "core/runs/spanheadings.h"
#include "core/runs/tracedscene.h"
#include "tests/support/programs/tablefolder.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/scenes/polygons.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

namespace tst_setups {

using namespace pixelplumb;

namespace {

const FrameSpec wideFrame = frameOf(48, 48);

/// A scene with one primitive of each kind that a method may draw.
Scene sceneOfAllKinds(const Method &method)
{
    Scene scene;
    scene.frame = wideFrame;
    scene.method = method.id.toStdString();
    scene.settings = method.adapted(scene.settings);
    scene.triangles = {Triangle{{{{latticePixel(4, 5), {{255, 0, 0}}},
                                  {latticePixel(30, 12), {{0, 255, 0}}},
                                  {latticePixel(20, 40), {{0, 0, 255}}}}}}};
    scene.shapes
        = {lineAt(30, 44, 20, 41), circleAt(32, 32, 7), ellipseAtUnits({5120, 5120}, 2560, 1280)};
    return scene;
}

/// The explanation of the first set-up that is not rejected.
Explanation setUpOf(const Scene &scene)
{
    const auto traced = traceScene(scene);
    for (std::size_t i = 0; i < traced->trace->primitiveCount(); ++i) {
        if (!traced->trace->setUp(i).rejection)
            return explainStep(*traced, traced->trace->indexOfSetUp(i));
    }
    return {};
}

QStringList symbolsOf(const Explanation &explanation)
{
    QStringList symbols;
    for (const FormulaLine &line : explanation.lines)
        symbols.append(line.symbols);
    return symbols;
}

double numberIn(const QJsonObject &row, const char *id)
{
    return row[QLatin1String(id)].toDouble();
}

} // namespace

/// What is said about a primitive before it is drawn, and the headings of its columns.
class TestSetUps : public QObject {
    Q_OBJECT

private slots:
    void everyNumberThatASetUpWorksOutHasAFormula_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QStringList>("expected");
        const auto row = [](const char *id, const QStringList &expected) {
            QTest::newRow(id) << QString::fromLatin1(id) << expected;
        };
        row("interpolate-plane",
            {u"A_R = "_s, u"B_R = "_s, u"C_R = "_s, u"D_R = "_s, u"a_R = −A_R/C_R"_s, u"c_B = "_s});
        row("interpolate-barycentric",
            {u"A_α = "_s, u"k_α = 1/("_s, u"a_α = k_α·A_α"_s, u"c_γ = k_γ·C_γ"_s});
        row("interpolate-bilinear", {u"m₀₁ = "_s, u"δR₀₂ = "_s});
        row("line-bresenham", {u"Δx = "_s, u"2Δy = "_s, u"2Δy − 2Δx = "_s, u"p₀ = 2Δy − Δx"_s});
        row("line-bresenham-symmetric", {u"2Δy = "_s});
        row("line-dda", {u"m = "_s, u"ΔR = "_s});
        row("line-slope-intercept", {u"m = (y₁ − y₀)/(x₁ − x₀)"_s, u"b = y₀ − m·x₀"_s});
        row("circle-midpoint", {u"p₀ = 5/4 − r_x"_s});
        row("column-scan", {u"m₀₁ = "_s, u"A = "_s});
        row("edge-equations-solved", {u"q₀ = "_s, u"a₀ = "_s});
    }
    void everyNumberThatASetUpWorksOutHasAFormula()
    {
        QFETCH(QString, id);
        QFETCH(QStringList, expected);
        const QStringList symbols = symbolsOf(setUpOf(sceneOfAllKinds(*methodNamed(id))));
        for (const QString &formula : expected)
            QVERIFY2(std::ranges::any_of(
                         symbols, [&](const QString &each) { return each.startsWith(formula); }),
                     qPrintable(formula + u" is not among "_s + symbols.join(u"; "_s)));
    }

    void interpolationsThatDoNotSortLeaveTheVerticesTheirOwnNames_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<Antialiasing>("antialiasing");
        for (const char *id : {"interpolate-plane", "interpolate-barycentric"}) {
            QTest::addRow("%s", id) << QString::fromLatin1(id) << Antialiasing::None;
            QTest::addRow("%s with effects", id)
                << QString::fromLatin1(id) << Antialiasing::Samples4;
        }
    }
    void interpolationsThatDoNotSortLeaveTheVerticesTheirOwnNames()
    {
        QFETCH(QString, id);
        QFETCH(Antialiasing, antialiasing);
        Scene scene;
        scene.triangles = {Triangle{{{{latticePixel(9, 9), {{255, 0, 0}}},
                                      {latticePixel(1, 1), {{0, 255, 0}}},
                                      {latticePixel(5, 20), {{0, 0, 255}}}}}}};
        scene.method = id.toStdString();
        scene.appearance.antialiasing = antialiasing;
        const auto traced = traceScene(scene);
        const SetUpRecord setUp = traced->trace->setUp(0);

        QCOMPARE(vertexName(setUp, 0), u"P₀"_s);
        QCOMPARE(edgeName(setUp, 2, 0), u"P₂P₀"_s);
        const QString sentence = explainStep(*traced, traced->trace->indexOfSetUp(0)).sentence;
        QVERIFY2(sentence.contains(u"P₀ = (9, 9), P₁ = (1, 1), P₂ = (5, 20)"_s),
                 qPrintable(sentence));
        QVERIFY2(!sentence.contains(u"orted"_s), qPrintable(sentence));
        const std::vector<NumberDescription> &numbers = traced->trace->numbers().setUp;
        const auto place
            = std::ranges::find(numbers, u"x₀"_s, &NumberDescription::title) - numbers.begin();
        QCOMPARE(toText(setUp.cells[std::size_t(place)]), u"9"_s);
        for (const NumberDescription &number : numbers)
            QVERIFY2(!number.toolTip.contains(u"vertex 0"_s), qPrintable(number.toolTip));
        for (const PseudocodeLine &line : traced->method->pseudocode)
            QVERIFY2(!line.text.contains(u"L₀₁"_s), qPrintable(line.text));
        if (antialiasing == Antialiasing::None)
            QVERIFY(pixelHistory(*traced, 7, 2)[0].reason.contains(u"P₀P₁"_s));
    }

    void aLineSaysWhichEndIsStoredFirstAndWhetherItIsTurned()
    {
        for (const char *id :
             {"line-slope-intercept", "line-dda", "line-bresenham", "line-bresenham-symmetric"}) {
            const QString backwards
                = setUpOf(sceneOf(lineAt(30, 44, 20, 41), id, wideFrame)).sentence;
            QVERIFY2(backwards.contains(u"P₀ = (30, 44)"_s), qPrintable(backwards));
            QVERIFY2(backwards.contains(u"₀) = (20, 41)"_s), qPrintable(backwards));
            QVERIFY(!backwards.contains(u"exchanged"_s));
        }
        for (const char *id : {"line-dda", "line-bresenham", "line-bresenham-symmetric"}) {
            const QString steep = setUpOf(sceneOf(lineAt(32, 20, 43, 38), id, wideFrame)).sentence;
            QVERIFY2(steep.contains(u"x and y are exchanged"_s), qPrintable(steep));
            QVERIFY2(steep.contains(u"₀) = (20, 32)"_s), qPrintable(steep));
        }
    }

    void bresenhamShowsTheTwoDistancesThatItsDecisionWeighs()
    {
        const auto traced
            = traceScene(sceneOf(lineAt(20, 41, 30, 44), "line-bresenham", wideFrame));
        const auto cell = [&](std::size_t span, const char *id) {
            const auto &numbers = traced->method->numbers.span;
            const auto found
                = std::ranges::find(numbers, QString::fromLatin1(id), &NumberDescription::id);
            return traced->trace->span(span).cells[std::size_t(found - numbers.begin())];
        };
        QVERIFY(cell(0, "d_lower").isNone());
        // At x = 21 the line is at 41 3/10.
        QCOMPARE(toText(cell(1, "d_lower")), u"3/10"_s);
        QCOMPARE(toText(cell(1, "d_upper")), u"7/10"_s);
        QCOMPARE(cell(1, "p_k"), Quantity::integer(-4));
    }

    void aCircleHasACentreAndARadius()
    {
        const QString circle
            = setUpOf(sceneOf(circleAt(32, 32, 7), "circle-midpoint", wideFrame)).sentence;
        QVERIFY2(circle.contains(u"Centre (32, 32), radius 7."_s), qPrintable(circle));
        QVERIFY(!circle.contains(u"P₁"_s));
    }

    void aPolygonSaysWhichTestDecides()
    {
        const auto sentence = [](ShapeFill fill) {
            return setUpOf(sceneOf(pentagram(fill), "polygon-parity", wideFrame)).sentence;
        };
        QVERIFY(sentence(ShapeFill::EvenOdd).contains(u"Even-odd decides"_s));
        QVERIFY(sentence(ShapeFill::NonZero).contains(u"Non-zero decides"_s));
    }

    void aSegmentWhoseFirstTwoVerticesShareAColumnIsAllSecondHalf()
    {
        for (const char *id : {"column-scan", "interpolate-bilinear"}) {
            Scene scene;
            scene.method = id;
            scene.triangles = {Triangle{
                {{{latticePixel(3, 1), {}}, {latticePixel(3, 9), {}}, {latticePixel(3, 4), {}}}}}};
            const auto traced = traceScene(scene);
            QCOMPARE(traced->trace->placeOf(0).part, 1);
            const Explanation column = explainStep(*traced, traced->trace->indexOfSpan(0));
            QVERIFY2(!column.sentence.contains(u"L₁₂"_s), qPrintable(column.sentence));
        }
    }

    void headingsAndFormulasFollowTheRuleInEveryFormat()
    {
        Scene scene = defaultSceneIn(Arithmetic::Exact);
        scene.method = "column-scan";
        scene.settings.fillRule = FillRule::HalfOpenColumn;
        const auto traced = traceScene(scene);
        const auto rule = u"⌈y_T⌉ − 1"_s;
        const QString text = QString::fromUtf8(exported(*traced, {.format = TableFormat::Text}));
        QVERIFY(text.section(u'\n', 0, 0).contains(rule));
        QVERIFY(!text.section(u'\n', 0, 0).contains(u"⌊y_T⌋"_s));
        const QString json = QString::fromUtf8(exported(*traced, {.format = TableFormat::Json}));
        QVERIFY(json.contains(u"last row = "_s + rule));
        QVERIFY(!json.contains(u"last row = ⌊y_T⌋"_s));

        scene.method = "row-walk";
        scene.settings.fillRule = FillRule::Open;
        const QString rows
            = QString::fromUtf8(exported(*traceScene(scene), {.format = TableFormat::Text}))
                  .section(u'\n', 0, 0);
        QVERIFY2(rows.contains(u"⌊x_L⌋ + 1"_s), qPrintable(rows));
    }

    void aColumnsFirstLevelsCanBeRecomputedFromItsRow()
    {
        Scene scene = defaultSceneIn(Arithmetic::Exact);
        scene.method = "column-scan";
        scene.frame.firstRow = 14; // cuts the columns from below
        scene.frame.height = 20;
        const auto document
            = QJsonDocument::fromJson(exported(*traceScene(scene), {.format = TableFormat::Json}))
                  .object();
        QString formula;
        for (const QJsonValue &column : document[u"columns"_s].toArray()) {
            if (column[u"id"_s].toString() == u"first_R"_s)
                formula = column[u"formula"_s].toString();
        }
        QCOMPARE(formula, u"first R = R_B + (y_start − y_B)·ΔR"_s);
        int compared = 0;
        for (const QJsonValue &value : document[u"rows"_s].toArray()) {
            const QJsonObject row = value.toObject();
            // Equal bounds have no rate; columns outside the frame have no levels.
            if (row[u"delta_R"_s].isNull() || row[u"first_R"_s].isNull())
                continue;
            const double again = numberIn(row, "R_B")
                + (numberIn(row, "first_drawn_row") - numberIn(row, "y_B"))
                    * numberIn(row, "delta_R");
            QVERIFY(std::abs(again - numberIn(row, "first_R")) < 1e-6);
            QVERIFY(numberIn(row, "first_drawn_row") >= 14);
            ++compared;
        }
        QVERIFY2(compared > 20, qPrintable(QString::number(compared)));
    }
};

PIXELPLUMB_TEST(TestSetUps)

} // namespace tst_setups

#include "tst_setups.moc"
