// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "tests/support/scenes/scenetext.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_scenefaults {

using namespace pixelplumb;

namespace {

QByteArray frameOf(const QByteArray &frame)
{
    return "{ \"pixelplumb\": 1, \"frame\": " + frame + ", \"primitives\": [] }";
}

} // namespace

/// What the reader says about a faulty scene: the fault and its position in the text.
class TestSceneFaults : public QObject {
    Q_OBJECT

private slots:
    void namesTheFaultAndItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QByteArray &text, const char *message) {
            QTest::newRow(name) << text << QString::fromUtf8(message);
        };
        const char *primitives = "\"primitives\": []";
        row("empty", "", "the input is empty; expected JSON");
        row("a key twice, once by its codes",
            R"({ "pixelplumb": 1, "frame": { "width": 8, "w\u0069dth": 9, "height": 8 } })",
            "line 1, column 57, frame.width: the key is there twice; expected every key once");
        row("a key twice, both by codes", R"({ "\u0061": 1, "\u0061": 2 })",
            "line 1, column 26, a: the key is there twice; expected every key once");
        row("blank", " \n ", "the input is empty; expected JSON");
        row("an array", "[1]",
            "line 1, column 1, pixelplumb: no format number: this is no Pixelplumb scene; expected "
            "\"pixelplumb\": 1");
        row("some other object", "{\"a\": 1}",
            "line 1, column 1, pixelplumb: no format number: this is no Pixelplumb scene; expected "
            "\"pixelplumb\": 1");
        row("newer", "{\"new\": true,\n \"pixelplumb\": 2}",
            "line 2, column 16, pixelplumb: written by a newer Pixelplumb (format 2); expected a "
            "format up "
            "to 1, the newest that this one reads");
        row("version zero", "{\"pixelplumb\": 0}",
            "line 1, column 16, pixelplumb: 0; expected the integer 1");
        row("version as text", "{\"pixelplumb\": \"1\"}",
            "line 1, column 16, pixelplumb: “1”; expected the integer 1");
        row("unknown key", sceneWith("  \"fillrule\": \"closed\", \"primitives\": []"),
            "line 4, column 15, fillrule: unknown key “fillrule”; expected one of pixelplumb, "
            "frame, method, "
            "arithmetic, fillRule, offScreenPoint, rounding, variants, camera, motion, materials, "
            "lights, ambient, "
            "shading, depth, depthBits, antialiasing, primitives");
        row("key twice", sceneWith("  \"primitives\": [],\n  \"primitives\": []"),
            "line 5, column 17, primitives: the key is there twice; expected every key once");
        row("key twice, deep", frameOf(R"({ "width": 1, "height": 2, "width": 3 })"),
            "line 1, column 65, frame.width: the key is there twice; expected every key once");
        row("no frame", QByteArray("{ \"pixelplumb\": 1, ") + primitives + "}",
            "line 1, column 1, frame: nothing; expected an object");
        row("no primitives", sceneWith("\"fillRule\": \"closed\""),
            "line 1, column 1, primitives: nothing; expected an array");
        row("width missing", frameOf(R"({ "height": 2 })"),
            "line 1, column 29, frame.width: nothing; expected an integer from 1 to 32768");
        row("width 0", frameOf(R"({ "width": 0, "height": 2 })"),
            "line 1, column 40, frame.width: 0; expected an integer from 1 to 32768");
        row("width too large", frameOf(R"({ "width": 32769, "height": 2 })"),
            "line 1, column 40, frame.width: 32769; expected an integer from 1 to 32768");
        row("width with a fraction", frameOf(R"({ "width": 2.5, "height": 2 })"),
            "line 1, column 40, frame.width: 2.5; expected an integer from 1 to 32768");
        row("width beyond 64 bits", frameOf(R"({ "width": 1e30, "height": 2 })"),
            "line 1, column 40, frame.width: 1e30; expected an integer from 1 to 32768");
        row("area too large", frameOf(R"({ "width": 32768, "height": 32768 })"),
            "line 1, column 40, frame.width: 32768 × 32768 are 1073741824 pixels; expected at most "
            "268435456 "
            "pixels");
        row("first pixel too far",
            frameOf(R"({ "width": 1, "height": 1, "firstPixel": [0, 1073741825] })"),
            "line 1, column 74, frame.firstPixel[1]: 1073741825; expected an integer from "
            "-1073741824 to "
            "1073741824");
        row("origin", frameOf(R"({ "width": 1, "height": 1, "origin": "top-right" })"),
            "line 1, column 66, frame.origin: “top-right”; expected one of bottom-left, top-left");
        row("background", frameOf(R"({ "width": 1, "height": 1, "background": "black" })"),
            "line 1, column 70, frame.background: “black” is no colour; expected #rrggbb or "
            "#rrggbbaa in hexadecimal digits");
        row("blending", frameOf("{ \"width\": 1, \"height\": 1, \"background\": \"#f0203080\" }"),
            "line 1, column 70, frame.background: “#f0203080” is not opaque, and only triangles "
            "are blended; expected alpha ff, or #rrggbb without alpha");
        row("name that ends early",
            sceneWith(R"("materials": { "a": { "texture": "f.png\u0000" } }, "primitives": [])"),
            "line 4, column 34, materials.a.texture: a string with the character U+0000; expected "
            "one without it");
        row("rule that the method does not keep",
            sceneWith(
                R"("fillRule": "off-screen-point", "method": "column-scan", "primitives": [])"),
            "line 4, column 13, fillRule: method “column-scan” cannot keep the fill rule "
            "“off-screen-point”: "
            "a column ends at its two bounds whatever edge they belong to; it keeps closed, "
            "half-open-column, open");
        row("coordinate too large", sceneOfTriangleAt("3e9"),
            "line 5, column 21, primitives[0].triangle[0][0]: 3e9 is outside ±1073741824 "
            "px; expected "
            "a coordinate such as 26, 26.5 or 53/2 within ±1073741824 px");
        row("coordinate nan", sceneOfTriangleAt("\"nan\""),
            "line 5, column 21, primitives[0].triangle[0][0]: “nan” is no coordinate; expected a "
            "coordinate "
            "such as 26, 26.5 or 53/2 within ±1073741824 px");
        row("coordinate null", sceneOfTriangleAt("null"),
            "line 5, column 21, primitives[0].triangle[0][0]: null; expected a coordinate such as "
            "26, 26.5 "
            "or 53/2 within ±1073741824 px");
        row("two vertices",
            sceneWith(R"("primitives": [{ "triangle": [[0, 0], [1, 1]], "colors": [] }])"),
            "line 4, column 30, primitives[0].triangle: an array of 2; expected an array of 3");
        row("three coordinates",
            sceneWith(
                R"("primitives": [{ "triangle": [[0, 0, 0], [1, 1], [2, 0]], "colors": [0, 0, 0] }])"),
            "line 4, column 31, primitives[0].triangle[0]: an array of 3; expected an array of 2");
        row("no colours", sceneWith(R"("primitives": [{ "triangle": [[0, 0], [1, 1], [2, 0]] }])"),
            "line 4, column 16, primitives[0].colors: nothing; expected an array");
        row("after an umlaut", QByteArray("{\"ä\": 1,\"ä\": 2}"),
            "line 1, column 14, ä: the key is there twice; expected every key once");
    }
    void namesTheFaultAndItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);

        QCOMPARE(errorOf(text), message);
    }

    void namesAllMethodsWhereThereIsNoSuchOne()
    {
        QStringList ids;
        for (const Method &method : methods())
            ids.append(method.id);

        QCOMPARE(errorOf(sceneWith(R"("method": "raytracer", "primitives": [])")),
                 QStringLiteral("line 4, column 11, method: “raytracer”; expected one of ")
                     + ids.join(QStringLiteral(", ")));
    }

    void tellsLineAndColumnOfASyntaxError()
    {
        const Result<SceneReading> reading = readScene("{\n  \"pixelplumb\": 1,\n  oops\n}");

        QVERIFY(!reading.isOk());
        QVERIFY2(reading.error().place.startsWith(QStringLiteral("line 3, column ")),
                 qPrintable(reading.error().message()));
    }

    void refusesNestingWithoutEnd()
    {
        QVERIFY(!readScene(QByteArray(100000, '[')).isOk());
        QVERIFY(!readScene(QByteArray(100000, '[') + QByteArray(100000, ']')).isOk());
    }

    void tellsTheSameFaultOfALargeTextAsOfASmallOne_data()
    {
        QTest::addColumn<QByteArray>("wrong"); // replaces the middle triangle
        QTest::newRow("unknown key") << QByteArray("{ \"triangel\": [[0, 0], [1, 1], [2, 0]] }");
        QTest::newRow("missing colours")
            << QByteArray("{ \"triangle\": [[0, 0], [1, 1], [2, 0]] }");
        QTest::newRow("coordinate") << QByteArray(triangle).replace("9", "\"nan\"");
        QTest::newRow("key twice")
            << QByteArray(triangle).replace("\"colors\"", "\"triangle\": 1, \"colors\"");
        QTest::newRow("number") << QByteArray("5");
        QTest::newRow("text") << QByteArray("\"triangle\"");
        QTest::newRow("empty") << QByteArray("{}");
    }
    void tellsTheSameFaultOfALargeTextAsOfASmallOne()
    {
        QFETCH(QByteArray, wrong);
        const auto textOf = [&](int before, int after) {
            QByteArray text = "{ \"pixelplumb\": 1, \"frame\": { \"width\": 9, \"height\": 9 },\n"
                              "\"primitives\": [\n";
            for (int i = 0; i < before; ++i)
                text += triangle + ",\n";
            text += wrong;
            for (int i = 0; i < after; ++i)
                text += ",\n" + triangle;
            return text + "] }";
        };
        const QByteArray large = textOf(7, 20'000);
        QVERIFY(large.size() > shortText);

        QCOMPARE(errorOf(large), errorOf(textOf(7, 1)));
        QVERIFY(errorOf(large) != QStringLiteral("no error"));
    }

    void findsWhereALargeTextIsNoJson_data()
    {
        QTest::addColumn<QByteArray>("end"); // of the text, after many lines
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const char *end, const char *message) {
            QTest::newRow(name) << QByteArray(end) << QString::fromUtf8(message);
        };
        row("cut", "{ \"triangle\": [[0, 0], [1,", "column 27: the text ends; expected a value");
        row("open", "{} ", "column 4: the text ends; expected “,” or “]”");
        row("comma", "{}, ] }", "column 5: “] }”; expected a value");
        row("bracket", "{ ] }", "column 3: “] }”; expected a key in quotation marks");
        row("crossed", "[[1, 2}] }", "column 7: “}] }”; expected “,” or “]”");
        row("key", "{ colors: 1 }] }", "column 3: “colors:”; expected a key in quotation marks");
        row("colon", "{ \"a\" 1 }] }", "column 7: “1 }] }”; expected “:”");
        row("string", "\"abc", "column 5: the text ends; expected the end of a string");
        row("escape", "\"a\\q\"] }", "column 3: “\\q\"] }”; expected one of");
        row("number", "1.] }", "column 3: “] }”; expected a digit");
        row("zero", "012] }", "column 2: “12] }”; expected “,” or “]”");
        row("word", "nil] }", "column 1: “nil] }”; expected a value");
        row("after", "{}] } x", "column 7: “x”; expected the text's end");
    }
    void findsWhereALargeTextIsNoJson()
    {
        QFETCH(QByteArray, end);
        QFETCH(QString, message);
        QByteArray text = "{ \"pixelplumb\": 1, \"frame\": { \"width\": 9, \"height\": 9 },\n"
                          "\"primitives\": [\n";
        constexpr int lines = 20'000;
        for (int i = 0; i < lines; ++i)
            text += triangle + ",\n";

        const QString error = errorOf(text + end);

        QVERIFY2(error.startsWith(QStringLiteral("line %1, ").arg(lines + 3)), qPrintable(error));
        QVERIFY2(error.contains(message), qPrintable(error));
    }

private:
    const QByteArray triangle
        = QByteArray("{ 'triangle': [[0, 0], [9, 1], [2, 8]], 'colors': ['#ff0000', '#00ff00', "
                     "'#0000ff'] }")
              .replace('\'', '"');
};

PIXELPLUMB_TEST(TestSceneFaults)

} // namespace tst_scenefaults

#include "tst_scenefaults.moc"
