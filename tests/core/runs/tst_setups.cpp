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
            {QStringLiteral("A_R = "), QStringLiteral("B_R = "), QStringLiteral("C_R = "),
             QStringLiteral("D_R = "), QStringLiteral("a_R = −A_R/C_R"), QStringLiteral("c_B = ")});
        row("interpolate-barycentric",
            {QStringLiteral("A_α = "), QStringLiteral("k_α = 1/("), QStringLiteral("a_α = k_α·A_α"),
             QStringLiteral("c_γ = k_γ·C_γ")});
        row("interpolate-bilinear", {QStringLiteral("m₀₁ = "), QStringLiteral("δR₀₂ = ")});
        row("line-bresenham",
            {QStringLiteral("Δx = "), QStringLiteral("2Δy = "), QStringLiteral("2Δy − 2Δx = "),
             QStringLiteral("p₀ = 2Δy − Δx")});
        row("line-bresenham-symmetric", {QStringLiteral("2Δy = ")});
        row("line-dda", {QStringLiteral("m = "), QStringLiteral("ΔR = ")});
        row("line-slope-intercept",
            {QStringLiteral("m = (y₁ − y₀)/(x₁ − x₀)"), QStringLiteral("b = y₀ − m·x₀")});
        row("circle-midpoint", {QStringLiteral("p₀ = 5/4 − r_x")});
        row("column-scan", {QStringLiteral("m₀₁ = "), QStringLiteral("A = ")});
        row("edge-equations-solved", {QStringLiteral("q₀ = "), QStringLiteral("a₀ = ")});
    }
    void everyNumberThatASetUpWorksOutHasAFormula()
    {
        QFETCH(QString, id);
        QFETCH(QStringList, expected);
        const QStringList symbols = symbolsOf(setUpOf(sceneOfAllKinds(*methodNamed(id))));
        for (const QString &formula : expected)
            QVERIFY2(std::ranges::any_of(
                         symbols, [&](const QString &each) { return each.startsWith(formula); }),
                     qPrintable(formula + QStringLiteral(" is not among ")
                                + symbols.join(QStringLiteral("; "))));
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

        QCOMPARE(vertexName(setUp, 0), QStringLiteral("P₀"));
        QCOMPARE(edgeName(setUp, 2, 0), QStringLiteral("P₂P₀"));
        const QString sentence = explainStep(*traced, traced->trace->indexOfSetUp(0)).sentence;
        QVERIFY2(sentence.contains(QStringLiteral("P₀ = (9, 9), P₁ = (1, 1), P₂ = (5, 20)")),
                 qPrintable(sentence));
        QVERIFY2(!sentence.contains(QStringLiteral("orted")), qPrintable(sentence));
        const std::vector<NumberDescription> &numbers = traced->trace->numbers().setUp;
        const auto place
            = std::ranges::find(numbers, QStringLiteral("x₀"), &NumberDescription::title)
            - numbers.begin();
        QCOMPARE(toText(setUp.cells[std::size_t(place)]), QStringLiteral("9"));
        for (const NumberDescription &number : numbers)
            QVERIFY2(!number.toolTip.contains(QStringLiteral("vertex 0")),
                     qPrintable(number.toolTip));
        for (const PseudocodeLine &line : traced->method->pseudocode)
            QVERIFY2(!line.text.contains(QStringLiteral("L₀₁")), qPrintable(line.text));
        if (antialiasing == Antialiasing::None)
            QVERIFY(pixelHistory(*traced, 7, 2)[0].reason.contains(QStringLiteral("P₀P₁")));
    }

    void aLineSaysWhichEndIsStoredFirstAndWhetherItIsTurned()
    {
        for (const char *id :
             {"line-slope-intercept", "line-dda", "line-bresenham", "line-bresenham-symmetric"}) {
            const QString backwards
                = setUpOf(sceneOf(lineAt(30, 44, 20, 41), id, wideFrame)).sentence;
            QVERIFY2(backwards.contains(QStringLiteral("P₀ = (30, 44)")), qPrintable(backwards));
            QVERIFY2(backwards.contains(QStringLiteral("₀) = (20, 41)")), qPrintable(backwards));
            QVERIFY(!backwards.contains(QStringLiteral("exchanged")));
        }
        for (const char *id : {"line-dda", "line-bresenham", "line-bresenham-symmetric"}) {
            const QString steep = setUpOf(sceneOf(lineAt(32, 20, 43, 38), id, wideFrame)).sentence;
            QVERIFY2(steep.contains(QStringLiteral("x and y are exchanged")), qPrintable(steep));
            QVERIFY2(steep.contains(QStringLiteral("₀) = (20, 32)")), qPrintable(steep));
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
        QCOMPARE(toText(cell(1, "d_lower")), QStringLiteral("3/10"));
        QCOMPARE(toText(cell(1, "d_upper")), QStringLiteral("7/10"));
        QCOMPARE(cell(1, "p_k"), Quantity::integer(-4));
    }

    void aCircleHasACentreAndARadius()
    {
        const QString circle
            = setUpOf(sceneOf(circleAt(32, 32, 7), "circle-midpoint", wideFrame)).sentence;
        QVERIFY2(circle.contains(QStringLiteral("Centre (32, 32), radius 7.")), qPrintable(circle));
        QVERIFY(!circle.contains(QStringLiteral("P₁")));
    }

    void aPolygonSaysWhichTestDecides()
    {
        const auto sentence = [](ShapeFill fill) {
            return setUpOf(sceneOf(pentagram(fill), "polygon-parity", wideFrame)).sentence;
        };
        QVERIFY(sentence(ShapeFill::EvenOdd).contains(QStringLiteral("Even-odd decides")));
        QVERIFY(sentence(ShapeFill::NonZero).contains(QStringLiteral("Non-zero decides")));
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
            QVERIFY2(!column.sentence.contains(QStringLiteral("L₁₂")), qPrintable(column.sentence));
        }
    }

    void headingsAndFormulasFollowTheRuleInEveryFormat()
    {
        Scene scene = defaultSceneIn(Arithmetic::Exact);
        scene.method = "column-scan";
        scene.settings.fillRule = FillRule::HalfOpenColumn;
        const auto traced = traceScene(scene);
        const auto rule = QStringLiteral("⌈y_T⌉ − 1");
        const QString text = QString::fromUtf8(exported(*traced, {.format = TableFormat::Text}));
        QVERIFY(text.section(u'\n', 0, 0).contains(rule));
        QVERIFY(!text.section(u'\n', 0, 0).contains(QStringLiteral("⌊y_T⌋")));
        const QString json = QString::fromUtf8(exported(*traced, {.format = TableFormat::Json}));
        QVERIFY(json.contains(QStringLiteral("last row = ") + rule));
        QVERIFY(!json.contains(QStringLiteral("last row = ⌊y_T⌋")));

        scene.method = "row-walk";
        scene.settings.fillRule = FillRule::Open;
        const QString rows
            = QString::fromUtf8(exported(*traceScene(scene), {.format = TableFormat::Text}))
                  .section(u'\n', 0, 0);
        QVERIFY2(rows.contains(QStringLiteral("⌊x_L⌋ + 1")), qPrintable(rows));
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
        for (const QJsonValue &column : document[QStringLiteral("columns")].toArray()) {
            if (column[QStringLiteral("id")].toString() == QStringLiteral("first_R"))
                formula = column[QStringLiteral("formula")].toString();
        }
        QCOMPARE(formula, QStringLiteral("first R = R_B + (y_start − y_B)·ΔR"));
        int compared = 0;
        for (const QJsonValue &value : document[QStringLiteral("rows")].toArray()) {
            const QJsonObject row = value.toObject();
            // Equal bounds have no rate; columns outside the frame have no levels.
            if (row[QStringLiteral("delta_R")].isNull() || row[QStringLiteral("first_R")].isNull())
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
