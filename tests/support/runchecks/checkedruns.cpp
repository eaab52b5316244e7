// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/runchecks/checkedruns.h"

#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/scenerun.h"
#include "core/scan/choicenames.h"
#include "tests/support/casestorun.h"
#include "tests/support/runchecks/randomscenes.h"
#include "tests/support/runchecks/runscenes.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/hardcasescenes.h"
#include "tests/support/spread.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr int randomCount = 8;
constexpr QLatin1String sceneOfAllKinds("mixed");

/// How many set-ups, spans and samples of a run are explained, each.
std::size_t mostOfAKind() { return areAllCasesRun() ? 30 : 8; }

std::vector<std::size_t> stepsToExplain(const ScanTrace &trace)
{
    std::vector<std::size_t> steps;
    for (const std::size_t i : spreadOver(trace.primitiveCount(), mostOfAKind()))
        steps.push_back(trace.indexOfSetUp(i));
    for (const std::size_t i : spreadOver(trace.spanCount(), mostOfAKind()))
        steps.push_back(trace.indexOfSpan(i));
    for (const std::size_t i : spreadOver(trace.sampleCount(), mostOfAKind()))
        steps.push_back(trace.indexOfSample(i));
    std::ranges::sort(steps);
    return steps;
}

/// Cycles through a method's fill rules and roundings from run to run, so that each rule meets
/// every arithmetic although a scene is drawn in all arithmetics in a row.
class Turns {
public:
    explicit Turns(const Method &method)
        : m_rules(method.fillRules)
    {
    }

    Scene given(Scene scene) const
    {
        const std::size_t round = m_turn / m_rules.size();
        scene.settings.fillRule = m_rules[(m_turn + round) % m_rules.size()];
        scene.settings.rounding = allByteRoundings[round % 2];
        return scene;
    }
    void next() { ++m_turn; }

private:
    const std::vector<FillRule> &m_rules;
    std::size_t m_turn = 0;
};

/// Each variant alone, and each together with those before it.
std::vector<VariantSet> variantSetsOf(const Method &method)
{
    std::vector<VariantSet> sets;
    VariantSet together;
    for (const Variant variant : method.variants) {
        together = together.with(variant);
        sets.push_back(VariantSet().with(variant));
        if (!(sets.back() == together))
            sets.push_back(together);
    }
    return sets;
}

std::size_t placeOf(const Method &method) { return std::size_t(&method - methods().data()); }

} // namespace

CheckedRun checkedRunOf(const QString &name, RunOrigin origin, const Scene &scene)
{
    QString text = u"%1, %2 %3 %4 %5"_s.arg(
        name, QString::fromStdString(scene.method), nameText(nameOf(scene.settings.arithmetic)),
        nameText(nameOf(scene.settings.fillRule)), nameText(nameOf(scene.settings.rounding)));
    for (const Variant variant : variantsIn(scene.settings.variants))
        text += u' ' + nameText(nameOf(variant));
    CheckedRun run{text, origin, traceScene(scene), {}};
    for (const std::size_t index : stepsToExplain(*run.traced->trace))
        run.steps.push_back(
            {run.traced->trace->stepAt(index), index, explainStep(*run.traced, index)});
    return run;
}

CheckedRuns::CheckedRuns()
    : m_scenes(scenesForEveryMethod())
    , m_cases(isSanitized ? std::vector<NamedScene>() : hardCaseDetails())
{
    m_scenes.push_back({u"cut by its frame"_s, sceneCutByItsFrame()});
    m_scenes.push_back({u"carrying numbers"_s, sceneThatCarriesNumbers()});
    for (const auto &more : {randomScenes(randomCount), scenesWithEffects()})
        m_scenes.insert(m_scenes.end(), more.begin(), more.end());
    if (isSanitized) {
        const auto isLeftOut = [place = 0](const NamedScene &each) mutable {
            return place++ % 8 != 0 && each.first != sceneOfAllKinds;
        };
        std::erase_if(m_scenes, isLeftOut);
    }
}

void CheckedRuns::forEachOf(const Method &method,
                            const std::function<void(const CheckedRun &)> &look) const
{
    Turns turns(method);
    const auto lookAt
        = [&](RunOrigin origin, const QString &name, Scene scene, Arithmetic arithmetic) {
              scene.method = method.id.toStdString();
              scene.settings.arithmetic = arithmetic;
              scene = turns.given(scene);
              if (!objectionTo(scene).isEmpty())
                  return;
              turns.next();
              look(checkedRunOf(name, origin, scene));
          };
    const std::vector<Arithmetic> &arithmetics = method.arithmetics;
    for (const auto &[name, whole] : m_scenes) {
        Scene scene = whole;
        scene.method = method.id.toStdString();
        if (!drawsAnyOf(scene) && name != sceneOfAllKinds)
            continue;
        for (const Arithmetic arithmetic : arithmetics)
            lookAt(RunOrigin::Scene, name, scene, arithmetic);
    }
    for (const VariantSet variants : variantSetsOf(method)) {
        Scene scene = departingScene(method);
        scene.settings.variants = variants;
        for (const Arithmetic arithmetic : arithmetics)
            lookAt(RunOrigin::Variant, u"departing"_s, scene, arithmetic);
        Scene cut = sceneCutByItsFrame();
        cut.method = method.id.toStdString();
        cut.settings.variants = variants;
        cut.settings.arithmetic = arithmetics.front();
        for (const FillRule rule : method.fillRules) {
            cut.settings.fillRule = rule;
            look(checkedRunOf(u"cut by its frame"_s, RunOrigin::Variant, cut));
        }
    }
    for (std::size_t i = 0; i < m_cases.size(); ++i) {
        Scene scene = m_cases[i].second;
        scene.method = method.id.toStdString();
        if (!drawsAnyOf(scene))
            continue;
        const std::size_t turn = (i + placeOf(method)) % arithmetics.size();
        for (std::size_t k = 0; k < arithmetics.size(); ++k) {
            if (k == turn || areAllCasesRun())
                lookAt(RunOrigin::HardCase, m_cases[i].first, scene, arithmetics[k]);
        }
    }
}

} // namespace pixelplumb
