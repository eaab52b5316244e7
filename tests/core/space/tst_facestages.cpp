// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/surfaces.h"
#include "tests/support/scenes/spacescenes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <cmath>

namespace tst_facestages {

using namespace pixelplumb;

namespace {

const ProjectionStage &stageNamed(const FaceStages &stages, const QString &title)
{
    const auto stage = std::ranges::find(stages.stages, title, &ProjectionStage::title);
    if (stage == stages.stages.end())
        qFatal("no stage %s", qPrintable(title));
    return *stage;
}

const StageNumber &numberNamed(const StagePoint &point, const QString &name)
{
    const auto number = std::ranges::find(point.numbers, name, &StageNumber::name);
    if (number == point.numbers.end())
        qFatal("no number %s", qPrintable(name));
    return *number;
}

/// The least distance of points on the sphere's faces from its centre.
double nearestToCentre(const Solid &sphere)
{
    const SolidVertices<double> vertices(sphere);
    std::vector<std::size_t> face;
    double nearest = 1e9;
    for (std::size_t i = 0; i < faceCount(sphere); ++i) {
        takeFace(sphere, i, face);
        for (std::size_t k = 2; k < face.size(); ++k) {
            const auto a = vertices.vertex(face[0]).position;
            const auto b = vertices.vertex(face[k - 1]).position;
            const auto c = vertices.vertex(face[k]).position;
            constexpr int samples = 40;
            for (int s = 0; s <= samples; ++s) {
                for (int t = 0; s + t <= samples; ++t) {
                    const auto point
                        = a + double(s) / samples * (b - a) + double(t) / samples * (c - a);
                    nearest = std::min(nearest, lengthOf(point));
                }
            }
        }
    }
    return nearest;
}

} // namespace

/// The stages of a face with their numbers, and what is said about surfaces.
class TestFaceStages : public QObject {
    Q_OBJECT

private slots:
    void theStagesEndInTheTrianglesThatAreDrawn_data()
    {
        QTest::addColumn<Shading>("shading");
        QTest::newRow("flat") << Shading::Flat;
        QTest::newRow("gouraud") << Shading::Gouraud;
        QTest::newRow("phong") << Shading::Phong;
    }
    void theStagesEndInTheTrianglesThatAreDrawn()
    {
        QFETCH(Shading, shading);
        Scene scene = sceneOf({solidOf(SolidKind::Sphere), solidOf(SolidKind::Patch)});
        scene.camera->eye = {0.3, 0.4, 1.9};
        scene.camera->near = 1.3;
        scene.appearance.shading = shading;
        scene.appearance.lights = {{Light::Kind::Positional, {attributeOne, attributeOne, 0}, {}}};
        const ProjectedSolids projected = projectedSolids(scene);

        std::size_t cuts = 0;
        for (std::size_t i = 0; i < projected.triangles.size(); i += 5) {
            const FaceStages stages = stagesOf(scene, projected, i);

            const std::size_t piece = projected.sources[i].piece;
            const std::array corners = {std::size_t(0), piece + 1, piece + 2};
            for (std::size_t k = 0; k < 3; ++k) {
                QCOMPARE(stages.corners[corners[k]].vertex, projected.triangles[i].vertices[k]);
                QCOMPARE(stages.corners[corners[k]].attributes,
                         projected.attributes[i].vertices[k]);
            }
            cuts += stages.face.clipped.size() > stages.face.polygon.size() ? 1 : 0;
            QCOMPARE(stages.stages.size(), shading == Shading::Phong ? 7U : 8U);
        }
        QVERIFY(cuts > 0);
    }

    void everyUsedNumberStandsBesideTheOneWithoutRounding()
    {
        Scene scene = sceneOf({triangle3({1, 2, -3}, {-1, 0, 0}, {2, -1, 1})});
        scene.camera->fieldOfView = 90; // its cotangent is 1, that of the double is not

        const FaceStages stages = stagesOf(scene, projectedSolids(scene), 0);

        const StagePoint &divided = stageNamed(stages, u"Division"_s).points[0];
        const StageNumber &y = numberNamed(divided, u"y_device"_s);
        QCOMPARE(y.exact, u"0.25"_s);
        QVERIFY(y.used != 0.25);
        QCOMPARE(y.error, y.used - 0.25);
        const StagePoint &place = stageNamed(stages, u"Lattice"_s).points[0];
        const StageNumber &x = numberNamed(place, u"x"_s);
        QCOMPARE(x.exact, u"54.5"_s); // 49.5 + 40/8
        QCOMPARE(x.error, 0.0);
        for (const ProjectionStage &stage : stages.stages) {
            for (const StagePoint &point : stage.points) {
                for (const StageNumber &number : point.numbers) {
                    const double snap = stage.title == u"Lattice"_s ? 1.0 / 512 : 0;
                    QVERIFY(std::abs(number.error) <= 1e-13 + snap);
                    QVERIFY(std::abs(number.exact.toDouble() - number.used) <= 1e-13 + snap);
                }
            }
        }
    }

    void theClippedPolygonSaysWhichEdgeIsCutAndWhere()
    {
        // Depths 3, 7 and 0.5 with a near plane at 1: t = 2/2.5 from the first, 6/6.5 from the
        // second.
        const Scene scene = sceneOf({triangle3({0, 0, 2}, {1, 0, -2}, {0, 1, 4.5})});

        const FaceStages stages = stagesOf(scene, projectedSolids(scene), 0);

        const auto &points = stageNamed(stages, u"Clipped polygon"_s).points;
        QCOMPARE(points.size(), 4U);
        QCOMPARE(points[1].note, u"V₁, kept"_s);
        QCOMPARE(points[2].note, u"the near plane cuts V₁V₂"_s);
        QCOMPARE(points[3].note, u"the near plane cuts V₀V₂"_s);
        QVERIFY(std::abs(numberNamed(points[2], u"t"_s).used - 6 / 6.5) < 1e-15);
        QCOMPARE(numberNamed(points[3], u"t"_s).exact, u"0.8"_s);
    }

    void theColoursOfClippedCornersAndTheLightHaveFormulas_data()
    {
        QTest::addColumn<Shading>("shading");
        QTest::newRow("flat") << Shading::Flat;
        QTest::newRow("gouraud") << Shading::Gouraud;
    }
    void theColoursOfClippedCornersAndTheLightHaveFormulas()
    {
        QFETCH(Shading, shading);
        Scene scene = sceneOf({triangle3({0, 0, 2}, {1, 0, -2}, {0, 1, 4.5})});
        scene.appearance.shading = shading;
        scene.appearance.lights = {{Light::Kind::Directional, {0, 0, -attributeOne}, {}},
                                   {Light::Kind::Positional, {attributeOne, attributeOne, 0}, {}}};
        const FaceStages stages = stagesOf(scene, projectedSolids(scene), 0);

        // V₀V₂ is cut at t = 2/2.5.
        const auto &corners = stageNamed(stages, u"Clipped polygon"_s).points;
        const StageNumber &cut = numberNamed(corners[3], u"R"_s);
        QCOMPARE(cut.formula, u"R_V₀ + t·(R_V₂ − R_V₀)"_s);
        const auto levelOf
            = [&](std::size_t vertex) { return stages.face.polygon[vertex].levels[0]; };
        QVERIFY(std::abs(cut.used - (levelOf(0) + 0.8 * (levelOf(2) - levelOf(0)))) < 1e-9);
        QCOMPARE(numberNamed(corners[1], u"α"_s).formula, u"α_V₁"_s);
        QCOMPARE(numberNamed(stageNamed(stages, u"Lattice"_s).points[3], u"G"_s).formula,
                 u"⌊G′ + ½⌋"_s);
        const bool isFlat = shading == Shading::Flat;
        const ProjectionStage &light = stageNamed(
            stages, isFlat ? u"Light at the face's centre"_s : u"Light at the vertices"_s);
        QCOMPARE(light.points.front().name, u"the lights"_s);
        for (std::size_t i = 1; i < light.points.size(); ++i) {
            for (const StageNumber &number : light.points[i].numbers)
                QVERIFY2(!number.formula.isEmpty(), qPrintable(number.name));
        }
        QCOMPARE(light.points.size(), isFlat ? 2U : 4U);
    }

    void aSpheresDistanceIsWhatItsFacesHave_data()
    {
        QTest::addColumn<int>("around");
        QTest::addColumn<int>("along");
        for (const auto &[around, along] : {std::pair(3, 2), {4, 2}, {16, 8}, {5, 20}, {40, 3}})
            QTest::addRow("%d by %d", around, along) << around << along;
    }
    void aSpheresDistanceIsWhatItsFacesHave()
    {
        QFETCH(int, around);
        QFETCH(int, along);
        Solid sphere = solidOf(SolidKind::Sphere);
        sphere.segments = {around, along};

        const double sampled = 1 - nearestToCentre(sphere);
        const double distance = sphereDistance(1, sphere.segments);

        QVERIFY(distance >= sampled - 1e-12);
        QVERIFY(distance <= sampled * 1.02 + 1e-12);
        QCOMPARE(sphereDistance(7, sphere.segments), 7 * distance);
    }

    void aPatchsDistanceShrinksWithTheSquareOfItsSegments()
    {
        Solid patch = solidOf(SolidKind::Patch);
        patch.segments = {8, 8};
        const double coarse = patchDistance(patch);
        patch.segments = {16, 16};
        const double fine = patchDistance(patch);
        QVERIFY(coarse / fine > 3.5 && coarse / fine < 4.5);

        for (SolidCorner &corner : patch.corners)
            corner.position[2] = 0;
        QVERIFY(patchDistance(patch) < 1e-12);
    }

    void aPatchsNormalsStandOnItAlsoWhereItsTangentsVanish()
    {
        Solid patch = solidOf(SolidKind::Patch);
        // A degenerate corner: ∂P/∂u = 0 there.
        patch.corners[1] = patch.corners[0];
        const BezierPatch<double> surface(patch);

        const SpaceVector<double> degenerate = surface.normal(0, 0);
        const SpaceVector<double> beside = surface.normal(0.01, 0.01);

        QVERIFY(std::abs(lengthOf(degenerate) - 1) < 1e-12);
        QVERIFY(dot(degenerate, beside) > 0.9);
    }

    void theThreeFormsNameTheSamePoint_data()
    {
        QTest::addColumn<SurfaceKind>("kind");
        for (const SurfaceKind kind : allSurfaces)
            QTest::newRow(qPrintable(nameOf(kind))) << kind;
    }
    void theThreeFormsNameTheSamePoint()
    {
        QFETCH(SurfaceKind, kind);
        const Surface surface{kind, {{{1, 2, 3}, {4, 1, 5}, {0, 3, 9}}}, 2.5};
        for (const double s : {0.05, 0.3, 0.55, 0.9}) {
            const std::vector<SurfaceForm> forms = formsOf(surface, s, 0.3);

            QCOMPARE(forms.size(), 3U);
            const StageNumber &last = forms[1].numbers.back();
            QCOMPARE(forms[0].numbers.at(0).name, last.name);
            QVERIFY(std::abs(forms[0].numbers[0].used - last.used) < 1e-12);
            QVERIFY(std::abs(forms[2].numbers.at(0).used) < 1e-12);
            QCOMPARE(forms[2].numbers[0].exact.toDouble(), 0.0);
        }
    }

    void aVerticalLineHasNoExplicitForm()
    {
        const Surface surface{SurfaceKind::Line, {{{1, 2, 0}, {1, 5, 0}, {}}}, 1};

        const std::vector<SurfaceForm> forms = formsOf(surface, 0.5, 0);

        QVERIFY(forms[0].numbers.empty());
        QCOMPARE(forms[1].numbers.at(1).used, 3.5);
    }
};

PIXELPLUMB_TEST(TestFaceStages)

} // namespace tst_facestages

#include "tst_facestages.moc"
