// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/oracle/effectoracle.h"
#include "core/shade/shadeddrawing.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/effectscenes.h"
#include "tests/support/scenes/planbyhand.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_effectkernels {

using namespace pixelplumb;

namespace {

constexpr std::array shadedMethods = {ShadedMethod::ColumnScan, ShadedMethod::Bilinear,
                                      ShadedMethod::Plane, ShadedMethod::Barycentric};
/// The rules that some of the methods support.
constexpr std::array keptRules
    = {FillRule::Closed, FillRule::HalfOpenColumn, FillRule::TopLeft, FillRule::Open};

std::vector<ShadedMethod> methodsThatKeep(FillRule rule)
{
    std::vector<ShadedMethod> methods(shadedMethods.begin(), shadedMethods.end());
    if (rule == FillRule::TopLeft)
        std::erase(methods, ShadedMethod::ColumnScan);
    return methods;
}

QString nameOf(ShadedMethod method)
{
    switch (method) {
    case ShadedMethod::ColumnScan:
        return u"column-scan"_s;
    case ShadedMethod::Bilinear:
        return u"interpolate-bilinear"_s;
    case ShadedMethod::Plane:
        return u"interpolate-plane"_s;
    case ShadedMethod::Barycentric:
        return u"interpolate-barycentric"_s;
    }
    return {};
}

/// A picture, and the pixels that the truth cannot decide.
struct Truth {
    FrameBuffer frame;
    std::vector<oracle::PixelPlace> undecided;
};

Truth truthOf(const EffectScene &scene, const ScanSettings &settings)
{
    Truth truth{FrameBuffer(scene.frame), {}};
    truth.undecided
        = oracle::drawEffects(scene.primitives, settings,
                              oracle::truthOf(scene.primitives.appearance), truth.frame.view());
    return truth;
}

FrameBuffer drawnBy(ShadedMethod method, const EffectScene &scene, const ScanSettings &settings)
{
    FrameBuffer frame(scene.frame);
    drawShaded(method, scene.primitives, settings, frame.view(), planByHand(scene.primitives));
    return frame;
}

/// How one picture differs from another.
struct Departure {
    int pixels = 0; ///< differing pixels
    int beyondOne = 0; ///< those that differ by more than one level of a channel
    QString first; ///< "(x, y): 1 2 3 instead of 4 5 6"
};

Departure departureOf(const FrameBuffer &drawn, const FrameBuffer &truth,
                      const std::vector<oracle::PixelPlace> &undecided = {})
{
    Departure departure;
    const FrameView view = truth.view();
    const auto text = [](const Colour &colour) {
        return u"%1 %2 %3"_s.arg(colour.red()).arg(colour.green()).arg(colour.blue());
    };
    for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
        for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x) {
            const Colour is = unpacked(*drawn.view().at(x, y));
            const Colour should = unpacked(*view.at(x, y));
            if (is == should || std::ranges::count(undecided, oracle::PixelPlace{x, y}) > 0)
                continue;
            if (departure.pixels++ == 0)
                departure.first
                    = u"(%1, %2): %3 instead of %4"_s.arg(x).arg(y).arg(text(is), text(should));
            int levels = 0;
            for (std::size_t channel = 0; channel < 3; ++channel)
                levels
                    = std::max(levels, std::abs(is.channels[channel] - should.channels[channel]));
            departure.beyondOne += levels > 1 ? 1 : 0;
        }
    }
    return departure;
}

constexpr std::uint64_t seedCount = isSanitized ? 1 : 12;

/// Calls function(scene, settings, text) for random scenes with a hardship, under each rule.
template <class Function>
void forEachScene(EffectHardship hardship, const std::vector<Arithmetic> &arithmetics,
                  const Function &function)
{
    for (std::uint64_t seed = 0; seed < seedCount; ++seed) {
        const EffectScene scene = randomEffectScene(seed, hardship);
        for (const Arithmetic arithmetic : arithmetics) {
            for (const FillRule rule : keptRules) {
                const ByteRounding rounding
                    = seed % 4 == 0 ? ByteRounding::Truncate : ByteRounding::Nearest;
                function(scene, ScanSettings{arithmetic, rule, rounding},
                         u"seed %1, %2, "_s.arg(seed).arg(scene.name));
            }
        }
    }
}

QString textOf(ShadedMethod method, const Departure &departure)
{
    return u"%1: %2 pixels, %3"_s.arg(nameOf(method)).arg(departure.pixels).arg(departure.first);
}

void addHardshipRows()
{
    QTest::addColumn<EffectHardship>("hardship");
    for (const EffectHardship hardship : allEffectHardships)
        QTest::newRow(qPrintable(nameOf(hardship))) << hardship;
}

/// A plan with every effect on that changes no pixel where it is not needed.
EffectPlan withNeutralEffects(EffectPlan plan)
{
    for (EffectBatch &batch : plan.batches) {
        batch.effects.smooth = true;
        batch.effects.perspective = true;
        batch.effects.blending = true;
    }
    return plan;
}

} // namespace

/// The effect kernels against the truth, with which they share no code, on random scenes.
class TestEffectKernels : public QObject {
    Q_OBJECT

private slots:
    void inExactArithmeticEveryMethodDrawsTheTruth_data() { addHardshipRows(); }
    void inExactArithmeticEveryMethodDrawsTheTruth()
    {
        QFETCH(EffectHardship, hardship);
        forEachScene(
            hardship, {Arithmetic::Exact},
            [](const EffectScene &scene, const ScanSettings &settings, const QString &text) {
                const Truth truth = truthOf(scene, settings);
                for (const ShadedMethod method : methodsThatKeep(settings.fillRule)) {
                    const Departure departure = departureOf(drawnBy(method, scene, settings),
                                                            truth.frame, truth.undecided);
                    QVERIFY2(departure.pixels == 0, qPrintable(text + textOf(method, departure)));
                }
            });
    }

    void whatThePlanLeavesOutChangesNoPixel_data() { addHardshipRows(); }
    void whatThePlanLeavesOutChangesNoPixel()
    {
        QFETCH(EffectHardship, hardship);
        forEachScene(
            hardship, {Arithmetic::Exact},
            [](EffectScene scene, const ScanSettings &settings, const QString &text) {
                scene.primitives.appearance.depth = DepthUse::Auto;
                const Truth truth = truthOf(scene, settings);
                FrameBuffer frame(scene.frame);
                const EffectPlan plan = planFor(scene.primitives, settings, frame.view());
                drawShaded(ShadedMethod::Plane, scene.primitives, settings, frame.view(), plan);
                const Departure departure = departureOf(frame, truth.frame, truth.undecided);
                QVERIFY2(departure.pixels == 0,
                         qPrintable(text + textOf(ShadedMethod::Plane, departure)));
            });
    }

    void columnsLongerThanARunOfSamplesAreDrawnTrue()
    {
        EffectScene scene;
        scene.frame = frameOf(20, 300);
        Triangle triangle;
        triangle.vertices = {{{latticePixel(1, 2), {{255, 0, 0}}},
                              {latticePixel(18, 40), {{0, 255, 0}}},
                              {latticePixel(3, 297), {{0, 0, 255}}}}};
        TriangleAttributes attributes;
        attributes.vertices[0].w = 3 * attributeOne;
        attributes.vertices[1].alpha = 17;
        attributes.vertices[2].z = attributeOne / 3;
        scene.primitives.triangles = {triangle};
        scene.primitives.attributes = {attributes};
        scene.primitives.appearance.depth = DepthUse::On;
        const Truth truth = truthOf(scene, {});
        for (const ShadedMethod method : shadedMethods) {
            const Departure departure
                = departureOf(drawnBy(method, scene, {}), truth.frame, truth.undecided);
            QVERIFY2(departure.pixels == 0, qPrintable(textOf(method, departure)));
        }
    }

    void neutralEffectsChangeNoPixelInExactArithmetic_data() { addHardshipRows(); }
    void neutralEffectsChangeNoPixelInExactArithmetic()
    {
        QFETCH(EffectHardship, hardship);
        forEachScene(
            hardship, {Arithmetic::Exact},
            [](const EffectScene &scene, const ScanSettings &settings, const QString &text) {
                for (const ShadedMethod method : methodsThatKeep(settings.fillRule)) {
                    FrameBuffer frame(scene.frame);
                    drawShaded(method, scene.primitives, settings, frame.view(),
                               withNeutralEffects(planByHand(scene.primitives)));
                    const Departure departure
                        = departureOf(frame, drawnBy(method, scene, settings));
                    QVERIFY2(departure.pixels == 0, qPrintable(text + textOf(method, departure)));
                }
            });
    }

    // How far float32 is from the truth. Where a sample decides by depth or by a texel's border,
    // another surface or texel may show; where depths differ in a last bit that float32 does not
    // have, and far from the origin, it is seldom right; a column scan's rounded bounds miss
    // samples of segments.
    void inFloat32MostPixelsAreRight_data()
    {
        QTest::addColumn<EffectHardship>("hardship");
        QTest::addColumn<int>("perMille"); // most pixels that may be off by more than one level
        for (const EffectHardship hardship : allEffectHardships) {
            const int bound = hardship == EffectHardship::FarAway ? 300
                : hardship == EffectHardship::Coincident          ? 150
                : hardship == EffectHardship::Segments            ? 100
                                                                  : 5;
            // The share over few scenes varies more than over many.
            QTest::newRow(qPrintable(nameOf(hardship)))
                << hardship << bound * (isSanitized ? 3 : 1);
        }
    }
    void inFloat32MostPixelsAreRight()
    {
        QFETCH(EffectHardship, hardship);
        QFETCH(int, perMille);
        std::array<int, shadedMethods.size()> others = {};
        std::array<int, shadedMethods.size()> beyondOne = {};
        int pixels = 0;
        forEachScene(hardship, {Arithmetic::Float32},
                     [&](const EffectScene &scene, const ScanSettings &settings, const QString &) {
                         const Truth truth = truthOf(scene, settings);
                         pixels += scene.frame.width * scene.frame.height;
                         for (std::size_t i = 0; i < shadedMethods.size(); ++i) {
                             const auto kept = methodsThatKeep(settings.fillRule);
                             if (std::ranges::find(kept, shadedMethods[i]) == kept.end())
                                 continue;
                             const Departure departure
                                 = departureOf(drawnBy(shadedMethods[i], scene, settings),
                                               truth.frame, truth.undecided);
                             others[i] += departure.pixels;
                             beyondOne[i] += departure.beyondOne;
                         }
                     });
        for (std::size_t i = 0; i < shadedMethods.size(); ++i) {
            qInfo().noquote() << u"%1: of %2 pixels %3 differ, %4 by more than a level"_s
                                     .arg(nameOf(shadedMethods[i]))
                                     .arg(pixels)
                                     .arg(others[i])
                                     .arg(beyondOne[i]);
            QVERIFY(1000 * beyondOne[i] <= perMille * pixels);
        }
    }
};

PIXELPLUMB_TEST(TestEffectKernels)

} // namespace tst_effectkernels

#include "tst_effectkernels.moc"
