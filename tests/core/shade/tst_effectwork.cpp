// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/oracle/effectoracle.h"
#include "core/shade/shadeddrawing.h"
#include "tests/support/scenes/effectscenes.h"
#include "tests/support/scenes/planbyhand.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_effectwork {

using namespace pixelplumb;

namespace {

constexpr std::array shadedMethods = {ShadedMethod::ColumnScan, ShadedMethod::Bilinear,
                                      ShadedMethod::Plane, ShadedMethod::Barycentric};

/// (0, 0), (16, 0), (0, 16): 17 + 16 + … + 1 = 153 samples, with every effect.
constexpr std::int64_t slopeSamples = 153;
Primitives everything()
{
    Primitives primitives;
    Triangle triangle;
    triangle.vertices = {{{latticePixel(0, 0), {{255, 0, 0}}},
                          {latticePixel(16, 0), {{0, 255, 0}}},
                          {latticePixel(0, 16), {{0, 0, 255}}}}};
    TriangleAttributes attributes{0, {}, 0};
    for (VertexAttributes &vertex : attributes.vertices) {
        vertex.normal = {0, 0, attributeOne};
        vertex.alpha = 128;
    }
    attributes.vertices[1].w = 2 * attributeOne;
    primitives.triangles = {triangle};
    primitives.attributes = {attributes};
    Material material;
    material.texture = std::make_shared<Texture>(checkerTexture());
    primitives.appearance.materials = {material};
    primitives.appearance.lights = {{Light::Kind::Directional, {0, 0, -attributeOne}, {}}};
    primitives.appearance.depth = DepthUse::On;
    return primitives;
}

/// Adds the same triangle again, farther away.
void addBehind(Primitives &primitives)
{
    primitives.triangles.push_back(primitives.triangles.front());
    TriangleAttributes attributes = primitives.attributes.front();
    attributes.triangle = 1;
    for (VertexAttributes &vertex : attributes.vertices)
        vertex.z = attributeOne;
    primitives.attributes.push_back(attributes);
}

EffectTally tallyOf(ShadedMethod method, const Primitives &primitives)
{
    FrameBuffer frame(frameOf(20, 20));
    return drawShaded(method, primitives, {}, frame.view(), planByHand(primitives)).value();
}

} // namespace

/// Counts what the effect kernels do at a sample.
class TestEffectWork : public QObject {
    Q_OBJECT

private slots:
    void unneededEffectsDoNoWork()
    {
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            const EffectScene scene = randomEffectScene(seed, EffectHardship::None);
            const EffectPlan plan = planByHand(scene.primitives);
            FrameBuffer frame(scene.frame);
            const EffectTally tally
                = drawShaded(ShadedMethod::Plane, scene.primitives, {}, frame.view(), plan).value();
            const auto isThere = [&](const auto &asks) {
                return std::ranges::any_of(
                    plan.batches, [&](const EffectBatch &batch) { return asks(batch.effects); });
            };
            const auto agree
                = [&](bool mayBeDone, std::int64_t done) { return mayBeDone || done == 0; };
            const bool hasDepth
                = isThere([](const EffectSet &set) { return set.depth != DepthTest::None; });
            QVERIFY2(agree(hasDepth, tally[EffectWork::DepthRead]), qPrintable(scene.name));
            QVERIFY2(agree(hasDepth, tally[EffectWork::DepthWrite]), qPrintable(scene.name));
            QCOMPARE(tally.depthBytes > 0, hasDepth);
            QVERIFY2(agree(isThere([](const EffectSet &set) { return set.perspective; }),
                           tally[EffectWork::Division]),
                     qPrintable(scene.name));
            QVERIFY2(agree(isThere([](const EffectSet &set) { return set.texture; }),
                           tally[EffectWork::TexelFetch]),
                     qPrintable(scene.name));
            QVERIFY2(agree(isThere([](const EffectSet &set) { return set.light; }),
                           tally[EffectWork::Normal]),
                     qPrintable(scene.name));
            QVERIFY2(agree(isThere([](const EffectSet &set) { return set.blending; })
                               || plan.antialiasing == Antialiasing::Area,
                           tally[EffectWork::Blend]),
                     qPrintable(scene.name));
        }
    }

    void eachSampleIsWorkedOnOnce()
    {
        for (const ShadedMethod method : shadedMethods) {
            const EffectTally tally = tallyOf(method, everything());
            for (const EffectWork work :
                 {EffectWork::Sample, EffectWork::DepthRead, EffectWork::DepthWrite,
                  EffectWork::Division, EffectWork::TexelFetch, EffectWork::Normal,
                  EffectWork::Blend})
                QCOMPARE(tally[work], slopeSamples);
        }
    }

    void bilinearTexturesAreReadFourTimesASample()
    {
        Primitives primitives = everything();
        primitives.appearance.materials[0].filter = TextureFilter::Bilinear;
        QCOMPARE(tallyOf(ShadedMethod::Bilinear, primitives)[EffectWork::TexelFetch],
                 4 * slopeSamples);
    }

    void aHiddenSampleOnlyComparesDepth()
    {
        Primitives primitives = everything();
        addBehind(primitives);
        const EffectTally tally = tallyOf(ShadedMethod::ColumnScan, primitives);
        QCOMPARE(tally[EffectWork::DepthRead], 2 * slopeSamples);
        for (const EffectWork work :
             {EffectWork::Sample, EffectWork::DepthWrite, EffectWork::Division,
              EffectWork::TexelFetch, EffectWork::Normal, EffectWork::Blend})
            QCOMPARE(tally[work], slopeSamples);
    }

    void onlyPixelsOnAnEdgeHaveSeveralSamples()
    {
        Primitives primitives = everything();
        primitives.appearance.antialiasing = Antialiasing::Samples4;
        // Edge pixels: 17 on the lower edge, 16 more on the left one, and along the diagonal those
        // with x + y = 15, 16 or 17 that are not among them: 14 + 15 + 16. Inner pixels have x, y
        // >= 1 and x + y <= 14: 91, with one sample each.
        std::int64_t covered = 0; // samples of edge pixels
        const Triangle triangle = primitives.triangles[0];
        for (std::int64_t y = -1; y <= 18; ++y) {
            for (std::int64_t x = -1; x <= 18; ++x) {
                const bool isInside = x >= 1 && y >= 1 && x + y <= 14;
                for (const LatticePoint &at : oracle::sampleOffsets(Antialiasing::Samples4)) {
                    const Lattice sx = x * unitsPerPixel + at.x;
                    const Lattice sy = y * unitsPerPixel + at.y;
                    if (!isInside && sx >= 0 && sy >= 0
                        && sx + sy <= triangle.vertices[1].position.x)
                        ++covered;
                }
            }
        }
        QCOMPARE(tallyOf(ShadedMethod::Plane, primitives)[EffectWork::Sample], 91 + covered);
    }
};

PIXELPLUMB_TEST(TestEffectWork)

} // namespace tst_effectwork

#include "tst_effectwork.moc"
