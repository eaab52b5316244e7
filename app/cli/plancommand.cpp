// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "core/measure/effecttiming.h"
#include "core/runs/scenerun.h"
#include "core/scan/choicenames.h"
#include "core/shade/effectplan.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QStringList>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

struct PlanReport {
    EffectPlan plan;
    EffectForcing forced;
    std::optional<EffectTiming> timing; ///< where it was measured
    QString refusal = {}; ///< why no method draws the scene; then nothing runs
};

/// What runs of an effect, where that differs from its verdict.
QString runText(const PlanReport &report, Effect effect)
{
    if (!report.refusal.isEmpty())
        return u"refused"_s;
    const EffectPlan &plan = report.plan;
    const EffectForcing &forced = report.forced;
    QString runs = plan.runs(effect) ? u"yes"_s : u"no"_s;
    if (forced[effect] == Forcing::AsCalledFor)
        return runs;
    const bool isInVain = forced[effect] == Forcing::On && !plan.runs(effect);
    return runs + (isInVain ? u" (nothing to force)"_s : u" (forced)"_s);
}

/// Aligns all columns left except those of numbers.
QStringList aligned(const std::vector<QStringList> &rows, const QList<qsizetype> &numbers)
{
    return alignedRows(rows, [&numbers](qsizetype column) { return !numbers.contains(column); });
}

/// The triangles of a batch, first to last: "4", "0 … 3, 1 of them not drawn".
QString triangleRange(const EffectBatch &batch)
{
    QString range = batch.count == 1
        ? QString::number(batch.first)
        : u"%1 … %2"_s.arg(batch.first).arg(batch.first + batch.count - 1);
    if (batch.unseen == batch.count)
        range += u", not drawn"_s;
    else if (batch.unseen != 0)
        range += u", %1 of them not drawn"_s.arg(batch.unseen);
    return range;
}

/// The antialiasing of triangles, lines or curves; the same where several use it.
Antialiasing antialiasingOf(const EffectPlan &plan)
{
    return std::max(plan.antialiasing, plan.strokeAntialiasing);
}

QString samplesText(const EffectPlan &plan)
{
    const QString pixels = plan.antialiasing == Antialiasing::None
        ? u"in pixels that the border of a line or curve passes"_s
        : u"in pixels that an edge passes"_s;
    switch (antialiasingOf(plan)) {
    case Antialiasing::None:
        return u"one sample a pixel"_s;
    case Antialiasing::Samples4:
        return u"4 samples "_s + pixels;
    case Antialiasing::Samples16:
        return u"16 samples "_s + pixels;
    case Antialiasing::Area:
        return u"exact areas"_s;
    }
    return {};
}

/// The first batches, up to a limit; nothing where there are none.
QStringList batchesText(const std::vector<EffectBatch> &batches)
{
    if (batches.empty())
        return {};
    constexpr std::size_t mostBatches = 20;
    std::vector<QStringList> rows = {{u"triangles"_s, u"what runs"_s}};
    for (std::size_t i = 0; i < std::min(batches.size(), mostBatches); ++i)
        rows.push_back({triangleRange(batches[i]), namesOf(batches[i].effects)});
    QStringList lines = aligned(rows, {});
    if (batches.size() > mostBatches)
        lines.append(u"and %1 more batches"_s.arg(batches.size() - mostBatches));
    return lines;
}

/// What each active effect costs and changes.
QStringList textOf(const EffectTiming &timing)
{
    std::vector<QStringList> rows
        = {{u"effect"_s, u"ns a pixel"_s, u"operations a pixel"_s, u"changed pixels"_s,
            u"on / off, median (half of the rounds)"_s}};
    for (const Effect effect : allEffects) {
        const std::optional<EffectCost> &cost = timing.costs[effect];
        if (!cost)
            continue;
        const std::optional<double> operations = timing.operationsPerPixel(*cost);
        rows.push_back({nameText(nameOf(effect)), QString::number(timing.perPixel(*cost), 'f', 2),
                        operations ? QString::number(*operations, 'f', 2) : u"-"_s,
                        QString::number(cost->changed),
                        u"%1 (%2 … %3)"_s.arg(cost->ratio.median, 0, 'f', 2)
                            .arg(cost->ratio.lower, 0, 'f', 2)
                            .arg(cost->ratio.upper, 0, 'f', 2)});
    }
    return QStringList{QString()} + aligned(rows, {1, 2, 3})
        + QStringList{
            u"Each effect on against off, the others as called for, by the plain kernels: %1 "
            "rounds in turn. An effect that is not listed draws the same either way, or the method "
            "cannot do it."_s.arg(timing.rounds)};
}

QJsonObject jsonOf(const EffectTiming &timing, const EffectCost &cost)
{
    QJsonObject object{{u"nanosecondsPerPixel"_s, timing.perPixel(cost)},
                       {u"changedPixels"_s, qint64(cost.changed)},
                       {u"rounds"_s, timing.rounds},
                       {u"ratio"_s,
                        QJsonObject{{u"lower"_s, cost.ratio.lower},
                                    {u"median"_s, cost.ratio.median},
                                    {u"upper"_s, cost.ratio.upper}}}};
    if (const auto operations = timing.operationsPerPixel(cost))
        object.insert(u"operationsPerPixel"_s, *operations);
    return object;
}

/// The effects with their verdicts and reasons, in aligned columns, then the batches, then what was
/// measured.
QStringList textOf(const PlanReport &report)
{
    const EffectPlan &plan = report.plan;
    std::vector<QStringList> rows = {
        {u"effect"_s, u"verdict"_s, u"runs"_s, u"primitives"_s, u"pixels at most"_s, u"reason"_s}};
    for (const Effect effect : allEffects) {
        const EffectVerdict &verdict = plan.verdicts[effect];
        rows.push_back({nameText(nameOf(effect)), nameText(nameOf(verdict.verdict)),
                        runText(report, effect), QString::number(verdict.primitives),
                        QString::number(verdict.pixels), verdict.reason});
    }
    QStringList lines = aligned(rows, {3, 4});
    if (!report.refusal.isEmpty())
        return lines;
    lines.append(QString());
    lines.append(samplesText(plan));
    if (plan.vertexLight)
        lines.append(u"light in set-up, into the vertices' colours, before what follows"_s);
    lines.append(batchesText(plan.batches));
    if (report.timing)
        lines.append(textOf(*report.timing));
    return lines;
}

QJsonObject jsonOf(const PlanReport &report)
{
    const EffectPlan &plan = report.plan;
    const bool isRefused = !report.refusal.isEmpty();
    QJsonArray effects;
    for (const Effect effect : allEffects) {
        const EffectVerdict &verdict = plan.verdicts[effect];
        QJsonObject object{{u"effect"_s, nameText(nameOf(effect))},
                           {u"verdict"_s, nameText(nameOf(verdict.verdict))},
                           {u"reason"_s, verdict.reason},
                           {u"primitives"_s, qint64(verdict.primitives)},
                           {u"mostPixels"_s, qint64(verdict.pixels)},
                           {u"forced"_s, report.forced[effect] != Forcing::AsCalledFor},
                           {u"runs"_s, !isRefused && plan.runs(effect)}};
        if (report.timing && report.timing->costs[effect])
            object.insert(u"measured"_s, jsonOf(*report.timing, *report.timing->costs[effect]));
        effects.append(object);
    }
    QJsonArray batches;
    for (const EffectBatch &batch : isRefused ? std::vector<EffectBatch>() : plan.batches) {
        QJsonArray names;
        for (const Effect effect : allEffects) {
            if (contains(batch.effects, effect))
                names.append(nameText(nameOf(effect)));
        }
        batches.append(QJsonObject{{u"first"_s, qint64(batch.first)},
                                   {u"count"_s, qint64(batch.count)},
                                   {u"notDrawn"_s, qint64(batch.unseen)},
                                   {u"effects"_s, names}});
    }
    QJsonObject object{{u"effects"_s, effects}, {u"batches"_s, batches}};
    if (isRefused)
        object.insert(u"refused"_s, report.refusal);
    else
        object.insert(u"antialiasing"_s, samplesText(plan));
    return object;
}

} // namespace

ExitCode plan(const Command &command, const QStringList &arguments)
{
    const QString measureOption = u"measure"_s;
    CommandLine line(command, {scenePositional()});
    line.addOption({measureOption,
                    u"Measure, too, what each effect costs: it is drawn on and off in turn."_s});
    line.addJsonOption();
    addSettingOptions(line);
    line.parse(arguments);
    const SceneRun run = runWithProgress(readSceneForAnyMethod(line, line.argument(0)));
    const auto refusal = refusalOf(run, line.argument(0));
    PlanReport report{planOf(run), run.scene.appearance.forced, std::nullopt,
                      refusal ? refusal->message() : QString()};
    if (line.isSet(measureOption) && !refusal)
        report.timing = withProgress([&run](const ProgressListener &listener) {
            TimingOptions options;
            options.progress = listener;
            return timeEffects(run.scene, options);
        });
    line.asksForJson() ? printJson(jsonOf(report)) : printLines(textOf(report));
    if (refusal)
        sayLine(refusal->message());
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
