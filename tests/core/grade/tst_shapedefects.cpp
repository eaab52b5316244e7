// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/shapedefect.h"
#include "core/grade/diagnose/diagnosis.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_shapedefects {

using namespace pixelplumb;

namespace {

Scene sceneOf(const char *method, std::vector<Shape> shapes)
{
    Scene scene;
    scene.frame.width = 32;
    scene.frame.height = 24;
    scene.method = method;
    scene.shapes = std::move(shapes);
    if (scene.shapes.front().kind == PrimitiveKind::Polygon
        && scene.shapes.front().fill != ShapeFill::Outline)
        scene.settings.fillRule = FillRule::TopLeft;
    return scene;
}

/// With these vertices, px.
Shape shapeOf(PrimitiveKind kind, const std::vector<std::array<int, 2>> &points,
              ShapeFill fill = ShapeFill::Outline)
{
    Shape shape;
    shape.kind = kind;
    shape.fill = fill;
    for (const auto &[x, y] : points)
        shape.vertices.push_back({latticePixel(x, y), {{230, 180, 40}}});
    return shape;
}
Shape circle(int x, int y, int radius)
{
    return shapeOf(PrimitiveKind::Circle, {{x, y}, {x + radius, y + radius}});
}
Shape polygon(const std::vector<std::array<int, 2>> &points, ShapeFill fill)
{
    return shapeOf(PrimitiveKind::Polygon, points, fill);
}

/// One with a notch at the top.
Shape notched(ShapeFill fill)
{
    return polygon({{2, 2}, {14, 2}, {14, 12}, {10, 12}, {10, 6}, {6, 6}, {6, 12}, {2, 12}}, fill);
}
/// A contour that goes round twice, and one that lies in it and turns likewise.
Shape overlapping(ShapeFill fill)
{
    Shape shape = polygon(
        {{15, 3}, {29, 8}, {16, 20}, {25, 2}, {30, 15}, {12, 8}, {16, 5}, {22, 6}, {18, 12}}, fill);
    shape.laterContours = {6};
    return shape;
}

void addScenes()
{
    QTest::addColumn<Scene>("scene");
    const auto add = [](const char *method, std::vector<Shape> shapes) {
        QTest::newRow(method) << sceneOf(method, std::move(shapes));
    };
    Shape between = circle(8, 7, 3); // its centre is rounded
    for (Vertex &vertex : between.vertices)
        vertex.position = {vertex.position.x + halfPixel, vertex.position.y + halfPixel};
    // Two are cut by the frame: moved pictures lose what comes from outside.
    add("circle-midpoint",
        {circle(11, 12, 6), circle(20, 9, 5), between, circle(16, 21, 6), circle(2, 3, 5)});
    add("polygon-parity",
        {notched(ShapeFill::NonZero), overlapping(ShapeFill::NonZero),
         polygon({{1, 14}, {9, 22}, {3, 22}, {9, 14}, {7, 23}}, ShapeFill::EvenOdd)});
    add("polygon-outline", {notched(ShapeFill::Outline)});
    Shape across = shapeOf(PrimitiveKind::Line, {{2, 3}, {70, 40}});
    across.vertices[1].colour = {{10, 20, 250}};
    Shape upward = shapeOf(PrimitiveKind::Line, {{9, 20}, {-31, 7}});
    upward.vertices[1].colour = {{200, 20, 50}};
    add("line-dda",
        {upward, across, shapeOf(PrimitiveKind::Line, {{25, 4}, {20, 18}}),
         shapeOf(PrimitiveKind::Line, {{3, 15}, {14, 17}})});
}

} // namespace

/// Mistakes in how lines, circles and polygons are read each have a picture, a name, and draw what
/// their sentence says.
class TestShapeDefects : public QObject {
    Q_OBJECT

private slots:
    void eachIsNamedByItsPicture_data() { addScenes(); }
    void eachIsNamedByItsPicture()
    {
        QFETCH(Scene, scene);
        const std::vector<Defect> defects = shapeDefectsFor(scene);
        QVERIFY(defects.size() >= 2);
        const Picture right = pictureOf(scene);
        for (const Defect &defect : defects) {
            const Picture drawn = pictureWith(scene, std::span(&defect, 1));
            QVERIFY2(drawn.colours != right.colours, qPrintable(defect.id));
            const auto diagnosis = diagnose(std::vector{Submission{scene, drawn}});
            QVERIFY2(diagnosis->isExplained(), qPrintable(defect.id));
            QStringList named;
            for (const DiagnosisCandidate &candidate : diagnosis->candidates)
                named += candidate.ids().join(u'+');
            QCOMPARE(named.join(u' '), defect.id);
        }
    }

    void withoutItsLastEdgeAPolygonIsFilledBetweenTheOthers()
    {
        const Scene scene = sceneOf("polygon-parity", {notched(ShapeFill::EvenOdd)});
        const Picture drawn = drawnWith(scene, "last-edge-forgotten");
        // From the edges at 6, 10 and 14: the notch, and nothing where 14 alone is crossed.
        for (int y = 0; y < 24; ++y) {
            for (int x = 0; x < 32; ++x)
                QCOMPARE(bool(drawn.covered[drawn.placeOf(x, 23 - y)]),
                         x >= 6 && x < 10 && y > 6 && y <= 12);
        }
    }

    void anOutlineLeftOpenLacksItsLastEdgeAlone()
    {
        const Scene scene = sceneOf("polygon-outline", {notched(ShapeFill::Outline)});
        const Picture right = pictureOf(scene);
        const Picture drawn = drawnWith(scene, "outline-left-open");
        for (int y = 0; y < 24; ++y) {
            for (int x = 0; x < 32; ++x) {
                const std::size_t place = right.placeOf(x, 23 - y);
                const bool isOnLast = x == 2 && y > 2 && y < 12;
                QCOMPARE(bool(drawn.covered[place]), right.covered[place] != 0 && !isOnLast);
            }
        }
    }

    void aClippedLineIsDrawnFromARoundedPlace()
    {
        const Scene scene = sceneOf("line-dda", {shapeOf(PrimitiveKind::Line, {{2, 3}, {70, 40}})});
        // 3 + 37·29/68 is 18.78 at x = 31, the frame's last column.
        const auto lineTo = [](int y) {
            return pictureOf(
                sceneOf("line-dda", {shapeOf(PrimitiveKind::Line, {{2, 3}, {31, y}})}));
        };
        QVERIFY(drawnWith(scene, "clipped-ends-rounded") == lineTo(19));
        QVERIFY(drawnWith(scene, "clipped-ends-truncated") == lineTo(18));
        QVERIFY(drawnWith(scene, "crossing-lines-lost").covered
                == std::vector<std::uint8_t>(32 * 24, 0));
    }

private:
    static Picture drawnWith(const Scene &scene, const char *id)
    {
        const std::vector<Defect> defects = shapeDefectsFor(scene);
        const auto defect = std::ranges::find(defects, QLatin1String(id), &Defect::id);
        return defect != defects.end() ? pictureWith(scene, std::span(&*defect, 1)) : Picture();
    }
};

PIXELPLUMB_TEST(TestShapeDefects)

} // namespace tst_shapedefects

#include "tst_shapedefects.moc"
