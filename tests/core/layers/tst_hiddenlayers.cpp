// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/layerlook.h"

#include <QTest>

#include <algorithm>
#include <set>

namespace tst_hiddenlayers {

using namespace pixelplumb;

namespace {

Scene triangleBy(const char *method)
{
    Scene scene;
    scene.method = method;
    const Colour red = {{255, 0, 0}}, green = {{0, 255, 0}}, blue = {{0, 0, 255}};
    scene.triangles = {
        {{{{latticePixel(2, 1), red}, {latticePixel(17, 4), green}, {latticePixel(6, 13), blue}}}}};
    return scene;
}

Scene polygonBy(const char *method)
{
    Shape polygon;
    polygon.kind = PrimitiveKind::Polygon;
    polygon.fill = ShapeFill::EvenOdd;
    for (const QPoint &corner : {QPoint(0, 0), QPoint(12, 0), QPoint(12, 9), QPoint(2, 9)})
        polygon.vertices.push_back({latticePixel(corner.x(), corner.y()), Colour()});
    return sceneOf(polygon, method, {});
}

Scene pointsBy(const char *method)
{
    Shape points;
    points.kind = PrimitiveKind::Point;
    for (int i = 0; i < 4; ++i)
        points.vertices.push_back({latticePixel(3 * i, i), Colour()});
    return sceneOf(points, method, {});
}

/// A run as a student sees it while predicting.
struct HiddenLook : Look {
    explicit HiddenLook(const Scene &scene)
        : Look(scene)
    {
        view.ahead = Ahead::Hidden;
    }

    void seekToSpan(std::size_t span) { view.position = traced->trace->indexOfSpan(span) + 1; }

    std::set<std::pair<std::int64_t, std::int64_t>> visited() const
    {
        std::set<std::pair<std::int64_t, std::int64_t>> pixels;
        for (std::size_t i = 0; i < traced->trace->samplesDoneAt(view.position); ++i) {
            const PixelChange change = traced->trace->changes()[i];
            pixels.emplace(change.x, change.y);
        }
        return pixels;
    }
};

QStringList allLayers()
{
    QStringList ids;
    for (const Layer &layer : layers())
        ids.append(layer.id);
    return ids;
}

bool startsWith(const QStringList &texts, const QString &beginning)
{
    return std::ranges::any_of(
        texts, [&beginning](const QString &text) { return text.startsWith(beginning); });
}

} // namespace

/// Layers show nothing of what a student is asked to predict.
class TestHiddenLayers : public QObject {
    Q_OBJECT

private slots:
    void numbersAppearOnlyInVisitedCells_data()
    {
        QTest::addColumn<QByteArray>("method");
        for (const char *method :
             {"column-scan", "row-walk", "edge-equations", "barycentric-rectangle",
              "barycentric-cramer", "barycentric-incremental", "interpolate-plane"})
            QTest::newRow(method) << QByteArray(method);
    }
    void numbersAppearOnlyInVisitedCells()
    {
        QFETCH(QByteArray, method);
        HiddenLook look(triangleBy(method.constData()));
        for (const char *layer : {"weights", "levels"}) {
            look.seekToSpan(look.traced->trace->spanCount() / 2);
            const auto visited = look.visited();
            QVERIFY(!visited.empty());
            const LayerDrawing drawing = look.drawing(layer);
            QVERIFY(!drawing.cells.empty());
            for (const LayerDrawing::CellText &text : drawing.cells)
                QVERIFY(visited.contains({text.x, text.y}));
        }
    }

    void theSetUpIsNoSecretOnceItIsDone()
    {
        HiddenLook look(triangleBy("edge-equations"));
        look.view.position = 0;
        LayerDrawing drawing = look.drawing("half-planes");
        QVERIFY(drawing.isEmpty());
        QCOMPARE(drawing.notes, QStringList("Half-planes and normals: the set-up is still ahead"));
        look.view.position = 1;
        drawing = look.drawing("half-planes");
        look.view.ahead = Ahead::Shown;
        QVERIFY(drawing == look.drawing("half-planes"));
        QVERIFY(!drawing.isEmpty());
    }

    void aFinishedRunHasNoSecrets_data()
    {
        QTest::addColumn<Scene>("scene");
        QTest::newRow("columns") << triangleBy("column-scan");
        QTest::newRow("edges") << triangleBy("edge-equations");
        QTest::newRow("fan") << polygonBy("polygon-fan");
        QTest::newRow("points") << pointsBy("point-address");
    }
    void aFinishedRunHasNoSecrets()
    {
        QFETCH(Scene, scene);
        HiddenLook look(scene);
        QVERIFY(!look.traced->scene.method.empty());
        const LayerDrawing hidden = drawingOf(allLayers(), look.view);
        look.view.ahead = Ahead::Shown;
        QVERIFY(!hidden.isEmpty());
        QVERIFY(hidden == drawingOf(allLayers(), look.view));
    }

    void contourLinesComeWhenTheLevelsAreThere()
    {
        HiddenLook look(triangleBy("column-scan"));
        look.seekToSpan(5);
        QVERIFY(look.drawing("isolines-red").isEmpty());
        QCOMPARE(look.drawing("isolines-red").notes,
                 QStringList("Contour lines of R: levels are still ahead"));
        look.view.position = look.traced->trace->stepCount();
        QVERIFY(!look.drawing("isolines-red").isEmpty());
    }

    void theBoxGrowsWithTheRowsThatAreTested()
    {
        HiddenLook look(triangleBy("edge-equations"));
        look.view.position = 1;
        QVERIFY(!startsWith(textsOf(look.drawing("box").labels), u"tested"_s));
        look.seekToSpan(3);
        QVERIFY(textsOf(look.drawing("box").labels).contains(u"tested: x 2 … 17, y 1 … 4"_s));
        look.view.ahead = Ahead::Shown;
        QVERIFY(textsOf(look.drawing("box").labels).contains(u"tested: x 2 … 17, y 1 … 13"_s));
    }

    void weightsOfAPickedPixelAreToldWhenItIsDrawn()
    {
        HiddenLook look(triangleBy("column-scan"));
        look.seekToSpan(4);
        const auto hasWeights
            = [&look] { return startsWith(textsOf(look.drawing("affine-map").labels), u"p: α"_s); };
        const std::size_t next = look.traced->trace->firstSampleOf(4);
        const PixelChange change = look.traced->trace->changes()[next];
        look.view.picked = QPoint(change.x, change.y);
        QVERIFY(!hasWeights());
        QVERIFY(
            look.drawing("affine-map").notes.contains(u"Affine map: weights are still ahead"_s));
        ++look.view.position;
        QVERIFY(hasWeights());
        look.view.picked = QPoint(40, 40); // outside the triangle, before any step has decided it
        QVERIFY(!hasWeights());
    }

    void trianglesOfAPolygonAreThoseThatAreBegun()
    {
        HiddenLook look(polygonBy("polygon-fan"));
        const ScanTrace &trace = *look.traced->trace;
        look.seekToSpan(0);
        QCOMPARE(textsOf(look.drawing("inner-edges").labels), QStringList("0"));
        QCOMPARE(look.drawing("inner-edges").lines.size(), std::size_t(3));
        // The edge that the second one shares with it still counts as an inner one.
        QCOMPARE(std::ranges::count(look.drawing("inner-edges").lines, LayerDrawing::Stroke::Solid,
                                    &LayerDrawing::Line::stroke),
                 std::ptrdiff_t(1));
        look.seekToSpan(trace.spanCount() - 1);
        QCOMPARE(textsOf(look.drawing("inner-edges").labels), QStringList({"0", "1"}));
    }

    void anAddressThatIsAskedForIsNotInItsCell()
    {
        HiddenLook look(pointsBy("point-address"));
        look.seekToSpan(2);
        QCOMPARE(look.drawing("memory").cells.size(), std::size_t(2));
        // Other methods have nothing to predict here.
        HiddenLook columns(triangleBy("column-scan"));
        const FrameSpec &frame = columns.traced->scene.frame;
        columns.seekToSpan(2);
        QCOMPARE(columns.drawing("memory").cells.size(), std::size_t(frame.width * frame.height));
    }
};

PIXELPLUMB_TEST(TestHiddenLayers)

} // namespace tst_hiddenlayers

#include "tst_hiddenlayers.moc"
