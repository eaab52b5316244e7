// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/scene/scenefile.h"

#include <QRandomGenerator>
#include <QTest>

using namespace pixelplumb;

namespace {

QByteArray sceneWith(const QByteArray &primitives, const QByteArray &members = {})
{
    return "{ \"pixelplumb\": 1, \"frame\": { \"width\": 8, \"height\": 8 },\n" + members
        + "\"primitives\": [\n" + primitives + "\n] }";
}

/// JSON with apostrophes for quotation marks: moc loses its way in raw strings that hold a #.
QByteArray json(const char *text) { return QByteArray(text).replace('\'', '"'); }

QString errorOf(const QByteArray &text)
{
    const Result<SceneReading> reading = readScene(text);
    return reading ? QStringLiteral("no error") : reading.error().message();
}

Shape shapeOf(PrimitiveKind kind, const std::vector<Vertex> &vertices,
              ShapeFill fill = ShapeFill::Outline)
{
    Shape shape;
    shape.kind = kind;
    shape.vertices = vertices;
    shape.fill = fill;
    return shape;
}

constexpr Colour ochre = {{204, 119, 34}};
constexpr Colour white = {{255, 255, 255}};

/// One shape of each kind, and its line of a file.
struct Example {
    QByteArray text;
    Shape shape;
};

std::vector<Example> examples()
{
    const auto at = [](std::int64_t x, std::int64_t y) { return latticePixel(x, y); };
    Shape pierced = shapeOf(PrimitiveKind::Polygon,
                            {{at(0, 0), ochre},
                             {at(9, 0), ochre},
                             {at(0, 9), ochre},
                             {at(1, 1), ochre},
                             {at(3, 1), ochre},
                             {at(1, 3), ochre}},
                            ShapeFill::NonZero);
    pierced.laterContours = {3};
    Shape text = shapeOf(PrimitiveKind::Text, {{at(3, 2), ochre}}, ShapeFill::NonZero);
    text.text = "say “é” \"\\\n\t\x01";
    text.textHeight = 12 * unitsPerPixel + 64;
    return {
        {json("{ 'points': [[1, 2], ['7/2', -4]], 'colors': ['#cc7722', '#ffffff'] }"),
         shapeOf(PrimitiveKind::Point, {{at(1, 2), ochre}, {{896, -1024}, white}})},
        {json("{ 'line': [[20, 41], [30, 44]], 'colors': ['#cc7722', '#ffffff'] }"),
         shapeOf(PrimitiveKind::Line, {{at(20, 41), ochre}, {at(30, 44), white}})},
        {json("{ 'circle': { 'centre': [5, 6], 'radius': '1/256' }, 'color': '#cc7722', 'fill': "
              "'outline' }"),
         shapeOf(PrimitiveKind::Circle, {{at(5, 6), ochre}, {{5 * 256 + 1, 6 * 256 + 1}, ochre}})},
        {json("{ 'circle': { 'centre': [5, 6], 'radius': 4 }, 'color': '#cc7722', 'fill': 'filled' "
              "}"),
         shapeOf(PrimitiveKind::Circle, {{at(5, 6), ochre}, {at(9, 10), ochre}},
                 ShapeFill::NonZero)},
        {json("{ 'ellipse': { 'centre': [5, 6], 'radii': [4, 3] }, 'color': '#cc7722', 'fill': "
              "'outline' }"),
         shapeOf(PrimitiveKind::Ellipse, {{at(5, 6), ochre}, {at(9, 9), ochre}})},
        {json("{ 'bezier': [[0, 0], [1, 5], [7, 1]], 'color': '#cc7722' }"),
         shapeOf(PrimitiveKind::Bezier, {{at(0, 0), ochre}, {at(1, 5), ochre}, {at(7, 1), ochre}})},
        {json("{ 'bezier': [[0, 0], [1, 5], [7, 1], [2, 2]], 'color': '#cc7722' }"),
         shapeOf(PrimitiveKind::Bezier,
                 {{at(0, 0), ochre}, {at(1, 5), ochre}, {at(7, 1), ochre}, {at(2, 2), ochre}})},
        {json("{ 'polygon': [[0, 0], [1, 5], [7, 1]], 'color': '#cc7722', 'fill': 'even-odd' }"),
         shapeOf(PrimitiveKind::Polygon, {{at(0, 0), ochre}, {at(1, 5), ochre}, {at(7, 1), ochre}},
                 ShapeFill::EvenOdd)},
        {json("{ 'polygon': { 'contours': [[[0, 0], [9, 0], [0, 9]], [[1, 1], [3, 1], [1, 3]]] }, "
              "'color': '#cc7722', 'fill': 'non-zero' }"),
         pierced},
        {json("{ 'text': 'say “é” \\\"\\\\\\u000a\\u0009\\u0001', 'at': [3, 2], 'height': '49/4', "
              "'color': '#cc7722' }"),
         text},
    };
}

} // namespace

Q_DECLARE_METATYPE(Shape)

/// Scenes with primitives that are not triangles.
class TestShapeScenes : public QObject {
    Q_OBJECT

private slots:
    void readsAndWritesEveryKindOfPrimitive_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<Shape>("shape");
        for (const Example &example : examples())
            QTest::newRow(example.text.constData()) << example.text << example.shape;
    }
    void readsAndWritesEveryKindOfPrimitive()
    {
        QFETCH(QByteArray, text);
        QFETCH(Shape, shape);

        const Result<SceneReading> reading = readScene(sceneWith(text));

        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        QCOMPARE(reading->scene.shapes.size(), std::size_t(1));
        QVERIFY(reading->scene.shapes.front() == shape);
        QVERIFY(reading->snaps.empty());
        const QByteArray written = writeScene(reading->scene);
        QVERIFY2(written.contains("\n        " + text + "\n"), written.constData());
        QVERIFY(readScene(written)->scene == reading->scene);
        QCOMPARE(writeScene(readScene(written)->scene), written);
    }

    void keepsTheOrderOfAllPrimitives()
    {
        QByteArray primitives
            = "{ \"triangle\": [[0, 0], [4, 0], [0, 4]], \"colors\": [\"#ff0000\", \"#00ff00\", "
              "\"#0000ff\"] }";
        for (const Example &example : examples())
            primitives += ",\n" + example.text;

        const Result<SceneReading> reading = readScene(sceneWith(primitives));

        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        QCOMPARE(reading->scene.triangles.size(), std::size_t(1));
        QCOMPARE(reading->scene.shapes.size(), examples().size());
        QCOMPARE(readScene(writeScene(reading->scene))->scene, reading->scene);
    }

    void leavesOutWhatHasADefault()
    {
        const auto fillOf = [](const QByteArray &primitive) {
            return readScene(sceneWith(primitive))->scene.shapes.front().fill;
        };
        QCOMPARE(
            fillOf(json("{ 'circle': { 'centre': [5, 6], 'radius': 4 }, 'color': '#cc7722' }")),
            ShapeFill::Outline);
        QCOMPARE(fillOf(json("{ 'polygon': [[0, 0], [1, 5], [7, 1]], 'color': '#cc7722' }")),
                 ShapeFill::EvenOdd);
    }

    void choosesTheMethodOfTheFirstPrimitive_data()
    {
        QTest::addColumn<QByteArray>("primitive");
        QTest::addColumn<QString>("method");
        QTest::newRow("line") << examples()[1].text << "line-dda";
        QTest::newRow("points") << examples()[0].text << "point-address";
        QTest::newRow("outlined circle") << examples()[2].text << "circle-midpoint";
        QTest::newRow("filled circle") << examples()[3].text << "circle-fill";
        QTest::newRow("curve") << examples()[5].text << "bezier-subdivision";
        QTest::newRow("nothing") << QByteArray() << "column-scan";
    }
    void choosesTheMethodOfTheFirstPrimitive()
    {
        QFETCH(QByteArray, primitive);
        QFETCH(QString, method);

        const Result<SceneReading> reading = readScene(sceneWith(primitive));

        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        QCOMPARE(QString::fromStdString(reading->scene.method), method);
    }

    void reportsARadiusThatWasSnapped()
    {
        const Result<SceneReading> reading = readScene(sceneWith(
            json("{ 'circle': { 'centre': [5, 6], 'radius': 0.1 }, 'color': '#cc7722' }")));

        QVERIFY(reading.isOk());
        QCOMPARE(reading->snaps.size(), std::size_t(1));
        QCOMPARE(reading->snaps.front().message(),
                 QStringLiteral("primitives[0].circle.radius: 0.1 is drawn at 13/128, displaced by "
                                "1/640 px"));
    }

    void namesTheFaultAndItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QByteArray &primitive, const char *message) {
            QTest::newRow(name) << sceneWith(primitive) << QString::fromUtf8(message);
        };
        row("misspelt kind", json("{ 'lines': [[0, 0], [1, 1]], 'colors': [] }"),
            "line 3, column 12, primitives[0].lines: unknown key “lines”; expected one of "
            "triangle, points, line, circle, ellipse, bezier, polygon, text, color, colors, fill");
        row("no kind", json("{ 'colors': [] }"),
            "line 3, column 1, primitives[0]: no primitive is named; expected one of triangle, "
            "points, line, circle, ellipse, bezier, polygon, text");
        row("two kinds", json("{ 'line': [[0, 0], [1, 1]], 'text': 'a', 'colors': [] }"),
            "line 3, column 37, primitives[0].text: unknown key “text”; expected one of line, "
            "colors");
        row("a number", "7", "line 3, column 1, primitives[0]: 7; expected an object");
        row("a fill for a line",
            json("{ 'line': [[0, 0], [1, 1]], 'colors': ['#000000', '#000000'], 'fill': 'outline' "
                 "}"),
            "line 3, column 71, primitives[0].fill: unknown key “fill”; expected one of line, "
            "colors");
        row("a line of three points", json("{ 'line': [[0, 0], [1, 1], [2, 2]], 'colors': [] }"),
            "line 3, column 11, primitives[0].line: an array of 3; expected an array of 2 points");
        row("no points", json("{ 'points': [], 'colors': [] }"),
            "line 3, column 13, primitives[0].points: an array of 0; expected an array of 1 "
            "points or more");
        row("too few colours", json("{ 'points': [[1, 1], [2, 2]], 'colors': ['#000000'] }"),
            "line 3, column 41, primitives[0].colors: an array of 1; expected an array of 2");
        row("radius 0", json("{ 'circle': { 'centre': [0, 0], 'radius': 0 }, 'color': '#000000' }"),
            "line 3, column 43, primitives[0].circle.radius: a radius of 0 px; expected 1/256 px "
            "or more");
        row("radius that snaps to 0",
            json("{ 'circle': { 'centre': [0, 0], 'radius': 0.001 }, 'color': '#000000' }"),
            "line 3, column 43, primitives[0].circle.radius: a radius of 0 px; expected 1/256 px "
            "or more");
        row("negative radius",
            json("{ 'ellipse': { 'centre': [0, 0], 'radii': [2, -3] }, 'color': '#000000' }"),
            "line 3, column 47, primitives[0].ellipse.radii[1]: a radius of -3 px; expected 1/256 "
            "px or more");
        row("one radius of an ellipse",
            json("{ 'ellipse': { 'centre': [0, 0], 'radius': 2 }, 'color': '#000000' }"),
            "line 3, column 44, primitives[0].ellipse.radius: unknown key “radius”; expected one "
            "of centre, radii");
        row("a circle that leaves the lattice",
            json("{ 'circle': { 'centre': [0, 1], 'radius': 1073741824 }, 'color': '#000000' }"),
            "line 3, column 13, primitives[0].circle: the circle leaves ±1073741824 px; expected a "
            "smaller radius or another centre");
        row("another fill",
            json("{ 'circle': { 'centre': [0, 0], 'radius': 2 }, 'color': '#000000', 'fill': "
                 "'even-odd' }"),
            "line 3, column 76, primitives[0].fill: “even-odd”; expected one of outline, filled");
        row("two control points", json("{ 'bezier': [[0, 0], [1, 1]], 'color': '#000000' }"),
            "line 3, column 13, primitives[0].bezier: an array of 2; expected an array of 3 points "
            "or 4");
        row("a polygon of two", json("{ 'polygon': [[0, 0], [1, 1]], 'color': '#000000' }"),
            "line 3, column 14, primitives[0].polygon: an array of 2; expected an array of 3 "
            "points or more");
        row("no contour", json("{ 'polygon': { 'contours': [] }, 'color': '#000000' }"),
            "line 3, column 28, primitives[0].polygon.contours: no contour; expected one or more "
            "arrays of points");
        row("a contour of two",
            json("{ 'polygon': { 'contours': [[[0, 0], [1, 1], [2, 0]], [[0, 0], [1, 1]]] }, "
                 "'color': '#000000' }"),
            "line 3, column 55, primitives[0].polygon.contours[1]: an array of 2; expected an "
            "array of 3 points or more");
        row("no colour", json("{ 'bezier': [[0, 0], [1, 1], [2, 0]] }"),
            "line 3, column 1, primitives[0].color: nothing; expected a string");
        row("text without height", json("{ 'text': 'a', 'at': [0, 0], 'color': '#000000' }"),
            "line 3, column 1, primitives[0].height: nothing; expected a coordinate such as 26, "
            "26.5 or 53/2 within ±1073741824 px");
        row("text of height 0",
            json("{ 'text': 'a', 'at': [0, 0], 'height': 0, 'color': '#000000' }"),
            "line 3, column 40, primitives[0].height: a height of 0 px; expected 1/256 px or more");
        row("coordinate too large", json("{ 'line': [[0, 0], [1, 3e9]], 'colors': [] }"),
            "line 3, column 24, primitives[0].line[1][1]: 3000000000 is outside ±1073741824 px; "
            "expected a coordinate such as 26, 26.5 or 53/2 within ±1073741824 px");
        row("a triangle after a line",
            json("{ 'line': [[0, 0], [1, 1]], 'colors': ['#000000', '#000000'] },\n{ 'triangle': "
                 "[[0, 0], [4, 0], [0, 4]], 'colors': ['#ff0000', '#00ff00', '#0000ff'] }"),
            "line 4, column 15, primitives[1].triangle: a triangle after another primitive; "
            "expected all triangles first: they are drawn before the others");
    }
    void namesTheFaultAndItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);

        QCOMPARE(errorOf(text), message);
    }

    void keepsAMethodThatDrawsNoneOfThePrimitivesYet()
    {
        // A window can save such a scene, so it has to open again.
        const Result<SceneReading> reading
            = readScene(sceneWith(examples()[1].text, "\"method\": \"column-scan\", "));
        QVERIFY(reading.isOk());
        QCOMPARE(reading->scene.method, std::string("column-scan"));
        QVERIFY(readScene(writeScene(reading->scene)).isOk());
    }

    void takesTheMethodsArithmeticAndRuleWhereTheSceneNamesNone()
    {
        const auto settingsOf = [](const Example &example, const QByteArray &members) {
            return readScene(sceneWith(example.text, members))->scene.settings;
        };
        QCOMPARE(settingsOf(examples()[2], "\"method\": \"circle-parametric\", ").arithmetic,
                 Arithmetic::Float64);
        QCOMPARE(settingsOf(examples()[7], {}).fillRule, FillRule::TopLeft);
        QCOMPARE(settingsOf(examples()[1], {}).fillRule, FillRule::Closed);
    }

    void refusesAnArithmeticThatTheMethodDoesNotKnow()
    {
        QCOMPARE(
            errorOf(sceneWith(examples()[2].text,
                              "\"method\": \"circle-parametric\", \"arithmetic\": \"exact\", ")),
            QStringLiteral("line 2, column 46, arithmetic: method “circle-parametric” does not "
                           "compute in “exact”; it knows float64, float32"));
    }

    void refusesEveryTextThatIsCutShort()
    {
        QByteArray primitives;
        for (const Example &example : examples())
            primitives += (primitives.isEmpty() ? "" : ",\n") + example.text;
        const QByteArray text = sceneWith(primitives);
        QVERIFY(readScene(text).isOk());
        for (qsizetype length = 0; length < text.size(); ++length)
            QVERIFY2(!readScene(text.first(length)).isOk(), qPrintable(QString::number(length)));
    }

    void survivesAnyByteThatIsWrong()
    {
        for (const Example &example : examples()) {
            const QByteArray text = sceneWith(example.text);
            for (qsizetype position = 0; position < text.size(); ++position) {
                for (const char wrong : {'\0', '"', '{', ']', '9', '-', '\\', '\xff'}) {
                    QByteArray damaged = text;
                    damaged[position] = wrong;
                    const Result<SceneReading> reading = readScene(damaged);
                    if (!reading)
                        QVERIFY(!reading.error().message().isEmpty());
                    else
                        QVERIFY(readScene(writeScene(reading->scene)).isOk());
                }
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestShapeScenes)
#include "tst_shapescenes.moc"
