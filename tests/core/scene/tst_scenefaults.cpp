// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "tests/support/scenes/scenetext.h"
#include "tests/support/scenes/shapeexamples.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <array>

namespace tst_scenefaults {

using namespace pixelplumb;

namespace {

const QByteArray triangle
    = R"({ "triangle": [[0, 0], [9, 1], [2, 8]], "colors": ["#ff0000", "#00ff00", "#0000ff"] })";

} // namespace

/// What the reader says about a faulty scene: the fault and its position in the text.
class TestSceneFaults : public QObject {
    Q_OBJECT

private slots:
    /// tests/data/scene_faults.txt: after # what is wrong, then the text, after ! the message;
    /// "..." stands for the first lines of a scene of 64 × 48 pixels.
    void everyFaultSaysWhereAndWhatWasExpected_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const QString faults = textInTree(u"tests/data/scene_faults.txt"_s);
        for (const QString &fault : (u'\n' + faults).split(u"\n# "_s).sliced(1)) {
            const qsizetype text = fault.indexOf(u'\n') + 1;
            const qsizetype message = fault.indexOf(u"\n! "_s);
            const QByteArray written = fault.sliced(text, message - text).toUtf8();
            QTest::newRow(qPrintable(fault.first(text - 1)))
                << (written.startsWith("...\n") ? sceneWith(written.sliced(4)) : written)
                << fault.sliced(message + 3).trimmed();
        }
    }
    void everyFaultSaysWhereAndWhatWasExpected()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);
        QCOMPARE(errorOf(text), message);
    }

    void aTextOfNothingIsNoJson()
    {
        for (const char *text : {"", " \n "})
            QCOMPARE(errorOf(text), u"the input is empty; expected JSON"_s);
    }

    void namesAllMethodsWhereThereIsNoSuchOne()
    {
        QStringList ids;
        for (const Method &method : methods())
            ids.append(method.id);

        QCOMPARE(errorOf(sceneWith(R"("method": "raytracer", "primitives": [])")),
                 u"line 4, column 11, method: “raytracer”; expected one of "_s + ids.join(u", "_s));
    }

    void tellsLineAndColumnOfASyntaxError()
    {
        const Result<SceneReading> reading = readScene("{\n  \"pixelplumb\": 1,\n  oops\n}");

        QVERIFY(!reading.isOk());
        QVERIFY2(reading.error().place.startsWith(u"line 3, column "_s),
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
        QVERIFY(errorOf(large) != u"no error"_s);
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

        QVERIFY2(error.startsWith(u"line %1, "_s.arg(lines + 3)), qPrintable(error));
        QVERIFY2(error.contains(message), qPrintable(error));
    }

    void refusesAnArithmeticThatTheMethodDoesNotKnow()
    {
        QCOMPARE(errorOf(sceneOfPrimitives(
                     shapeExamples()[2].text,
                     "\"method\": \"circle-parametric\", \"arithmetic\": \"exact\", ")),
                 u"line 2, column 46, arithmetic: method “circle-parametric” does not "
                 "compute in “exact”; it knows float64, float32"_s);
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
            << u"line 5, column 14, primitives[2].polygon: with it the scene's shapes "
               "have 3145728 vertices, 20 for each character of a text; expected at most "
               "2097152"_s;
        QTest::newRow("characters")
            << "{ \"text\": \"" + QByteArray(most / 20 + 1, 'a')
                + "\", \"at\": [0, 0], \"height\": 9, \"color\": \"#000000\" }"
            << u"line 3, column 11, primitives[0].text: with it the scene's shapes "
               "have 2097160 vertices"_s;
        QTest::newRow("values of one primitive")
            << "{ \"polygon\": [" + QByteArray("0,").repeated(16'777'216) + "0]}"
            << u"line 3, column 33554443, primitives[0].polygon[16777214]: a value too "
               "many; expected at most 16777216 in a file without primitives, or in "
               "one primitive"_s;
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

    void memoryIsReportedBeforeAllocation()
    {
        const QByteArray camera = "'camera': { 'eye': [0, 0, 5] },";
        const QByteArray sphere = "{ 'sphere': [0, 0, 0], 'radius': 1, 'segments': [1024, 1024] }";
        QVERIFY(readScene(sceneOf(camera, sphere)));
        const QString error = faultOf(sceneOf(camera, sphere + ", " + sphere));
        QVERIFY2(
            error.startsWith(
                u"primitives[1].sphere: the scene's solids are cut into 4190208 triangles, "_s),
            qPrintable(error));
        QVERIFY2(error.endsWith(u" MiB; expected at most 2097152 triangles"_s), qPrintable(error));
    }
};

PIXELPLUMB_TEST(TestSceneFaults)

} // namespace tst_scenefaults

#include "tst_scenefaults.moc"
