// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenefile.h"
#include "tests/support/scenes/shapeexamples.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_shapescenes {

using namespace pixelplumb;

/// Scenes with primitives that are not triangles.
class TestShapeScenes : public QObject {
    Q_OBJECT

private slots:
    void readsAndWritesEveryKindOfPrimitive_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<Shape>("shape");
        for (const ShapeExample &example : shapeExamples())
            QTest::newRow(example.text.constData()) << example.text << example.shape;
    }
    void readsAndWritesEveryKindOfPrimitive()
    {
        QFETCH(QByteArray, text);
        QFETCH(Shape, shape);

        const Result<SceneReading> reading = readScene(sceneOfPrimitives(text));

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
        for (const ShapeExample &example : shapeExamples())
            primitives += ",\n" + example.text;

        const Result<SceneReading> reading = readScene(sceneOfPrimitives(primitives));

        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        QCOMPARE(reading->scene.triangles.size(), std::size_t(1));
        QCOMPARE(reading->scene.shapes.size(), shapeExamples().size());
        QCOMPARE(readScene(writeScene(reading->scene))->scene, reading->scene);
    }

    void leavesOutWhatHasADefault()
    {
        const auto fillOf = [](const QByteArray &primitive) {
            return readScene(sceneOfPrimitives(primitive))->scene.shapes.front().fill;
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
        QTest::newRow("line") << shapeExamples()[1].text << "line-dda";
        QTest::newRow("points") << shapeExamples()[0].text << "point-address";
        QTest::newRow("outlined circle") << shapeExamples()[2].text << "circle-midpoint";
        QTest::newRow("filled circle") << shapeExamples()[3].text << "circle-fill";
        QTest::newRow("curve") << shapeExamples()[5].text << "bezier-subdivision";
        QTest::newRow("filled polygon") << shapeExamples()[7].text << "polygon-parity";
        QTest::newRow("outlined polygon") << shapeExamples()[10].text << "polygon-outline";
        QTest::newRow("filled curve") << shapeExamples()[11].text << "bezier-fill";
        QTest::newRow("filled path") << shapeExamples()[12].text << "bezier-fill";
        QTest::newRow("nothing") << QByteArray() << "column-scan";
    }
    void choosesTheMethodOfTheFirstPrimitive()
    {
        QFETCH(QByteArray, primitive);
        QFETCH(QString, method);

        const Result<SceneReading> reading = readScene(sceneOfPrimitives(primitive));

        QVERIFY2(reading.isOk(), reading ? "" : qPrintable(reading.error().message()));
        QCOMPARE(QString::fromStdString(reading->scene.method), method);
    }

    void reportsARadiusThatWasSnapped()
    {
        const Result<SceneReading> reading = readScene(sceneOfPrimitives(
            json("{ 'circle': { 'centre': [5, 6], 'radius': 0.1 }, 'color': '#cc7722' }")));

        QVERIFY(reading.isOk());
        QCOMPARE(reading->snaps.size(), std::size_t(1));
        QCOMPARE(reading->snaps.front().message(),
                 u"primitives[0].circle.radius: 0.1 is drawn at 13/128, displaced by "
                 "1/640 px"_s);
    }

    void keepsAMethodThatDrawsNoneOfThePrimitivesYet()
    {
        // A window can save such a scene, so it must open again.
        const Result<SceneReading> reading = readScene(
            sceneOfPrimitives(shapeExamples()[1].text, "\"method\": \"column-scan\", "));
        QVERIFY(reading.isOk());
        QCOMPARE(reading->scene.method, std::string("column-scan"));
        QVERIFY(readScene(writeScene(reading->scene)).isOk());
    }

    void takesTheMethodsArithmeticAndRuleWhereTheSceneNamesNone()
    {
        const auto settingsOf = [](const ShapeExample &example, const QByteArray &members) {
            return readScene(sceneOfPrimitives(example.text, members))->scene.settings;
        };
        QCOMPARE(settingsOf(shapeExamples()[2], "\"method\": \"circle-parametric\", ").arithmetic,
                 Arithmetic::Float64);
        QCOMPARE(settingsOf(shapeExamples()[7], {}).fillRule, FillRule::TopLeft);
        QCOMPARE(settingsOf(shapeExamples()[1], {}).fillRule, FillRule::Closed);
    }
};

PIXELPLUMB_TEST(TestShapeScenes)

} // namespace tst_shapescenes

#include "tst_shapescenes.moc"
