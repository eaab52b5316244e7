// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/contours.h"
#include "core/polygons/curvechords.h"
#include "core/runs/explain/stepmoment.h"
#include "core/scan/choicenames.h"
#include "core/scan/polygons/polygonpieces.h"
#include "tests/support/framespec.h"
#include "tests/support/listings/listingshapes.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <numbers>

namespace tst_shapelistings {

using namespace pixelplumb;

/// The printed pseudocode of circles, polygons and points is executed and compared with their
/// kernels.
class TestShapeListings : public QObject {
    Q_OBJECT

private slots:
    void listingsOfCirclesDrawWhatTheirKernelsDraw_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<VariantSet>("variants");
        QTest::addColumn<Arithmetic>("arithmetic");
        for (const char *id :
             {"circle-midpoint", "circle-explicit", "circle-parametric", "circle-fill"})
            for (const Arithmetic arithmetic :
                 listedArithmetics(*methodNamed(QString::fromLatin1(id))))
                QTest::addRow("%s, %s", id, std::string(nameOf(arithmetic)).c_str())
                    << QString::fromLatin1(id) << VariantSet() << arithmetic;
        QTest::newRow("circle-midpoint, stay-at-zero")
            << u"circle-midpoint"_s << VariantSet().with(Variant::StayAtZero) << Arithmetic::Exact;
    }
    void listingsOfCirclesDrawWhatTheirKernelsDraw()
    {
        QFETCH(QString, id);
        QFETCH(VariantSet, variants);
        QFETCH(Arithmetic, arithmetic);
        std::mt19937 random(shapeSeed);
        std::size_t drawn = 0;
        for (int i = 0; i < 300; ++i) {
            Shape round = oddRound(i, random);
            if (id == u"circle-fill"_s)
                round.fill = ShapeFill::EvenOdd;
            Scene scene = sceneOf(round, qPrintable(id), frameFor(i));
            scene.settings.variants = variants;
            scene.settings.arithmetic = arithmetic;
            const auto traced = traceScene(scene);
            const LatticePoint centre = round.vertices[0].position;
            const LatticePoint corner = round.vertices[1].position;
            ListingNames names = {{u"x_c"_s, inPixels(centre.x)},
                                  {u"y_c"_s, inPixels(centre.y)},
                                  {u"r_x"_s, inPixels(corner.x - centre.x)},
                                  {u"r_y"_s, inPixels(corner.y - centre.y)},
                                  {u"π"_s, BigRational(std::numbers::pi)}};
            setColour(names, round.vertices[0].colour);
            ListingRun run(pseudocodeOf(*traced, 0), names, frameBox(scene.frame));
            const QString departure = message(i, departureOf(run, *traced));
            QVERIFY2(departure.isEmpty(), qPrintable(nameOf(round) + departure));
            drawn += run.pixels().size();
        }
        QVERIFY(drawn > 500);
    }

    void listingsOfPolygonsDrawWhatTheirKernelsDraw_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<ShapeFill>("fill");
        QTest::addColumn<Arithmetic>("arithmetic");
        const auto add = [](const char *id, ShapeFill fill) {
            const char *filled = fill == ShapeFill::NonZero ? "winding" : "parity";
            for (const Arithmetic arithmetic :
                 listedArithmetics(*methodNamed(QString::fromLatin1(id))))
                QTest::addRow("%s, %s, %s", id, filled, std::string(nameOf(arithmetic)).c_str())
                    << QString::fromLatin1(id) << fill << arithmetic;
        };
        for (const char *id : {"polygon-parity", "bezier-fill"}) {
            add(id, ShapeFill::EvenOdd);
            add(id, ShapeFill::NonZero);
        }
        for (const char *id : {"polygon-fan", "polygon-delaunay", "polygon-tessellation"})
            add(id, ShapeFill::EvenOdd);
        add("polygon-outline", ShapeFill::Outline);
    }
    void listingsOfPolygonsDrawWhatTheirKernelsDraw()
    {
        QFETCH(QString, id);
        QFETCH(ShapeFill, fill);
        QFETCH(Arithmetic, arithmetic);
        std::mt19937 random(shapeSeed);
        std::size_t drawn = 0;
        for (int i = 0; i < 200; ++i) {
            const bool isCurve = id == u"bezier-fill"_s;
            const Shape polygon = isCurve ? oddPath(i, random, fill) : oddPolygon(i, random, fill);
            Scene scene = sceneOf(polygon, qPrintable(id), frameFor(i));
            scene.settings.arithmetic = arithmetic;
            scene.settings = methodNamed(id)->adapted(scene.settings); // its lines follow the rule
            const auto traced = traceScene(scene);
            if (traced->trace->setUp(0).rejection)
                continue; // fans are of convex polygons, Delaunay's of those that do not cross
            ListingNames names = setUpNames(*traced);
            names[fill == ShapeFill::NonZero ? u"non-zero"_s : u"even-odd"_s] = 1;
            setColour(names, polygon.vertices[0].colour);
            ListingRun run(pseudocodeOf(*traced, 0), names, frameBox(scene.frame));
            const Contours contours = contoursOf(isCurve ? chordsOf(polygon) : polygon);
            if (id == u"polygon-fan"_s)
                run.setItems(itemsOf(edgesOf(fanOf(contours))));
            else if (id == u"polygon-delaunay"_s)
                run.setItems(itemsOf(edgesOf(delaunayOf(contours))));
            else if (id == u"polygon-tessellation"_s)
                run.setItems(itemsOf(edgesOf(tessellationOf(contours))));
            else
                run.setItems(itemsOf(contours.edges));
            const QString departure = message(i, departureOf(run, *traced));
            QVERIFY2(departure.isEmpty(), qPrintable(nameOf(polygon) + departure));
            drawn += run.pixels().size();
        }
        QVERIFY(drawn > 300);
    }

    void theListingOfPointsDrawsWhatItsKernelDraws()
    {
        std::mt19937 random(shapeSeed);
        for (int i = 0; i < 200; ++i) {
            Shape points;
            points.kind = PrimitiveKind::Point;
            std::vector<ListingRun::Item> items;
            for (int point = 0; point < 1 + i % 3; ++point) {
                const LatticePoint at = Places(i).point(random);
                points.vertices.push_back({at, {{200, 100, 50}}});
                items.push_back({inPixels(at.x), inPixels(at.y)});
            }
            const Scene scene = sceneOf(points, "point-address", frameFor(i));
            const auto traced = traceScene(scene);
            ListingNames names = setUpNames(*traced);
            names[u"height"_s] = scene.frame.height;
            setColour(names, points.vertices[0].colour);
            ListingRun run(pseudocodeOf(*traced, 0), names, frameBox(scene.frame));
            run.setItems(items);
            const QString departure = message(i, departureOf(run, *traced));
            QVERIFY2(departure.isEmpty(), qPrintable(nameOf(points) + departure));
        }
    }

    /// A square from pixel to pixel has its ties at the left edge.
    void aListingThatTakesTiesForTheOtherSideIsFound()
    {
        Shape square;
        square.kind = PrimitiveKind::Polygon;
        square.fill = ShapeFill::EvenOdd;
        for (const LatticePoint &corner :
             {latticePixel(2, 2), latticePixel(6, 2), latticePixel(6, 6), latticePixel(2, 6)})
            square.vertices.push_back({corner, {{200, 100, 50}}});
        const Scene scene = sceneOf(square, "polygon-parity", frameOf(14, 13));
        const auto traced = traceScene(scene);
        ListingNames names = setUpNames(*traced);
        names[u"even-odd"_s] = 1;
        setColour(names, square.vertices[0].colour);
        Pseudocode code = pseudocodeOf(*traced, 0);
        for (PseudocodeLine &line : code)
            line.text.replace(u"x_k ≤ x"_s, u"x_k < x"_s);
        ListingRun run(code, names, frameBox(scene.frame));
        run.setItems(itemsOf(contoursOf(square).edges));
        QVERIFY(departureOf(run, *traced).contains(u"kernel (2, 3) "_s));
    }
};

PIXELPLUMB_TEST(TestShapeListings)

} // namespace tst_shapelistings

#include "tst_shapelistings.moc"
