// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/costorder.h"

#include "core/frame/writtenframe.h"
#include "core/lab/judging/picturejudge.h"
#include "core/oracle/oracle.h"
#include "core/runs/contender.h"
#include "core/runs/scenerun.h"

namespace pixelplumb {

namespace {

/// ns per pixel in the family random-integer; see the man page.
constexpr CostOrderEntry publishedOrder[] = {
    {"column-scan:exact:fast", 0.1},
    {"column-scan:fixed16.16", 1.2},
    {"column-scan:fixed32.32", 1.3},
    {"row-walk:float32", 3.1},
    {"column-scan:float64", 3.4},
    {"column-scan:float32", 3.4},
    {"column-scan-bias:float64", 3.6},
    {"row-walk:exact", 3.8},
    {"column-scan:exact", 4.1},
    {"barycentric-incremental:float32", 7.0},
    {"edge-equations-incremental:float32", 8.0},
    {"barycentric-incremental:exact", 9.6},
    {"edge-equations-incremental:exact", 11.6},
    {"barycentric-off-screen:exact", 11.7},
    {"barycentric-relative:float32", 12.1},
};

const std::vector<LabContender> &orderedContenders()
{
    static const std::vector<LabContender> contenders = [] {
        std::vector<LabContender> found;
        for (const CostOrderEntry &entry : publishedOrder)
            found.push_back(*labContenderNamed(QString::fromLatin1(entry.contender)));
        return found;
    }();
    return contenders;
}

/// False if the listener, asked after each plain triangle, ended it.
template <class GoesOn>
bool drawTruth(const SceneRun &run, const FrameView &frame, const GoesOn &goesOn)
{
    if (run.shading()) {
        run.drawTruth(frame);
        return goesOn();
    }
    for (const Triangle &triangle : run.primitives.triangles) {
        oracle::draw(triangle, boundaryRuleOf(run.scene), run.settings.rounding, frame);
        if (!goesOn())
            return false;
    }
    return true;
}

} // namespace

std::span<const CostOrderEntry> costOrder() { return publishedOrder; }

std::optional<CostOrderChoice> firstInOrder(Budget budget, const Scene &scene,
                                            const ProgressListener &listener)
{
    const Primitives primitives = primitivesOnSamples(scene);
    std::optional<WrittenFrame> truth;
    std::int64_t done = 0;
    const auto all = std::int64_t(orderedContenders().size());
    for (const LabContender &contender : orderedContenders()) {
        if (!goesOn(listener, {JobPhase::Judging, done++, all}))
            return std::nullopt;
        ScanSettings settings = scene.settings;
        settings.arithmetic = contender.arithmetic;
        SceneRun run(sceneFor(scene, {contender.method, settings}), primitives);
        if (!objectionTo(run).isEmpty())
            continue;
        // The proofs hold only for triangles without effects.
        const bool isPlain = !run.plan || run.plan->isPlain();
        if (contender.isProved() && isPlain) {
            return CostOrderChoice{&contender, BudgetGround::Proof,
                                   u"proved for "_s + contender.domain(), settings};
        }
        if (budget == Budget::Exact && isPlain)
            continue;
        if (!truth) {
            truth.emplace(scene.frame);
            if (!drawTruth(run, truth->view(), [&] {
                    return goesOn(listener, {JobPhase::Judging, done, all});
                }))
                return std::nullopt;
        }
        const WrittenFrame drawn(scene.frame);
        run.draw(drawn.view());
        const AccuracyFigures figures = figuresOfPicture(truth->view(), drawn.view());
        if (!meets(budget, figures))
            continue;
        return CostOrderChoice{
            &contender, BudgetGround::Measurement,
            u"measured on this scene: %1 wrong of %2 pixels, bytes off by %3 at most"_s
                .arg(figures.wrongPixels())
                .arg(figures.pixels)
                .arg(figures.largestByteError),
            settings};
    }
    return CostOrderChoice{nullptr, BudgetGround::Nobody,
                           u"no method of the order keeps the scene's fill rule, "
                           "does what it calls for and meets “%1”"_s.arg(textOf(budget)),
                           scene.settings};
}

} // namespace pixelplumb
