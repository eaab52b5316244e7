// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/scenetext.h"
#include "tests/support/scenes/shapeexamples.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <array>

namespace tst_shapefaults {

using namespace pixelplumb;

/// Faulty primitives that are not triangles: each fault is named with its position.
class TestShapeFaults : public QObject {
    Q_OBJECT

private slots:
    void namesTheFaultAndItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QByteArray &primitive, const char *message) {
            QTest::newRow(name) << sceneOfPrimitives(primitive) << QString::fromUtf8(message);
        };
        row("misspelt kind", json("{ 'lines': [[0, 0], [1, 1]], 'colors': [] }"),
            "line 3, column 12, primitives[0].lines: unknown key “lines”; expected one of "
            "triangle, points, line, circle, ellipse, bezier, polygon, text, triangle3, polygon3, "
            "plane, sphere, patch, mesh, color, colors, fill, hidden");
        row("no kind", json("{ 'colors': [] }"),
            "line 3, column 1, primitives[0]: no primitive is named; expected one of triangle, "
            "points, line, circle, ellipse, bezier, polygon, text, triangle3, polygon3, plane, "
            "sphere, patch, mesh");
        row("two kinds", json("{ 'line': [[0, 0], [1, 1]], 'text': 'a', 'colors': [] }"),
            "line 3, column 37, primitives[0].text: unknown key “text”; expected one of line, "
            "colors, hidden");
        row("a number", "7", "line 3, column 1, primitives[0]: 7; expected an object");
        row("a fill for a line",
            json("{ 'line': [[0, 0], [1, 1]], 'colors': ['#000000', '#000000'], 'fill': 'outline' "
                 "}"),
            "line 3, column 71, primitives[0].fill: unknown key “fill”; expected one of line, "
            "colors, hidden");
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
        row("a path that is not filled",
            json("{ 'bezier': { 'path': [[[0, 0], [1, 1], [2, 0]]] }, 'color': '#000000' }"),
            "line 3, column 13, primitives[0].bezier: a path that is not filled; expected "
            "\"fill\": \"even-odd\" or \"non-zero\"; without it, one curve of three or four "
            "points");
        row("no piece",
            json("{ 'bezier': { 'path': [] }, 'color': '#000000', 'fill': 'even-odd' }"),
            "line 3, column 23, primitives[0].bezier.path: no piece; expected one or more arrays "
            "of "
            "points");
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
            "line 3, column 24, primitives[0].line[1][1]: 3e9 is outside ±1073741824 px; "
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

    void refusesAnArithmeticThatTheMethodDoesNotKnow()
    {
        QCOMPARE(
            errorOf(sceneOfPrimitives(
                shapeExamples()[2].text,
                "\"method\": \"circle-parametric\", \"arithmetic\": \"exact\", ")),
            QStringLiteral("line 2, column 46, arithmetic: method “circle-parametric” does not "
                           "compute in “exact”; it knows float64, float32"));
    }

    void refusesEveryTextThatIsCutShort()
    {
        QByteArray primitives;
        for (const ShapeExample &example : shapeExamples())
            primitives += (primitives.isEmpty() ? "" : ",\n") + example.text;
        const QByteArray text = sceneOfPrimitives(primitives);
        QVERIFY(readScene(text).isOk());
        for (qsizetype length = 0; length < text.size(); ++length)
            QVERIFY2(!readScene(text.first(length)).isOk(), qPrintable(QString::number(length)));
    }

    void whatTakesTooMuchMemoryIsRefusedWithItsPlace_data()
    {
        QTest::addColumn<QByteArray>("primitives");
        QTest::addColumn<QString>("told");
        constexpr qsizetype most = 2'097'152;
        const QByteArray half = QByteArray("[0,0],").repeated(most / 2 - 1) + "[1,9]";
        const QByteArray polygon
            = "{ \"polygon\": [" + half + "], \"color\": \"#000000\", \"fill\": \"even-odd\" }";
        QTest::newRow("as many as may be") << polygon + ",\n" + polygon << QString();
        QTest::newRow("vertices of three polygons")
            << polygon + ",\n" + polygon + ",\n" + polygon
            << QStringLiteral(
                   "line 5, column 14, primitives[2].polygon: with it the scene's shapes "
                   "have 3145728 vertices, 20 for each character of a text; expected at most "
                   "2097152");
        QTest::newRow("characters")
            << "{ \"text\": \"" + QByteArray(most / 20 + 1, 'a')
                + "\", \"at\": [0, 0], \"height\": 9, \"color\": \"#000000\" }"
            << QStringLiteral("line 3, column 11, primitives[0].text: with it the scene's shapes "
                              "have 2097160 vertices");
        QTest::newRow("values of one primitive")
            << "{ \"polygon\": [" + QByteArray("0,").repeated(16'777'216) + "0]}"
            << QStringLiteral(
                   "line 3, column 33554443, primitives[0].polygon[16777214]: a value too "
                   "many; expected at most 16777216 in a file without primitives, or in "
                   "one primitive");
    }
    void whatTakesTooMuchMemoryIsRefusedWithItsPlace()
    {
        QFETCH(QByteArray, primitives);
        QFETCH(QString, told);
        const auto reading = readScene(sceneOfPrimitives(primitives));
        const QString message = reading ? QString() : reading.error().message();
        QCOMPARE(message.isEmpty(), told.isEmpty());
        QVERIFY2(message.startsWith(told), qPrintable(message));
    }

    void survivesAnyByteThatIsWrong()
    {
        constexpr std::array wrongBytes = {'\0', '"', '{', ']', '9', '-', '\\', '\xff'};
        for (const ShapeExample &example : shapeExamples()) {
            forEachDamaged(sceneOfPrimitives(example.text), wrongBytes,
                           [](const QByteArray &damaged) {
                               const Result<SceneReading> reading = readScene(damaged);
                               if (!reading)
                                   QVERIFY(!reading.error().message().isEmpty());
                               else
                                   QVERIFY(readScene(writeScene(reading->scene)).isOk());
                           });
        }
    }
};

PIXELPLUMB_TEST(TestShapeFaults)

} // namespace tst_shapefaults

#include "tst_shapefaults.moc"
