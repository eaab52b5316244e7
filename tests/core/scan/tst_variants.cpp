// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/scenerun.h"
#include "core/runs/tracedscene.h"
#include "core/scan/choicenames.h"
#include "core/scene/scenefile.h"
#include "tests/support/runchecks/runscenes.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/scenes/trianglepictures.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <random>

namespace tst_variants {

using namespace pixelplumb;

namespace {

VariantSet only(Variant variant) { return VariantSet().with(variant); }

ScanSettings settingsWith(VariantSet variants, Arithmetic arithmetic = Arithmetic::Exact,
                          FillRule rule = FillRule::Closed)
{
    return {arithmetic, rule, ByteRounding::Nearest, variants};
}

ScanPicture pictureOf(const char16_t *method, const Triangle &triangle,
                      const ScanSettings &settings)
{
    ScanPicture picture(frameOf(24, 20));
    picture.draw(*methodNamed(method), triangle, settings);
    return picture;
}

/// Vertices between pixels, not sorted by x; every variant shows on this triangle.
Triangle unevenTriangle()
{
    return triangleOf({LatticePoint{3000, 900}, LatticePoint{430, 300}, {5300, 4500}});
}

QImage drawingOf(const Scene &scene)
{
    const FrameBuffer frame(scene.frame);
    drawScene(scene, frame);
    return frame.copy();
}

QRgb pixelAt(const QImage &image, int x, int y) { return image.pixel(x, image.height() - 1 - y); }

QRgb colourOf(const Colour &colour)
{
    return qRgb(colour.channels[0], colour.channels[1], colour.channels[2]);
}

} // namespace

/// Departures from the right algorithm, as texts print them: parameters of the ordinary kernels.
class TestVariants : public QObject {
    Q_OBJECT

private slots:
    void everyVariantHasANameWordsAndAMethodThatKnowsIt()
    {
        for (const Variant variant : allVariants) {
            QVERIFY(variantNamed(nameOf(variant)) == variant);
            const VariantWords &words = wordsOf(variant, SpanAxis::Column);
            for (const std::string_view text :
                 {words.title, words.printed, words.right, words.source, words.fault})
                QVERIFY(!text.empty());
            QVERIFY(std::ranges::any_of(
                methods(), [&](const Method &method) { return method.supports(variant); }));
        }
        QVERIFY(!variantNamed("round-box"));
    }

    void aVariantDepartsFromTheRightPictureInEveryArithmetic_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<int>("variant");
        for (const Method &method : methods()) {
            for (const Variant variant : method.variants)
                QTest::newRow(qPrintable(method.id + u' ' + nameText(nameOf(variant))))
                    << method.id << int(variant);
        }
    }
    void aVariantDepartsFromTheRightPictureInEveryArithmetic()
    {
        QFETCH(QString, id);
        QFETCH(int, variant);
        const Method &method = *methodNamed(id);
        for (const Arithmetic arithmetic : method.arithmetics) {
            Scene scene = departingScene(method);
            scene.settings = settingsWith(only(Variant(variant)), arithmetic);
            scene.settings.fillRule = method.fillRules.front();
            QCOMPARE(objectionTo(scene), QString());
            const QImage drawn = drawingOf(scene);
            FrameBuffer plain(scene.frame);
            Run(&method, primitivesOnSamples(scene), scene.settings, plain.view(), Kernels::Plain)
                .draw(plain.view());
            QCOMPARE(plain.copy(), drawn); // not the fast path
            Scene right = scene;
            right.settings.variants = {};
            QVERIFY2(drawingOf(right) != drawn, qPrintable(nameText(nameOf(arithmetic))));
        }
    }

    void theSlidesTableWithThePrintedComparisonGoesUpAStepLate()
    {
        // (20, 41) to (30, 44): p₄ = 0.
        Scene scene = sceneOf(lineAt(20, 41, 30, 44), "line-bresenham", frameOf(40, 50));
        const auto rowsOf = [&](VariantSet variants) {
            scene.settings.variants = variants;
            const auto traced = traceScene(scene);
            std::vector<int> rows;
            for (std::size_t span = 0; span < traced->trace->spanCount(); ++span)
                rows.push_back(int(traced->trace->span(span).firstDrawn));
            return rows;
        };
        QCOMPARE(rowsOf({}), (std::vector{41, 41, 42, 42, 42, 43, 43, 43, 43, 44, 44}));
        QCOMPARE(rowsOf(only(Variant::StayAtZero)),
                 (std::vector{41, 41, 42, 42, 42, 42, 43, 43, 43, 44, 44}));
        QCOMPARE(rowsOf(only(Variant::OneStepShort)),
                 (std::vector{41, 41, 42, 42, 42, 43, 43, 43, 43, 44}));
    }

    void aLineBegunInsideTheFrameIsThePartOfTheWholeOne()
    {
        std::mt19937 random(20261123);
        std::uniform_int_distribution<std::int64_t> at(-30, 50);
        for (int round = 0; round < 200; ++round) {
            const Shape line = lineAt(at(random), at(random), at(random), at(random));
            Primitives primitives;
            primitives.shapes = {line};
            ScanPicture whole(frameOf(160, 160, -60, -60));
            ScanPicture part(frameOf(20, 20));
            const Method *bresenham = methodNamed(u"line-bresenham");
            const ScanSettings settings = settingsWith(only(Variant::StayAtZero));
            Run(bresenham, primitives, settings, whole.view()).draw(whole.view());
            Run(bresenham, primitives, settings, part.view()).draw(part.view());
            for (int x = 0; x < 20; ++x) {
                for (int y = 0; y < 20; ++y)
                    QCOMPARE(part.at(x, y), whole.at(x, y));
            }
        }
    }

    void aCircleOfRadiusOneIsARingOfEightWhereAWholePOfZeroStays()
    {
        Scene scene = sceneOf(circleAt(4, 4, 1), "circle-midpoint", frameOf(9, 9));
        const auto pixelsOf = [&](VariantSet variants) {
            scene.settings.variants = variants;
            int count = 0;
            const QImage drawn = drawingOf(scene);
            for (int x = 0; x < 9; ++x) {
                for (int y = 0; y < 9; ++y)
                    count += pixelAt(drawn, x, y) != qRgb(0, 0, 0) ? 1 : 0;
            }
            return count;
        };
        QCOMPARE(pixelsOf({}), 4);
        QCOMPARE(pixelsOf(only(Variant::StayAtZero)), 8);
    }

    void theRoundedBoxLosesTheCentresOnItsLeftAndLowerSide()
    {
        // Pixel (2, y) has its centre at 2½, where the triangle's left side is.
        Scene scene;
        scene.frame = frameOf(12, 12);
        scene.frame.pixelCentre = PixelCentre::Half;
        scene.method = "edge-equations";
        scene.triangles = {
            triangleOf({LatticePoint{640, 640}, LatticePoint{640, 2176}, LatticePoint{2176, 640}})};
        const QImage right = drawingOf(scene);
        scene.settings.variants = only(Variant::RoundedBox);
        const QImage rounded = drawingOf(scene);
        QVERIFY(pixelAt(right, 2, 2) != qRgb(0, 0, 0));
        for (int x = 0; x < 12; ++x) {
            for (int y = 0; y < 12; ++y) {
                const bool isLost = x == 2 || y == 2;
                QCOMPARE(pixelAt(rounded, x, y), isLost ? qRgb(0, 0, 0) : pixelAt(right, x, y));
            }
        }
    }

    void withWholeVerticesNothingIsLateWithoutAPreStepOfEdges()
    {
        // Also shows that the ramp of departures equals the plane's where nothing departs.
        std::mt19937 random(7);
        std::uniform_int_distribution<std::int64_t> at(-6, 28);
        for (int round = 0; round < 300; ++round) {
            const Triangle triangle = triangleOf({latticePixel(at(random), at(random)),
                                                  latticePixel(at(random), at(random)),
                                                  latticePixel(at(random), at(random))});
            for (const char16_t *method : {u"column-scan", u"row-walk"}) {
                for (const FillRule rule : {FillRule::Closed, FillRule::Open}) {
                    const auto drawn = [&](VariantSet variants) {
                        return pictureOf(method, triangle,
                                         settingsWith(variants, Arithmetic::Exact, rule));
                    };
                    QVERIFY2(drawn(only(Variant::NoEdgePreStep)) == drawn({}),
                             textOfTriangle(triangle).c_str());
                }
            }
        }
    }

    void withoutAPreStepOfColourAColumnBeginsWithItsEdgesColour()
    {
        Scene scene;
        scene.frame = frameOf(24, 20);
        scene.method = "column-scan";
        scene.triangles = {unevenTriangle()};
        scene.settings.variants = only(Variant::NoColourPreStep);
        const auto traced = traceScene(scene);
        const auto ids = traced->method->numbers.span;
        const auto cell = [&](const SpanRecord &record, const QString &id) {
            const auto found
                = std::ranges::find(ids, id, [](const NumberDescription &each) { return each.id; });
            return record.cells[std::size_t(found - ids.begin())];
        };
        int seen = 0;
        for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
            const SpanRecord record = traced->trace->span(span);
            if (record.firstDrawn >= record.endDrawn)
                continue;
            QVERIFY(cell(record, u"first_R"_s) == cell(record, u"R_B"_s));
            ++seen;
        }
        QVERIFY(seen > 15);
    }

    void incrementsDividedByTooMuchOrTooLittleAreTheSlopesOfAnEdgeAPixelOff()
    {
        // L₀₂ rises by 8/16, 8/15, 8/17, L₁₂ falls by 9/16, 9/15, 9/17.
        const Triangle triangle
            = triangleOf({latticePixel(1, 1), latticePixel(1, 18), latticePixel(17, 9)});
        const auto heightAt = [&](VariantSet variants, int x) {
            const ScanPicture picture = pictureOf(u"column-scan", triangle, settingsWith(variants));
            int count = 0;
            for (int y = 0; y < 20; ++y)
                count += picture.at(x, y) != 0 ? 1 : 0;
            return count;
        };
        // 7 … 11 1/4 and 7 2/5 … 10 4/5; 8 1/2 … 9 9/16 and 8 1/17 … 10 1/17.
        QCOMPARE(heightAt({}, 13), 5);
        QCOMPARE(heightAt(only(Variant::DivisorMinusOne), 13), 3);
        QCOMPARE(heightAt({}, 16), 1);
        QCOMPARE(heightAt(only(Variant::DivisorPlusOne), 16), 2);
    }

    void ofAMethodThatFillsRowsAVariantSpeaksOfRows()
    {
        const Method &rows = *methodNamed(u"row-walk");
        QCOMPARE(rows.spanAxis, SpanAxis::Row);
        for (const Variant variant : rows.variants) {
            const VariantWords &words = wordsOf(variant, rows.spanAxis);
            for (const std::string_view text : {words.printed, words.right, words.fault}) {
                for (const char *ofColumns : {"column", "y_B", "R_B", "by x", "Δy/"})
                    QVERIFY2(!nameText(text).contains(QString::fromUtf8(ofColumns)),
                             qPrintable(nameText(text)));
            }
        }
        // Its words about the start of an edge describe the kernel: at its first row, an edge that
        // starts between two rows has its vertex' x.
        const VariantWords &words = wordsOf(Variant::NoEdgePreStep, rows.spanAxis);
        QCOMPARE(nameText(words.printed), u"x = x₀ at the first row"_s);
        Scene scene;
        scene.frame = frameOf(24, 20);
        scene.method = "row-walk";
        scene.triangles
            = {triangleOf({LatticePoint{3 * unitsPerPixel, 15 * unitsPerPixel + unitsPerPixel / 2},
                           latticePixel(1, 2), latticePixel(19, 4)})};
        scene.settings.variants = only(Variant::NoEdgePreStep);
        const auto traced = traceScene(scene);
        const SpanRecord first = traced->trace->span(0);
        QVERIFY(first.place.axis == SpanAxis::Row);
        QCOMPARE(first.place.coordinate, 15);
        QCOMPARE(first.lower.toDouble(), 3.0);
        QCOMPARE(first.upper.toDouble(), 3.0);
    }

    /// Whole pixels are between columns of samples where pixel centres are at halves.
    void onlyVerticesOnSampleColumnsOrRowsHideAMissingPreStep()
    {
        for (const char *method : {"column-scan", "row-walk", "line-dda"}) {
            const Method &drawn = *methodNamed(QString::fromLatin1(method));
            const QString fault = nameText(wordsOf(Variant::NoEdgePreStep, drawn.spanAxis).fault);
            QVERIFY2(fault.endsWith(u"of samples does not show it."_s)
                         || fault.contains(u"on a column of samples"_s),
                     qPrintable(fault));
            for (const PixelCentre centre : {PixelCentre::Integer, PixelCentre::Half}) {
                for (const Lattice offset : {Lattice(0), unitsPerPixel / 2}) {
                    Scene scene;
                    scene.frame = frameOf(24, 20);
                    scene.frame.pixelCentre = centre;
                    scene.method = method;
                    const auto at = [offset](std::int64_t x, std::int64_t y) {
                        return LatticePoint{x * unitsPerPixel + offset, y * unitsPerPixel + offset};
                    };
                    if (drawn.draws(PrimitiveKind::Triangle))
                        scene.triangles = {triangleOf({at(1, 1), at(6, 15), at(19, 4)})};
                    else
                        scene.shapes = {lineAtUnits(at(1, 1), at(6, 15))};
                    const QImage right = drawingOf(scene);
                    scene.settings.variants = only(Variant::NoEdgePreStep);
                    const bool areOnSamples = (centre == PixelCentre::Half) == (offset != 0);
                    QCOMPARE(drawingOf(scene) == right, areOnSamples);
                }
            }
        }
    }

    /// Bresenham's lines go from smaller to larger x.
    void aLineThatIsAStepShortOpensOnlyJointsAtLargerEnds()
    {
        const auto isJointDrawn = [](std::int64_t otherEnd) {
            Scene scene = sceneOf(lineAt(2, 3, 8, 5), "line-bresenham", frameOf(24, 20));
            scene.shapes.push_back(lineAt(8, 5, otherEnd, 9));
            scene.settings.variants = only(Variant::OneStepShort);
            return pixelAt(drawingOf(scene), 8, 5) != pixelAt(drawingOf(scene), 0, 0);
        };
        QVERIFY(isJointDrawn(14));
        QVERIFY(!isJointDrawn(2));
    }

    void unsortedColoursKeepTheShapeAndExchangeTheCorners()
    {
        const Triangle triangle = unevenTriangle();
        for (const char16_t *method : {u"column-scan", u"row-walk"}) {
            const ScanPicture right = pictureOf(method, triangle, settingsWith({}));
            const ScanPicture unsorted
                = pictureOf(method, triangle, settingsWith(only(Variant::UnsortedColours)));
            QCOMPARE(int(unsorted.count()), int(right.count()));
            QVERIFY(!(unsorted == right));
        }
        // Sorted by x the order is 1, 0, 2: the left corner gets the first colour.
        const Triangle whole
            = triangleOf({latticePixel(9, 2), latticePixel(1, 4), latticePixel(20, 15)});
        const ScanPicture drawn
            = pictureOf(u"column-scan", whole, settingsWith(only(Variant::UnsortedColours)));
        QCOMPARE(drawn.at(1, 4), colourOf(whole.vertices[0].colour));
        QCOMPARE(drawn.at(9, 2), colourOf(whole.vertices[1].colour));
        QCOMPARE(drawn.at(20, 15), colourOf(whole.vertices[2].colour));
    }

    void aMethodRejectsUnknownVariantsNamingMethodsThatKnowThem()
    {
        const Method &plane = *methodNamed(u"interpolate-plane");
        const ScanSettings settings = settingsWith(only(Variant::RoundedBox));
        const QString why = plane.objection(settings);
        QVERIFY2(why.contains(u"rounded-box") && why.contains(u"edge-equations"), qPrintable(why));
        QVERIFY(plane.adapted(settings).variants.isEmpty());
        const Method &scan = *methodNamed(u"column-scan");
        QVERIFY(scan.isStableUnder({}));
        QVERIFY(!scan.isStableUnder(settingsWith(only(Variant::NoColourPreStep))));
    }

    void aSceneKeepsItsVariantsInItsFile()
    {
        Scene scene;
        scene.method = "column-scan";
        scene.triangles = {unevenTriangle()};
        scene.settings.variants = only(Variant::NoColourPreStep).with(Variant::UnsortedColours);
        const QByteArray text = writeScene(scene);
        QVERIFY(text.contains("\"variants\": [\"no-colour-pre-step\", \"unsorted-colours\"]"));
        const auto read = readScene(text);
        QVERIFY(bool(read));
        QVERIFY(read->scene.settings == scene.settings);
        scene.settings.variants = {};
        QVERIFY(!writeScene(scene).contains("variants"));
        const auto unknown = readScene(QByteArray(text).replace("unsorted-", "sorted-"));
        QVERIFY(!unknown);
        QVERIFY2(unknown.error().message().contains(u"unsorted-colours"),
                 qPrintable(unknown.error().message()));
    }

    void variantsDepartFromColoursAloneAndRefuseEffects()
    {
        Scene scene = readSceneFile(resource(u"/scenes/lit-sphere.json"_s))->scene;
        scene.method = "column-scan";
        QCOMPARE(objectionTo(scene), QString());
        scene.settings.variants = only(Variant::NoColourPreStep);
        QVERIFY2(objectionTo(scene).contains(u"variants"), qPrintable(objectionTo(scene)));
    }
};

PIXELPLUMB_TEST(TestVariants)

} // namespace tst_variants

#include "tst_variants.moc"
