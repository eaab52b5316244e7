// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/geometry/seededrandom.h"
#include "core/methods/method.h"
#include "core/oracle/oracle.h"
#include "core/oracle/squarearea.h"
#include "core/oracle/truepicture.h"
#include "core/runs/tracedscene.h"
#include "core/scan/tests/edgeteststate.h"
#include "core/shade/edgepixels.h"
#include "core/shade/effectplan.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/effectscenes.h"
#include "tests/support/scenes/plannedtriangles.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_planneutrality {

using namespace pixelplumb;

namespace {

constexpr std::array allAntialiasings
    = {Antialiasing::None, Antialiasing::Samples4, Antialiasing::Samples16, Antialiasing::Area};
/// The effects that change no byte where they are not needed.
constexpr std::array neutralEffects
    = {Effect::SmoothColour, Effect::Depth, Effect::Perspective, Effect::Blending};

QString textOf(Effect effect)
{
    const std::string_view name = nameOf(effect);
    return QString::fromLatin1(name.data(), qsizetype(name.size()));
}

QString textOf(Antialiasing antialiasing)
{
    static const std::array names = {QStringLiteral("1 sample"), QStringLiteral("4 samples"),
                                     QStringLiteral("16 samples"), QStringLiteral("area")};
    return names[std::size_t(antialiasing)];
}

FrameBuffer pictureOf(const QString &method, const Primitives &primitives, const FrameSpec &spec,
                      FillRule rule = FillRule::Closed)
{
    FrameBuffer frame(spec);
    Run(methodNamed(method), primitives, {Arithmetic::Exact, rule, {}}, frame.view(),
        Kernels::Plain)
        .draw(frame.view());
    return frame;
}

bool areSame(const FrameBuffer &a, const FrameBuffer &b) { return a.image() == b.image(); }

/// How a picture changes if an effect that is not needed is forced off, or a neutral one on; empty
/// if no byte changes.
QString changeByForcing(const QString &method, Primitives primitives, const FrameSpec &spec,
                        FillRule rule)
{
    const FrameBuffer asCalledFor = pictureOf(method, primitives, spec, rule);
    const EffectPlan plan = planFor(primitives, {Arithmetic::Exact, rule, {}}, asCalledFor.view());
    const auto isChangedBy = [&](Effect effect, Forcing forcing) {
        primitives.appearance.forced = {};
        primitives.appearance.forced[effect] = forcing;
        return !areSame(pictureOf(method, primitives, spec, rule), asCalledFor);
    };
    for (const Effect effect : allEffects) {
        if (plan.verdicts[effect].verdict != Verdict::NotCalledFor)
            continue;
        if (isChangedBy(effect, Forcing::Off))
            return textOf(effect) + QStringLiteral(" is not called for, and off changes it: ")
                + plan.verdicts[effect].reason;
        const bool isNeutral = std::ranges::find(neutralEffects, effect) != neutralEffects.end();
        if (isNeutral && isChangedBy(effect, Forcing::On))
            return textOf(effect) + QStringLiteral(" is not called for, and on changes it: ")
                + plan.verdicts[effect].reason;
    }
    return {};
}

/// The same triangles without anything that the effect would show.
Primitives without(Effect effect, Primitives primitives)
{
    for (Triangle &triangle : primitives.triangles) {
        for (Vertex &vertex : triangle.vertices)
            vertex.colour
                = effect == Effect::SmoothColour ? triangle.vertices[0].colour : vertex.colour;
    }
    for (TriangleAttributes &attributes : primitives.attributes) {
        for (VertexAttributes &vertex : attributes.vertices) {
            vertex.alpha = effect == Effect::Blending ? 255 : vertex.alpha;
            vertex.w = effect == Effect::Perspective ? attributeOne : vertex.w;
        }
    }
    for (Material &material : primitives.appearance.materials) {
        if (effect == Effect::Texture)
            material.texture.reset();
    }
    if (effect == Effect::Light)
        primitives.appearance.lights.clear();
    if (effect == Effect::Depth)
        primitives.appearance.depth = DepthUse::Off;
    return primitives;
}

/// A line in and around a frame of 12 × 9 pixels; some lie along its rows and reach beyond it.
Shape randomLine(SeededRandom &random)
{
    const Lattice step = random.coin() ? unitsPerPixel : unitsPerPixel / 2;
    const auto at = [&](std::int64_t pixels) {
        return random.between(-2 * unitsPerPixel / step, (pixels + 2) * unitsPerPixel / step)
            * step;
    };
    Shape line;
    const Colour first = random.colour();
    const LatticePoint from = {at(12), at(9)};
    LatticePoint to = {at(12), at(9)};
    if (random.coin())
        to.y = from.y;
    line.vertices = {{from, first}, {to, random.coin() ? first : random.colour()}};
    return line;
}

/// A triangle around a frame of 6 × 5 pixels, as thin as a sliver or within few of its squares;
/// some are segments. Its vertices are on the lattice, on quarters of a pixel, or on samples.
Triangle thinTriangle(SeededRandom &random)
{
    constexpr std::array<Lattice, 3> steps = {1, unitsPerPixel / 4, unitsPerPixel};
    const Lattice step = steps[std::size_t(random.between(0, 2))];
    const auto at = [&](std::int64_t pixels) {
        return random.between(-unitsPerPixel / step, pixels * unitsPerPixel / step) * step;
    };
    const std::int64_t width = random.coin() ? 6 : 1;
    const std::int64_t height = random.coin() ? 5 : 1;
    const LatticePoint shift = {latticePixel(random.between(0, 6 - width), 0).x,
                                latticePixel(0, random.between(0, 5 - height)).y};
    Triangle triangle;
    for (Vertex &vertex : triangle.vertices) {
        const LatticePoint place = {at(width), at(height)};
        vertex = {{place.x + shift.x, place.y + shift.y}, random.colour()};
    }
    if (random.coin()) { // along its first edge
        const LatticePoint &a = triangle.vertices[0].position;
        const LatticePoint &b = triangle.vertices[1].position;
        triangle.vertices[2].position = {(a.x + b.x) / 2 + random.between(-1, 1) * step,
                                         (a.y + b.y) / 2 + random.between(-1, 1) * step};
    }
    return triangle;
}

/// Whether the oracle draws the triangle at a pixel.
bool isDrawnAt(const Triangle &triangle, FillRule rule, Antialiasing antialiasing, std::int64_t x,
               std::int64_t y)
{
    if (antialiasing == Antialiasing::None || doubledArea(triangle) == 0)
        return oracle::covers(triangle, rule, x, y);
    if (antialiasing == Antialiasing::Area)
        return oracle::areaInSquare(triangle, x, y) > 0;
    return std::ranges::any_of(samplePattern(antialiasing), [&](const LatticePoint &sample) {
        Triangle moved = triangle;
        for (Vertex &vertex : moved.vertices)
            vertex.position = {vertex.position.x - sample.x, vertex.position.y - sample.y};
        return oracle::covers(moved, rule, x, y);
    });
}

} // namespace

/// Pictures confirm the verdicts: forcing off what is not needed, or forcing on what is neutral,
/// leaves every byte, however many samples a pixel has.
class TestPlanNeutrality : public QObject {
    Q_OBJECT

private slots:
    void forcingUnneededEffectsChangesNoByte_data()
    {
        QTest::addColumn<EffectHardship>("hardship");
        QTest::addColumn<Antialiasing>("antialiasing");
        for (const EffectHardship hardship : allEffectHardships) {
            for (const Antialiasing antialiasing : allAntialiasings)
                QTest::addRow("%s, %s", qPrintable(nameOf(hardship)),
                              qPrintable(textOf(antialiasing)))
                    << hardship << antialiasing;
        }
    }
    void forcingUnneededEffectsChangesNoByte()
    {
        QFETCH(EffectHardship, hardship);
        QFETCH(Antialiasing, antialiasing);
        for (std::uint64_t seed = 0; seed < std::uint64_t(fewerIfSanitized(12)); ++seed) {
            EffectScene scene = randomEffectScene(seed, hardship);
            scene.primitives.appearance.antialiasing = antialiasing;
            scene.primitives.appearance.depth = DepthUse::Auto;
            const bool isColumnScan = seed % 2 == 0;
            const FillRule rule = seed % 3 != 0 ? FillRule::Closed
                : isColumnScan                  ? FillRule::HalfOpenColumn
                                                : FillRule::TopLeft;
            const QString method = isColumnScan ? QStringLiteral("column-scan")
                                                : QStringLiteral("interpolate-plane");
            const QString change = changeByForcing(method, scene.primitives, scene.frame, rule);
            QVERIFY2(
                change.isEmpty(),
                qPrintable(QStringLiteral("seed %1, %2: ").arg(seed).arg(scene.name) + change));
        }
    }

    void whatIsForcedOffIsAsIfNoTriangleHadIt_data() { forcingUnneededEffectsChangesNoByte_data(); }
    void whatIsForcedOffIsAsIfNoTriangleHadIt()
    {
        QFETCH(EffectHardship, hardship);
        QFETCH(Antialiasing, antialiasing);
        for (std::uint64_t seed = 0; seed < std::uint64_t(fewerIfSanitized(6)); ++seed) {
            EffectScene scene = randomEffectScene(seed, hardship);
            Appearance &appearance = scene.primitives.appearance;
            appearance.antialiasing = antialiasing;
            appearance.shading = Shading::Phong; // the other shadings light the vertices, whose
                                                 // colours then matter
            const QString method = seed % 2 == 0 ? QStringLiteral("column-scan")
                                                 : QStringLiteral("interpolate-barycentric");
            for (const Effect effect : {Effect::SmoothColour, Effect::Depth, Effect::Perspective,
                                        Effect::Texture, Effect::Light, Effect::Blending}) {
                const FrameBuffer expected
                    = pictureOf(method, without(effect, scene.primitives), scene.frame);
                appearance.forced = {};
                appearance.forced[effect] = Forcing::Off;
                QVERIFY2(areSame(pictureOf(method, scene.primitives, scene.frame), expected),
                         qPrintable(QStringLiteral("seed %1, %2, %3 off")
                                        .arg(seed)
                                        .arg(scene.name, textOf(effect))));
                appearance.forced = {};
            }
        }
    }

    /// The legs of the right angle cut pixels into halves, and its corner into quarters.
    void anAreaCountsAloneWhereBlendingIsForcedOff()
    {
        Primitives primitives;
        primitives.triangles = {Triangle{{{{latticePixel(1, 1), {{255, 255, 255}}},
                                           {latticePixel(7, 1), {{255, 255, 255}}},
                                           {latticePixel(1, 7), {{255, 255, 255}}}}}}};
        TriangleAttributes attributes;
        for (VertexAttributes &vertex : attributes.vertices)
            vertex.alpha = 128;
        primitives.attributes = {attributes};
        primitives.appearance.antialiasing = Antialiasing::Area;
        const auto levelsOf = [&] {
            const FrameBuffer frame
                = pictureOf(QStringLiteral("column-scan"), primitives, frameOf(8, 8));
            return std::array{qRed(*frame.view().at(1, 1)), qRed(*frame.view().at(1, 2)),
                              qRed(*frame.view().at(2, 2))};
        };
        QCOMPARE(levelsOf(), (std::array{32, 64, 128})); // ⌊128·A + ½⌋
        primitives.appearance.forced[Effect::Blending] = Forcing::Off;
        QCOMPARE(levelsOf(), (std::array{64, 128, 255})); // ⌊255·A + ½⌋
    }

    /// A sliver between all samples draws nothing, but its edges split a pixel of the board.
    void anEdgeBetweenSamplesSplitsOtherTrianglesPixels_data()
    {
        QTest::addColumn<Antialiasing>("antialiasing");
        QTest::newRow("4 samples") << Antialiasing::Samples4;
        QTest::newRow("16 samples") << Antialiasing::Samples16;
    }
    void anEdgeBetweenSamplesSplitsOtherTrianglesPixels()
    {
        QFETCH(Antialiasing, antialiasing);
        Primitives primitives;
        primitives.triangles = {triangleAt({{{-9, -9}, {20, -9}, {-9, 20}}}), triangleAt({})};
        setTexture(primitives, 0);
        for (VertexAttributes &vertex : primitives.attributes[0].vertices)
            vertex.texture = {9 * vertex.texture[0], 9 * vertex.texture[1]};
        auto &sliver = primitives.triangles[1].vertices;
        sliver[0].position = {320, 64};
        sliver[1].position = {352, 64};
        sliver[2].position = {352, 96};
        primitives.appearance.antialiasing = antialiasing;
        const FrameSpec spec = frameOf(3, 2);
        const FrameBuffer truth(spec);
        const EffectPlan plan = planFor(primitives, {}, truth.view());
        QCOMPARE(plan.antialiasing, antialiasing);
        QCOMPARE(plan.verdicts[Effect::Antialiasing].verdict, Verdict::CalledFor);
        QCOMPARE(plan.verdicts[Effect::Antialiasing].primitives, std::size_t(1));
        oracle::drawPicture(primitives, {}, &plan, truth.view());
        const FrameBuffer drawn = pictureOf(QStringLiteral("column-scan"), primitives, spec);
        QVERIFY(areSame(drawn, truth));
        primitives.appearance.forced[Effect::Antialiasing] = Forcing::Off;
        QVERIFY(!areSame(pictureOf(QStringLiteral("column-scan"), primitives, spec), drawn));
    }

    /// Only methods that shade by a plan can leave out colours; the others say that they cannot.
    void aMethodThatCannotLeaveOutColoursSaysSo()
    {
        Primitives primitives;
        primitives.triangles = {triangleAt({{{1, 1}, {7, 1}, {1, 7}}})};
        primitives.triangles[0].vertices[1].colour = {{255, 0, 0}};
        primitives.appearance.forced[Effect::SmoothColour] = Forcing::Off;
        const FrameBuffer frame(frameOf(8, 8));
        const EffectPlan plan = planFor(primitives, {}, frame.view());
        int able = 0;
        for (const Method &method : methods()) {
            if (!method.draws(PrimitiveKind::Triangle))
                continue;
            const FrameBuffer drawn = pictureOf(method.id, primitives, frameOf(8, 8));
            const bool isFlat = *drawn.view().at(1, 1) == *drawn.view().at(4, 2);
            QVERIFY2(method.objection(plan, {}).isEmpty() == isFlat, qPrintable(method.id));
            able += isFlat ? 1 : 0;
        }
        QCOMPARE(able, 4);
        QVERIFY(methodNamed(u"row-walk")
                    ->objection(plan, {})
                    .startsWith(QStringLiteral("cannot leave out smooth colour, which is forced "
                                               "off; column-scan, ")));
    }

    /// A triangle needs colours, blending, texture and light if it is drawn at some sample of the
    /// frame, and nowhere else.
    void aTriangleBetweenTheSamplesCallsForNothing()
    {
        SeededRandom random(11);
        const FrameSpec spec = frameOf(6, 5);
        const FrameBuffer frame(spec);
        int drawn = 0;
        int between = 0; // those whose bounding box contains samples but which contain none
        for (int i = 0; i < fewerIfSanitized(6000); ++i) {
            const FillRule rule = std::array{FillRule::Closed, FillRule::TopLeft, FillRule::Open,
                                             FillRule::HalfOpenColumn}[std::size_t(i) % 4];
            const Antialiasing antialiasing = allAntialiasings[std::size_t(i) / 4 % 4];
            Primitives primitives;
            primitives.triangles = {thinTriangle(random)};
            primitives.triangles[0].vertices[0].colour = {{255, 0, 0}};
            primitives.triangles[0].vertices[1].colour = {{0, 255, 0}};
            primitives.appearance.antialiasing = antialiasing;
            const Triangle &triangle = primitives.triangles[0];
            bool isDrawn = false;
            for (std::int64_t y = 0; y < 5; ++y) {
                for (std::int64_t x = 0; x < 6; ++x)
                    isDrawn |= isDrawnAt(triangle, rule, antialiasing, x, y);
            }
            // Antialiasing that changes nothing does not run; pixels then have only their own
            // samples.
            const EffectPlan plan
                = planFor(primitives, {Arithmetic::Exact, rule, {}}, frame.view());
            const EffectVerdict &smooth = plan.verdicts[Effect::SmoothColour];
            // A point shows only its first vertex.
            const bool isPoint = triangle.vertices[0].position == triangle.vertices[1].position
                && triangle.vertices[0].position == triangle.vertices[2].position;
            const bool isSmooth = isDrawn && !isPoint;
            QVERIFY2((smooth.verdict == Verdict::CalledFor) == isSmooth,
                     qPrintable(QStringLiteral("case %1, %2: %3")
                                    .arg(i)
                                    .arg(textOf(antialiasing), smooth.reason)));
            QCOMPARE(plan.runs(Effect::SmoothColour), isSmooth);
            if (!isDrawn) {
                QCOMPARE(smooth.reason, QStringLiteral("nothing is drawn in the frame"));
                // A triangle that vanishes between four samples vanishes through antialiasing.
                bool isDrawnWithout = false;
                for (std::int64_t y = 0; y < 5; ++y) {
                    for (std::int64_t x = 0; x < 6; ++x)
                        isDrawnWithout |= isDrawnAt(triangle, rule, Antialiasing::None, x, y);
                }
                QCOMPARE(plan.runs(Effect::Antialiasing), isDrawnWithout);
                QCOMPARE(plan.verdicts[Effect::Antialiasing].verdict == Verdict::CalledFor,
                         isDrawnWithout);
                between += intersection(boundingBoxOf(triangle), samplesOf(frame.view())).isEmpty()
                    ? 0
                    : 1;
            }
            drawn += isDrawn ? 1 : 0;
        }
        QVERIFY(drawn > fewerIfSanitized(1000));
        QVERIFY(between > fewerIfSanitized(100));
    }

    /// In the one pixel that it meets, 1/w is −74/25: nothing is drawn there, and only perspective
    /// knows that. Without it the pixel is painted.
    void aTriangleBeyondItsHorizonCallsForPerspective()
    {
        Primitives primitives;
        primitives.triangles = {Triangle{{{{{576, 288}, {{255, 0, 0}}},
                                           {{608, 288}, {{255, 0, 0}}},
                                           {{576, 320}, {{0, 0, 255}}}}}}};
        TriangleAttributes attributes;
        attributes.vertices[0].w = 100 * attributeOne;
        attributes.vertices[1].w = attributes.vertices[2].w = attributeOne;
        primitives.attributes = {attributes};
        primitives.appearance.antialiasing = Antialiasing::Area;
        const FrameBuffer frame(frameOf(6, 4));
        const EffectPlan plan = planFor(primitives, {}, frame.view());
        QVERIFY(plan.runs(Effect::Perspective));
        QCOMPARE(plan.verdicts[Effect::Perspective].verdict, Verdict::CalledFor);
        QCOMPARE(plan.verdicts[Effect::SmoothColour].verdict, Verdict::CalledFor);

        Scene scene;
        scene.frame = frameOf(6, 4);
        scene.triangles = primitives.triangles;
        scene.attributes = primitives.attributes;
        scene.appearance = primitives.appearance;
        QVERIFY(coverageOf(SceneRun(scene)) == CoverageMask(scene.frame));
        scene.appearance.forced[Effect::Perspective] = Forcing::Off;
        QVERIFY(!(coverageOf(SceneRun(scene)) == CoverageMask(scene.frame)));
    }

    /// The stroke's border lies on the border of the frame's squares, and the stroke is on the
    /// outer side.
    void aLineOutsideTheFrameNeedsNoAntialiasing_data()
    {
        QTest::addColumn<Antialiasing>("antialiasing");
        QTest::addColumn<int>("row"); // halves
        QTest::addColumn<bool>("isCalledFor");
        for (const Antialiasing antialiasing :
             {Antialiasing::Samples4, Antialiasing::Samples16, Antialiasing::Area}) {
            const auto add = [&](const char *where, int row, bool isCalledFor) {
                QTest::addRow("%s, %s", where, qPrintable(textOf(antialiasing)))
                    << antialiasing << row << isCalledFor;
            };
            add("below", -2, false);
            add("above", 18, false);
            add("half in it", -1, true);
            add("all in it", 8, antialiasing != Antialiasing::Area);
        }
    }
    void aLineOutsideTheFrameNeedsNoAntialiasing()
    {
        QFETCH(Antialiasing, antialiasing);
        QFETCH(int, row);
        QFETCH(bool, isCalledFor);
        Primitives primitives;
        Shape line;
        const Lattice y = row * unitsPerPixel / 2;
        line.vertices
            = {{{-2 * unitsPerPixel, y}, {{255, 0, 0}}}, {{14 * unitsPerPixel, y}, {{255, 0, 0}}}};
        primitives.shapes = {line};
        primitives.appearance.antialiasing = antialiasing;
        const FrameBuffer frame(frameOf(12, 9));
        const EffectPlan plan = planFor(primitives, {}, frame.view());
        QCOMPARE(plan.verdicts[Effect::Antialiasing].verdict == Verdict::CalledFor, isCalledFor);
        QCOMPARE(plan.runs(Effect::Antialiasing), isCalledFor);
    }

    void whatALineDoesNotCallForChangesNoByteEitherWay()
    {
        SeededRandom random(7);
        const FrameSpec spec = frameOf(12, 9);
        int withoutEdges = 0;
        for (int i = 0; i < fewerIfSanitized(300); ++i) {
            Primitives primitives;
            primitives.shapes = {randomLine(random)};
            primitives.appearance.antialiasing = allAntialiasings[std::size_t(i) % 4];
            const QString change = changeByForcing(QStringLiteral("stroke-coverage"), primitives,
                                                   spec, FillRule::Closed);
            QVERIFY2(change.isEmpty(), qPrintable(QString::number(i) + u' ' + change));
            const FrameBuffer frame(spec);
            const EffectPlan plan = planFor(primitives, {}, frame.view());
            withoutEdges += i % 4 != 0 && !plan.runs(Effect::Antialiasing) ? 1 : 0;
        }
        QVERIFY(withoutEdges > 0);
    }

    /// The line goes from red to green over eight pixels; in one colour it is all red.
    void aLineIsInItsFirstColourOnceSmoothColourIsForcedOff_data()
    {
        QTest::addColumn<QString>("method");
        for (const char *method : {"line-dda", "line-slope-intercept", "line-parametric",
                                   "line-bresenham-symmetric", "stroke-coverage"})
            QTest::newRow(method) << QString::fromLatin1(method);
    }
    void aLineIsInItsFirstColourOnceSmoothColourIsForcedOff()
    {
        QFETCH(QString, method);
        const FrameSpec spec = frameOf(12, 9);
        Primitives primitives;
        Shape line;
        line.vertices = {{latticePixel(1, 4), Colour{{255, 0, 0}}},
                         {latticePixel(9, 4), Colour{{0, 255, 0}}}};
        primitives.shapes = {line};
        const FrameBuffer smooth = pictureOf(method, primitives, spec);
        QCOMPARE(*smooth.view().at(5, 4), qRgb(128, 128, 0));

        primitives.appearance.forced[Effect::SmoothColour] = Forcing::Off;
        const FrameBuffer flat = pictureOf(method, primitives, spec);
        FrameBuffer truth(spec);
        oracle::drawPicture(primitives, {}, nullptr, truth.view());
        for (int x = 2; x < 9; ++x) {
            QCOMPARE(*flat.view().at(x, 4), qRgb(255, 0, 0));
            QCOMPARE(*truth.view().at(x, 4), qRgb(255, 0, 0));
        }
    }

    /// A triangle whose verdict is that it lies inside is drawn in a frame that reaches two pixels
    /// farther: it paints nothing beyond the first frame's border, or everything.
    void whatNeedsNoClippingStaysOnOneSideOfTheBorder()
    {
        for (const EffectHardship hardship : allEffectHardships) {
            for (std::uint64_t seed = 0; seed < std::uint64_t(fewerIfSanitized(24)); ++seed) {
                const EffectScene scene = randomEffectScene(seed, hardship);
                for (std::size_t i = 0; i < scene.primitives.triangles.size(); ++i)
                    compareBeyondBorder(scene, i, allAntialiasings[seed % 4]);
            }
        }
    }

private:
    static void compareBeyondBorder(const EffectScene &scene, std::size_t index,
                                    Antialiasing antialiasing)
    {
        Primitives alone;
        alone.triangles = {scene.primitives.triangles[index]};
        for (Vertex &vertex : alone.triangles[0].vertices)
            vertex.colour = {{255, 255, 255}};
        alone.appearance.antialiasing = antialiasing;
        constexpr std::int32_t beyond = 2;
        const FrameSpec &spec = scene.frame;
        FrameSpec wide = frameOf(spec.width + 2 * beyond, spec.height + 2 * beyond,
                                 spec.firstColumn - beyond, spec.firstRow - beyond);
        wide.origin = spec.origin;
        const FrameBuffer drawn = pictureOf(QStringLiteral("interpolate-plane"), alone, wide);
        const FrameBuffer frame(spec);
        const FrameView view = drawn.view();
        bool isInside = false, isOutside = false;
        for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
            for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x) {
                if (qRed(*view.at(x, y)) != 0)
                    (frame.view().contains(x, y) ? isInside : isOutside) = true;
            }
        }
        const EffectVerdict clipping = planFor(alone, {}, frame.view()).verdicts[Effect::Clipping];
        if (isInside && isOutside)
            QVERIFY2(clipping.verdict == Verdict::CalledFor, qPrintable(scene.name));
    }
};

PIXELPLUMB_TEST(TestPlanNeutrality)

} // namespace tst_planneutrality

#include "tst_planneutrality.moc"
