// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seededrandom.h"
#include "core/layers/affinemap.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/canvasbench.h"
#include "tests/support/window/layerlook.h"

#include <QTest>
#include <QtWidgets>

#include <cmath>
#include <functional>
#include <numeric>

namespace tst_affinemap {

using namespace pixelplumb;

namespace {

const QString layerId = u"affine-map"_s;

/// The tests' own fraction; its numbers are too small to overflow.
struct Ratio {
    std::int64_t above = 0;
    std::int64_t below = 1;

    QString text() const
    {
        const std::int64_t common = std::gcd(above, below);
        const std::int64_t sign = below < 0 ? -1 : 1;
        const std::int64_t denominator = sign * below / common;
        QString shown = QString::number(sign * above / common);
        if (denominator != 1)
            shown += u"/%1"_s.arg(denominator);
        return shown.replace(u'-', QChar(0x2212));
    }
    QString rounded(int places) const
    {
        return QString::number(double(above) / double(below), 'f', places)
            .replace(u'-', QChar(0x2212));
    }
};

/// All exact or, if one of them is long, all with three decimals.
QStringList texts(const std::vector<Ratio> &numbers)
{
    QStringList exact;
    QStringList rounded{u"≈ "_s};
    for (const Ratio &number : numbers) {
        exact += number.text();
        rounded += number.rounded(3);
    }
    const bool isLong
        = std::ranges::any_of(exact, [](const QString &text) { return text.size() > 9; });
    return isLong ? rounded : QStringList(QString()) + exact;
}

/// A point in half pixels, so that frames of both kinds have whole numbers.
struct Point {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

Point halves(const LatticePoint &point) { return {point.x / halfPixel, point.y / halfPixel}; }

std::int64_t determinant(const Point &origin, const Point &a, const Point &b)
{
    return (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
}

/// The numerators of α, β and γ in p = a + β(b − a) + γ(c − a) by Cramer's rule, α = 1 − β − γ.
struct CramerWeights {
    std::array<std::int64_t, 3> parts;
    std::int64_t whole = 0;

    CramerWeights(const std::array<Point, 3> &corners, const Point &point)
        : whole(determinant(corners[0], corners[1], corners[2]))
    {
        parts[1] = determinant(corners[0], point, corners[2]);
        parts[2] = determinant(corners[0], corners[1], point);
        parts[0] = whole - parts[1] - parts[2];
    }

    QString text() const
    {
        return u"α = %1, β = %2, γ = %3"_s.arg(Ratio{parts[0], whole}.text(),
                                               Ratio{parts[1], whole}.text(),
                                               Ratio{parts[2], whole}.text());
    }
};

Corners randomCorners(SeededRandom &random, std::int64_t largest)
{
    Corners corners;
    do {
        for (LatticePoint &corner : corners)
            corner = latticePixel(random.between(0, largest), random.between(0, largest));
    } while (doubledArea(corners[0], corners[1], corners[2]) == 0);
    return corners;
}

Scene sceneOf(const Corners &corners)
{
    Scene scene;
    scene.method = "edge-equations";
    scene.triangles = {triangleAtUnits(corners[0], corners[1], corners[2])};
    return scene;
}

Look lookAt(const Scene &scene, const Corners &images)
{
    Look look(scene);
    look.view.image = AffineImage{0, images};
    return look;
}

QString labelOf(const LayerDrawing &drawing, const QString &name)
{
    for (const LayerDrawing::Label &label : drawing.labels) {
        if (label.text.startsWith(name))
            return label.text;
    }
    return {};
}

QStringList notesOf(const LayerDrawing &drawing, const QString &beginning)
{
    return drawing.notes.filter(beginning);
}

/// A map of the first scene's triangle.
const AffineImage someImage{0, {latticePixel(10, 40), latticePixel(30, 40), latticePixel(10, 20)}};

/// A canvas with the layer and that map.
struct MapBench : CanvasBench {
    MapBench()
        : CanvasBench(firstScene())
    {
        options.setLayers({layerId});
        options.setAffineImage(someImage);
    }
};

double crossProduct(const QPointF &a, const QPointF &b) { return a.x() * b.y() - a.y() * b.x(); }

} // namespace

/// Barycentric coordinates are invariant under affine maps: the layer's numbers, and its image as
/// something to drag.
class TestAffineMap : public QObject {
    Q_OBJECT

private slots:
    void theWeightsOfEachTriangleAreThoseOfCramersRule_data()
    {
        QTest::addColumn<FrameOrigin>("origin");
        QTest::addColumn<PixelCentre>("centre");
        QTest::addColumn<quint64>("seed");
        for (quint64 seed = 0; seed < 12; ++seed) {
            QTest::addRow("upward, seed %llu", seed)
                << FrameOrigin::BottomLeft << PixelCentre::Integer << seed;
            QTest::addRow("downward, in the middle of pixels, seed %llu", seed)
                << FrameOrigin::TopLeft << PixelCentre::Half << seed;
        }
    }
    void theWeightsOfEachTriangleAreThoseOfCramersRule()
    {
        QFETCH(FrameOrigin, origin);
        QFETCH(PixelCentre, centre);
        QFETCH(quint64, seed);
        SeededRandom random(seed);
        const Corners corners = randomCorners(random, 12);
        const Corners images = randomCorners(random, 40);
        const QPoint pixel(int(random.between(0, 14)), int(random.between(0, 14)));
        Scene scene = sceneOf(corners);
        scene.frame.origin = origin;
        scene.frame.pixelCentre = centre;
        Look look = lookAt(scene, images);
        look.view.picked = pixel;

        const LayerDrawing drawing = look.drawing("affine-map");

        const Lattice offset = centre == PixelCentre::Half ? halfPixel : 0;
        const LatticePoint sample{pixel.x() * unitsPerPixel + offset,
                                  pixel.y() * unitsPerPixel + offset};
        const std::array<Point, 3> before
            = {halves(corners[0]), halves(corners[1]), halves(corners[2])};
        const std::array<Point, 3> after
            = {halves(images[0]), halves(images[1]), halves(images[2])};
        const CramerWeights weights(before, halves(sample));
        QCOMPARE(labelOf(drawing, u"p:"_s), u"p: %1"_s.arg(weights.text()));
        QCOMPARE(labelOf(drawing, u"p′:"_s), u"p′: %1"_s.arg(weights.text()));

        // The position of the image, and its areas: the weights of the whole area there.
        const auto mean = [&](auto coordinate) {
            std::int64_t sum = 0;
            for (std::size_t i = 0; i < 3; ++i)
                sum += weights.parts[i] * coordinate(after[i]);
            return Ratio{sum, 2 * weights.whole};
        };
        const std::int64_t whole = determinant(after[0], after[1], after[2]);
        const auto area = [&](std::size_t i) {
            return Ratio{weights.parts[i] * whole, 4 * weights.whole};
        };
        const QStringList place = texts({mean([](const Point &point) { return point.x; }),
                                         mean([](const Point &point) { return point.y; })});
        const QStringList areas = texts({area(0), area(1), area(2), Ratio{whole, 4}});
        QCOMPARE(
            notesOf(drawing, u"p′"_s),
            QStringList(u"p′ %1(%2, %3). Doubled areas: %4%5, %6, %7 of %8"_s.arg(
                place[0], place[1], place[2], areas[0], areas[1], areas[2], areas[3], areas[4])));
        const Ratio factor{whole, weights.whole};
        const bool mirrors = (whole < 0) != (weights.whole < 0);
        QCOMPARE(notesOf(drawing, u"The weights stay"_s),
                 QStringList(u"The weights stay, all areas are multiplied by %1%2"_s.arg(
                     factor.text(), mirrors ? u": the map mirrors"_s : QString())));
    }

    void theMapIsToldInWords()
    {
        // Twice as wide, turned by 90° and moved: (x, y) ↦ (30 − y, 2x + 1).
        const Look look
            = lookAt(sceneOf({latticePixel(0, 0), latticePixel(8, 0), latticePixel(2, 6)}),
                     {latticePixel(30, 1), latticePixel(30, 17), latticePixel(24, 5)});

        QCOMPARE(look.drawing("affine-map").notes.mid(0, 2),
                 QStringList({u"Affine map: x′ = 0·x − 1·y + 30"_s, u"and y′ = 2·x + 0·y + 1"_s}));
    }

    void theWeightsAreThoseOfTheScenesVerticesWhateverTheMethodSorts()
    {
        Scene scene = sceneOf({latticePixel(9, 0), latticePixel(0, 0), latticePixel(3, 8)});
        scene.method = "column-scan"; // sorted by x: the vertices 1, 2, 0
        Look look
            = lookAt(scene, {latticePixel(40, 10), latticePixel(20, 10), latticePixel(30, 30)});
        look.view.picked = QPoint(9, 0);

        const LayerDrawing drawing = look.drawing("affine-map");

        QCOMPARE(labelOf(drawing, u"a′"_s), u"a′ = P2′ (40, 10)"_s);
        QCOMPARE(labelOf(drawing, u"p′:"_s), u"p′: α = 1, β = 0, γ = 0"_s);
    }

    void theSampleIsThePickedPixelElseThatOfTheStep()
    {
        Look look = lookAt(sceneOf({latticePixel(0, 0), latticePixel(8, 0), latticePixel(2, 6)}),
                           {latticePixel(30, 1), latticePixel(30, 17), latticePixel(24, 5)});
        const ScanTrace &trace = *look.traced->trace;
        for (const std::size_t sample : {std::size_t(0), trace.sampleCount() / 2}) {
            look.view.position = trace.indexOfSample(sample) + 1;
            const PixelChange change = trace.changes()[sample];
            const QString place = u"p (%1, %2). "_s.arg(change.x).arg(change.y);
            QCOMPARE(notesOf(look.drawing("affine-map"), place).size(), 1);
        }
        look.view.picked = QPoint(40, 20);
        QCOMPARE(notesOf(look.drawing("affine-map"), u"p (40, 20). "_s).size(), 1);
        look.view.picked.reset();
        // Nothing is drawn, or everything: the pixel in the middle, (10/3, 2).
        for (const std::size_t position : {std::size_t(0), trace.stepCount()}) {
            look.view.position = position;
            QCOMPARE(notesOf(look.drawing("affine-map"), u"p (3, 2). "_s).size(), 1);
        }
    }

    void theGridIsTheImageOfTheLinesBetweenCells()
    {
        // (x, y) ↦ (20 + 2x + y, 10 + 3y)
        const Look look
            = lookAt(sceneOf({latticePixel(0, 0), latticePixel(4, 0), latticePixel(0, 4)}),
                     {latticePixel(20, 10), latticePixel(28, 10), latticePixel(24, 22)});
        const auto mapped = [](double x, double y) { return QPointF(20 + 2 * x + y, 10 + 3 * y); };

        const LayerDrawing drawing = look.drawing("affine-map");

        for (const double at : {0.5, 1.5, 2.5, 3.5}) {
            for (const auto &cut : {std::pair(mapped(at, 0), mapped(at, 4 - at)),
                                    std::pair(mapped(0, at), mapped(4 - at, at))}) {
                const auto found
                    = std::ranges::count_if(drawing.lines, [&](const LayerDrawing::Line &line) {
                          return line.ink == LayerInk::Second
                              && line.stroke == LayerDrawing::Stroke::Dotted
                              && (std::pair(line.from, line.to) == cut
                                  || std::pair(line.to, line.from) == cut);
                      });
                QCOMPARE(found, std::ptrdiff_t(1));
            }
        }
        const auto dotted = std::ranges::count_if(drawing.lines, [](const auto &line) {
            return line.ink == LayerInk::Second && line.stroke == LayerDrawing::Stroke::Dotted;
        });
        QCOMPARE(dotted, std::ptrdiff_t(8));
    }

    void theLinesOfALargeTriangleAreThinnedOut()
    {
        const Look look
            = Look(sceneOf({latticePixel(0, 0), latticePixel(1000, 0), latticePixel(0, 90)}));

        const LayerDrawing drawing = look.drawing("affine-map");

        QVERIFY(drawing.lines.size() < 120);
    }

    void aMapThatFlattensLeavesNoWeights()
    {
        const Look look
            = lookAt(sceneOf({latticePixel(0, 0), latticePixel(8, 0), latticePixel(2, 6)}),
                     {latticePixel(10, 10), latticePixel(20, 20), latticePixel(30, 30)});

        const LayerDrawing drawing = look.drawing("affine-map");

        QVERIFY(!labelOf(drawing, u"p:"_s).isEmpty());
        QCOMPARE(labelOf(drawing, u"p′"_s), QString());
        QCOMPARE(notesOf(drawing, u"flattens the triangle to no area"_s).size(), 1);
        QVERIFY(notesOf(drawing, u"The weights stay"_s).isEmpty());
    }

    void aTriangleWithoutAreaHasNoMap()
    {
        const LayerDrawing drawing
            = Look(sceneOf({latticePixel(0, 0), latticePixel(8, 8), latticePixel(4, 4)}))
                  .drawing("affine-map");

        QVERIFY(drawing.isEmpty());
        QCOMPARE(drawing.notes.size(), 1);
        QVERIFY(drawing.notes.front().contains(u"the triangle has no area"_s));
    }

    void theFirstMapIsWorthALook_data()
    {
        QTest::addColumn<std::int64_t>("largest");
        QTest::addColumn<FrameOrigin>("origin");
        for (const std::int64_t largest : {3, 60, 5000}) {
            QTest::addRow("up to %lld px", static_cast<long long>(largest))
                << largest << FrameOrigin::BottomLeft;
            QTest::addRow("up to %lld px, y downward", static_cast<long long>(largest))
                << largest << FrameOrigin::TopLeft;
        }
    }
    void theFirstMapIsWorthALook()
    {
        QFETCH(std::int64_t, largest);
        QFETCH(FrameOrigin, origin);
        FrameSpec frame;
        frame.origin = origin;
        frame.pixelCentre = PixelCentre::Half;
        SeededRandom random(7);
        for (int i = 0; i < 50; ++i) {
            const Corners corners = randomCorners(random, largest);
            const Corners images = defaultImages(corners, frame);
            const Int128 area = doubledArea(images[0], images[1], images[2]);
            QVERIFY(area != 0);
            const bool isInFrame = std::ranges::all_of(images, [](const LatticePoint &image) {
                return image.x >= 0 && image.x <= 64 * unitsPerPixel && image.y >= 0
                    && image.y <= 48 * unitsPerPixel;
            });
            // A sliver, which whole pixels would flatten, keeps its area instead.
            QVERIFY(isInFrame || area == doubledArea(corners[0], corners[1], corners[2]));
            // Turned: no edge keeps its direction.
            QVERIFY(crossProduct(placeOf(corners[1]) - placeOf(corners[0]),
                                 placeOf(images[1]) - placeOf(images[0]))
                    != 0);
        }
    }

    void aDragOfACornerMovesTheMapAndNotTheScene_data()
    {
        QTest::addColumn<CanvasTool>("tool");
        QTest::addColumn<PixelCentre>("centre");
        QTest::newRow("Draw") << CanvasTool::Draw << PixelCentre::Integer;
        QTest::newRow("Inspect") << CanvasTool::Inspect << PixelCentre::Integer;
        QTest::newRow("in the middle of pixels") << CanvasTool::Draw << PixelCentre::Half;
    }
    void aDragOfACornerMovesTheMapAndNotTheScene()
    {
        QFETCH(CanvasTool, tool);
        QFETCH(PixelCentre, centre);
        Scene scene = firstScene();
        scene.frame.pixelCentre = centre;
        CanvasBench bench(scene);
        bench.options.setLayers({layerId});
        bench.canvas.setTool(tool);
        const Corners start = defaultImages(
            {latticePixel(4, 5), latticePixel(58, 12), latticePixel(26, 44)}, scene.frame);
        const QPoint pressed = bench.canvas.positionOf(start[1]).toPoint();

        bench.drag(pressed, pressed + bench.at(7, 3) - bench.at(0, 0));

        Corners moved = start;
        moved[1].x += 7 * unitsPerPixel;
        moved[1].y += 3 * unitsPerPixel;
        QVERIFY(bench.options.affineImage().has_value());
        QCOMPARE(bench.options.affineImage()->corners, moved);
        QCOMPARE(bench.document.scene(), scene);
        QVERIFY(!bench.document.isModified());
        QVERIFY(bench.document.pendingVertices().empty());
        QVERIFY(!bench.playhead.pickedPixel());
        QCOMPARE(bench.document.undoStack()->count(), 1); // all moves of the drag
        bench.document.undoStack()->undo();
        QVERIFY(!bench.options.affineImage().has_value());
        QCOMPARE(bench.document.scene(), scene);
        bench.document.undoStack()->redo();
        QCOMPARE(bench.options.affineImage()->corners, moved);
        QVERIFY(!bench.document.isModified());
    }

    void aDoubleClickOnACornerBringsTheFirstMapBack()
    {
        MapBench bench;
        const QPoint corner = bench.at(30, 40);
        QTest::mouseClick(&bench.canvas, Qt::LeftButton, {}, corner);
        QVERIFY(bench.options.affineImage().has_value());
        QTest::mouseDClick(&bench.canvas, Qt::LeftButton, {}, corner);

        QVERIFY(!bench.options.affineImage().has_value());
        QVERIFY(bench.document.pendingVertices().empty());
        bench.document.undoStack()->undo();
        QCOMPARE(bench.options.affineImage()->corners[1], latticePixel(30, 40));
    }

    void escapeDuringADragLeavesTheMapAsItWas()
    {
        MapBench bench;
        bench.send(QEvent::MouseButtonPress, bench.at(30, 40), Qt::LeftButton, Qt::LeftButton);
        bench.send(QEvent::MouseMove, bench.at(40, 30), Qt::NoButton, Qt::LeftButton);
        QVERIFY(bench.options.affineImage() != someImage);
        QTest::keyClick(&bench.canvas, Qt::Key_Escape);

        QCOMPARE(bench.options.affineImage(), std::optional(someImage));
        QVERIFY(!bench.document.undoStack()->canUndo());
    }

    void keysAloneMoveACorner()
    {
        MapBench bench;
        QTest::keyClick(&bench.canvas, Qt::Key_BracketLeft); // the last of all handles
        QCOMPARE(bench.canvas.spokenState(), u"image of vertex 2 at (10, 20)"_s);
        QTest::keyClick(&bench.canvas, Qt::Key_Right, Qt::ControlModifier);
        QTest::keyClick(&bench.canvas, Qt::Key_Up, Qt::ControlModifier);

        QCOMPARE(bench.options.affineImage()->corners[2], latticePixel(11, 21));
        QVERIFY(!bench.document.isModified());
        bench.document.undoStack()->undo(); // one per press of Control
        QCOMPARE(bench.options.affineImage()->corners[2], latticePixel(11, 20));
        bench.document.undoStack()->undo();
        QCOMPARE(bench.options.affineImage()->corners[2], latticePixel(10, 20));
        QTest::keyClick(&bench.canvas, Qt::Key_BracketRight); // around to the first vertex
        QCOMPARE(bench.canvas.spokenState(), u"vertex 0 of triangle 0 at (4, 5)"_s);
    }

    void theMapGoesWithItsTriangle_data()
    {
        QTest::addColumn<std::function<void(SceneDocument &)>>("edit");
        QTest::addColumn<int>("triangle"); // −1: there is no map
        using Edit = std::function<void(SceneDocument &)>;
        const auto add = [](const char *name, const Edit &edit, int triangle) {
            QTest::newRow(name) << edit << triangle;
        };
        add(
            "drawn earlier", [](auto &document) { document.movePrimitive(1, -1); }, 0);
        add(
            "drawn later", [](auto &document) { document.movePrimitive(1, 1); }, 2);
        add(
            "overtaken", [](auto &document) { document.movePrimitive(0, 2); }, 0);
        add(
            "one before it deleted", [](auto &document) { document.deletePrimitive(0); }, 0);
        add(
            "one behind it deleted", [](auto &document) { document.deletePrimitive(2); }, 1);
        add(
            "one before it hidden", [](auto &document) { document.hidePrimitive(0); }, 0);
        add(
            "one more drawn",
            [](auto &document) { document.addTriangle(triangleAt(0, 0, 9, 0, 0, 9)); }, 1);
        add(
            "dragged itself",
            [](auto &document) {
                document.moveVertex({1, 0}, latticePixel(9, 9), document.newDrag());
            },
            1);
        add(
            "deleted itself", [](auto &document) { document.deletePrimitive(1); }, -1);
        add(
            "hidden itself", [](auto &document) { document.hidePrimitive(1); }, -1);
        add(
            "all deleted", [](auto &document) { document.clear(); }, -1);
    }
    void theMapGoesWithItsTriangle()
    {
        QFETCH(std::function<void(SceneDocument &)>, edit);
        QFETCH(int, triangle);
        Scene scene;
        scene.triangles = {triangleAt(4, 5, 58, 12, 26, 44), triangleAt(2, 30, 20, 44, 6, 46),
                           triangleAt(30, 2, 60, 4, 44, 30)};
        CanvasBench bench(scene);
        const Corners &corners = someImage.corners;
        bench.options.setAffineImage(AffineImage{1, corners});

        edit(bench.document);

        const std::optional<AffineImage> expected = triangle < 0
            ? std::nullopt
            : std::optional(AffineImage{std::size_t(triangle), corners});
        QCOMPARE(bench.options.affineImage(), expected);
        bench.document.undoStack()->undo();
        QCOMPARE(bench.options.affineImage(), std::optional(AffineImage{1, corners}));
        bench.document.undoStack()->redo();
        QCOMPARE(bench.options.affineImage(), expected);
    }

    void whoIsShownAgainHasItsMapAgain()
    {
        Scene scene;
        scene.triangles = {triangleAt(4, 5, 58, 12, 26, 44), triangleAt(2, 30, 20, 44, 6, 46)};
        CanvasBench bench(scene);
        const AffineImage image{1, someImage.corners};
        bench.options.setAffineImage(image);
        bench.document.hidePrimitive(1);
        bench.document.hidePrimitive(0);

        bench.document.showAllHidden();

        QCOMPARE(bench.options.affineImage(), std::optional(image));
        bench.document.hidePrimitive(1);
        bench.options.setAffineImage(AffineImage{0, image.corners});
        bench.document.showAllHidden();
        QCOMPARE(bench.options.affineImage(), std::optional(AffineImage{0, image.corners}));
    }

    void withoutTheLayerThereIsNothingToDrag()
    {
        CanvasBench bench(firstScene());
        bench.options.setAffineImage(someImage);

        bench.click(30, 40);

        QCOMPARE(bench.document.pendingVertices().size(), std::size_t(1));
    }
};

PIXELPLUMB_TEST(TestAffineMap)

} // namespace tst_affinemap

#include "tst_affinemap.moc"
