// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/geometry/seededrandom.h"
#include "core/methods/method.h"
#include "core/scan/choicenames.h"
#include "core/shade/effectplan.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/effectscenes.h"
#include "tests/support/scenes/plannedtriangles.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_forcedneutrality {

using namespace pixelplumb;

namespace {

constexpr std::array antialiasings
    = {Antialiasing::None, Antialiasing::Samples4, Antialiasing::Samples16, Antialiasing::Area};

FrameBuffer pictureOf(const Method &method, const Primitives &primitives, const FrameSpec &spec,
                      const ScanSettings &settings)
{
    FrameBuffer frame(spec);
    Run(&method, primitives, settings, frame.view()).draw(frame.view());
    return frame;
}

/// Puts all vertices on one plane of depth, and some triangles by a few last bits nearer than those
/// before them: drawing order is depth order, as narrowly as can be.
void putOnOnePlane(EffectScene &scene, SeededRandom &random)
{
    const std::int64_t perX = random.between(-1000, 1000);
    const std::int64_t perY = random.between(-1000, 1000);
    std::int64_t depth = attributeOne / 2;
    for (TriangleAttributes &attributes : scene.primitives.attributes) {
        const Triangle &triangle = scene.primitives.triangles[attributes.triangle];
        depth -= random.coin() ? 0 : random.between(0, 3);
        for (std::size_t i = 0; i < 3; ++i) {
            const LatticePoint &at = triangle.vertices[i].position;
            attributes.vertices[i].z = depth
                + perX * (at.x - latticePixel(scene.frame.firstColumn, 0).x)
                + perY * (at.y - latticePixel(0, scene.frame.firstRow).y);
        }
    }
}

/// A random scene in which w, alpha and depth order call for nothing, each by a toss of a coin.
EffectScene scarcelyNeutral(std::uint64_t seed, EffectHardship hardship)
{
    EffectScene scene = randomEffectScene(seed, hardship);
    SeededRandom random(seed * 77 + std::uint64_t(hardship));
    const bool hasOneW = random.coin();
    const bool isOpaque = random.coin();
    const bool hasOneDepth = random.between(0, 3) == 0;
    const Attribute depth = random.between(0, attributeOne);
    for (TriangleAttributes &attributes : scene.primitives.attributes) {
        const Attribute w = random.between(1, 5 * attributeOne);
        for (VertexAttributes &vertex : attributes.vertices) {
            vertex.w = hasOneW ? w : vertex.w;
            vertex.alpha = isOpaque ? 255 : vertex.alpha;
            vertex.z = hasOneDepth ? depth : vertex.z;
        }
    }
    if (!hasOneDepth && random.coin())
        putOnOnePlane(scene, random);
    scene.primitives.appearance.depth = DepthUse::Auto;
    return scene;
}

/// Two triangles of one tilted plane, z = x/60: in float32 their depths come out apart.
Primitives coplanar()
{
    Primitives primitives;
    primitives.triangles
        = {triangleAt({{{0, 0}, {13, 3}, {4, 17}}}), triangleAt({{{1, 2}, {17, 5}, {2, 19}}})};
    for (std::size_t i = 0; i < 2; ++i) {
        TriangleAttributes attributes;
        attributes.triangle = i;
        for (std::size_t k = 0; k < 3; ++k)
            attributes.vertices[k].z = primitives.triangles[i].vertices[k].position.x
                * (attributeOne / (60 * unitsPerPixel));
        for (Vertex &vertex : primitives.triangles[i].vertices)
            vertex.colour = i == 0 ? Colour{{255, 0, 0}} : Colour{{0, 255, 0}};
        primitives.attributes.push_back(attributes);
    }
    return primitives;
}

} // namespace

/// What is neutral and forced on leaves the bytes in every arithmetic of every method that shades,
/// but for depths that rounding puts in another order: then the plan says so.
class TestForcedNeutrality : public QObject {
    Q_OBJECT

private slots:
    void whatIsForcedOnInVainLeavesTheBytes_data()
    {
        QTest::addColumn<QString>("method");
        for (const Method &method : methods()) {
            if (method.supports(Effect::Depth))
                QTest::newRow(qPrintable(method.id)) << method.id;
        }
    }
    void whatIsForcedOnInVainLeavesTheBytes()
    {
        QFETCH(QString, method);
        for (const EffectHardship hardship : allEffectHardships) {
            for (std::uint64_t seed = 0; seed < std::uint64_t(fewerIfSanitized(6)); ++seed) {
                for (const Antialiasing antialiasing : antialiasings)
                    forceAll(*methodNamed(method), seed, hardship, antialiasing);
            }
        }
    }

    void depthsThatRoundApartAreSaidToBe()
    {
        Primitives primitives = coplanar();
        primitives.appearance.forced[Effect::Depth] = Forcing::On;
        const FrameSpec spec = frameOf(20, 20);
        const FrameBuffer frame(spec);
        int changed = 0;
        for (const Method &method : methods()) {
            for (const Arithmetic arithmetic : allArithmetics) {
                if (!method.supports(Effect::Depth) || !method.shadesIn(arithmetic)
                    || !method.supports(arithmetic))
                    continue;
                const ScanSettings settings{arithmetic, FillRule::Closed};
                const bool isSaid = planFor(primitives, settings, frame.view())
                                        .verdicts[Effect::Depth]
                                        .reason.contains(u"rounded");
                QCOMPARE(isSaid, arithmetic != Arithmetic::Exact);
                Primitives unforced = primitives;
                unforced.appearance.forced = {};
                const bool isChanged = pictureOf(method, primitives, spec, settings).image()
                    != pictureOf(method, unforced, spec, settings).image();
                QVERIFY(!isChanged || isSaid);
                changed += isChanged ? 1 : 0;
            }
        }
        QVERIFY(changed > 0);
    }

private:
    static void forceAll(const Method &method, std::uint64_t seed, EffectHardship hardship,
                         Antialiasing antialiasing)
    {
        EffectScene scene = scarcelyNeutral(seed, hardship);
        Primitives &primitives = scene.primitives;
        primitives.appearance.antialiasing = antialiasing;
        const FillRule rule = seed % 3 != 0             ? FillRule::Closed
            : method.supports(FillRule::HalfOpenColumn) ? FillRule::HalfOpenColumn
                                                        : FillRule::TopLeft;
        for (const Arithmetic arithmetic : allArithmetics) {
            for (const ByteRounding rounding : allByteRoundings) {
                if (!method.supports(arithmetic) || !method.shadesIn(arithmetic))
                    continue;
                const ScanSettings settings{arithmetic, rule, rounding};
                primitives.appearance.forced = {};
                const FrameBuffer asCalledFor
                    = pictureOf(method, primitives, scene.frame, settings);
                const EffectPlan plan = planFor(primitives, settings, asCalledFor.view());
                for (const Effect effect :
                     {Effect::SmoothColour, Effect::Depth, Effect::Perspective, Effect::Blending}) {
                    if (plan.verdicts[effect].verdict != Verdict::NotCalledFor)
                        continue;
                    primitives.appearance.forced = {};
                    primitives.appearance.forced[effect] = Forcing::On;
                    const EffectPlan forced = planFor(primitives, settings, asCalledFor.view());
                    const bool mayDiffer = effect == Effect::Depth
                        && forced.verdicts[effect].reason.contains(u"rounded");
                    QVERIFY2(
                        mayDiffer
                            || pictureOf(method, primitives, scene.frame, settings).image()
                                == asCalledFor.image(),
                        qPrintable(u"%1, seed %2: %3, %4, %5"_s.arg(scene.name)
                                       .arg(seed)
                                       .arg(nameText(nameOf(effect)), nameText(nameOf(arithmetic)),
                                            nameText(nameOf(rounding)))));
                }
            }
        }
    }
};

PIXELPLUMB_TEST(TestForcedNeutrality)

} // namespace tst_forcedneutrality

#include "tst_forcedneutrality.moc"
