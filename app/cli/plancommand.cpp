// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/options.h"
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
        return QStringLiteral("refused");
    const EffectPlan &plan = report.plan;
    const EffectForcing &forced = report.forced;
    QString runs = plan.runs(effect) ? QStringLiteral("yes") : QStringLiteral("no");
    if (forced[effect] == Forcing::AsCalledFor)
        return runs;
    const bool isInVain = forced[effect] == Forcing::On && !plan.runs(effect);
    return runs + (isInVain ? QStringLiteral(" (nothing to force)") : QStringLiteral(" (forced)"));
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
        : QStringLiteral("%1 … %2").arg(batch.first).arg(batch.first + batch.count - 1);
    if (batch.unseen == batch.count)
        range += QStringLiteral(", not drawn");
    else if (batch.unseen != 0)
        range += QStringLiteral(", %1 of them not drawn").arg(batch.unseen);
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
        ? QStringLiteral("in pixels that the border of a line or curve passes")
        : QStringLiteral("in pixels that an edge passes");
    switch (antialiasingOf(plan)) {
    case Antialiasing::None:
        return QStringLiteral("one sample a pixel");
    case Antialiasing::Samples4:
        return QStringLiteral("4 samples ") + pixels;
    case Antialiasing::Samples16:
        return QStringLiteral("16 samples ") + pixels;
    case Antialiasing::Area:
        return QStringLiteral("exact areas");
    }
    return {};
}

/// The first batches, up to a limit; nothing where there are none.
QStringList batchesText(const std::vector<EffectBatch> &batches)
{
    if (batches.empty())
        return {};
    constexpr std::size_t mostBatches = 20;
    std::vector<QStringList> rows = {{QStringLiteral("triangles"), QStringLiteral("what runs")}};
    for (std::size_t i = 0; i < std::min(batches.size(), mostBatches); ++i)
        rows.push_back({triangleRange(batches[i]), namesOf(batches[i].effects)});
    QStringList lines = aligned(rows, {});
    if (batches.size() > mostBatches)
        lines.append(QStringLiteral("and %1 more batches").arg(batches.size() - mostBatches));
    return lines;
}

/// What each active effect costs and changes.
QStringList textOf(const EffectTiming &timing)
{
    std::vector<QStringList> rows
        = {{QStringLiteral("effect"), QStringLiteral("ns a pixel"),
            QStringLiteral("operations a pixel"), QStringLiteral("changed pixels"),
            QStringLiteral("on / off, median (half of the rounds)")}};
    for (const Effect effect : allEffects) {
        const std::optional<EffectCost> &cost = timing.costs[effect];
        if (!cost)
            continue;
        const std::optional<double> operations = timing.operationsPerPixel(*cost);
        rows.push_back({nameText(nameOf(effect)), QString::number(timing.perPixel(*cost), 'f', 2),
                        operations ? QString::number(*operations, 'f', 2) : QStringLiteral("-"),
                        QString::number(cost->changed),
                        QStringLiteral("%1 (%2 … %3)")
                            .arg(cost->ratio.median, 0, 'f', 2)
                            .arg(cost->ratio.lower, 0, 'f', 2)
                            .arg(cost->ratio.upper, 0, 'f', 2)});
    }
    return QStringList{QString()} + aligned(rows, {1, 2, 3})
        + QStringList{
            QStringLiteral("Each effect on against off, the others as called for, by the "
                           "plain kernels: %1 rounds in turn. An effect that is not "
                           "listed draws the same either way, or the method cannot do it.")
                .arg(timing.rounds)};
}

QJsonObject jsonOf(const EffectTiming &timing, const EffectCost &cost)
{
    QJsonObject object{{QStringLiteral("nanosecondsPerPixel"), timing.perPixel(cost)},
                       {QStringLiteral("changedPixels"), qint64(cost.changed)},
                       {QStringLiteral("rounds"), timing.rounds},
                       {QStringLiteral("ratio"),
                        QJsonObject{{QStringLiteral("lower"), cost.ratio.lower},
                                    {QStringLiteral("median"), cost.ratio.median},
                                    {QStringLiteral("upper"), cost.ratio.upper}}}};
    if (const auto operations = timing.operationsPerPixel(cost))
        object.insert(QStringLiteral("operationsPerPixel"), *operations);
    return object;
}

/// The effects with their verdicts and reasons, in aligned columns, then the batches, then what was
/// measured.
QStringList textOf(const PlanReport &report)
{
    const EffectPlan &plan = report.plan;
    std::vector<QStringList> rows = {{QStringLiteral("effect"), QStringLiteral("verdict"),
                                      QStringLiteral("runs"), QStringLiteral("primitives"),
                                      QStringLiteral("pixels at most"), QStringLiteral("reason")}};
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
        lines.append(
            QStringLiteral("light in set-up, into the vertices' colours, before what follows"));
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
        QJsonObject object{
            {QStringLiteral("effect"), nameText(nameOf(effect))},
            {QStringLiteral("verdict"), nameText(nameOf(verdict.verdict))},
            {QStringLiteral("reason"), verdict.reason},
            {QStringLiteral("primitives"), qint64(verdict.primitives)},
            {QStringLiteral("mostPixels"), qint64(verdict.pixels)},
            {QStringLiteral("forced"), report.forced[effect] != Forcing::AsCalledFor},
            {QStringLiteral("runs"), !isRefused && plan.runs(effect)}};
        if (report.timing && report.timing->costs[effect])
            object.insert(QStringLiteral("measured"),
                          jsonOf(*report.timing, *report.timing->costs[effect]));
        effects.append(object);
    }
    QJsonArray batches;
    for (const EffectBatch &batch : isRefused ? std::vector<EffectBatch>() : plan.batches) {
        QJsonArray names;
        for (const Effect effect : allEffects) {
            if (contains(batch.effects, effect))
                names.append(nameText(nameOf(effect)));
        }
        batches.append(QJsonObject{{QStringLiteral("first"), qint64(batch.first)},
                                   {QStringLiteral("count"), qint64(batch.count)},
                                   {QStringLiteral("notDrawn"), qint64(batch.unseen)},
                                   {QStringLiteral("effects"), names}});
    }
    QJsonObject object{{QStringLiteral("effects"), effects}, {QStringLiteral("batches"), batches}};
    if (isRefused)
        object.insert(QStringLiteral("refused"), report.refusal);
    else
        object.insert(QStringLiteral("antialiasing"), samplesText(plan));
    return object;
}

} // namespace

ExitCode plan(const Command &command, const QStringList &arguments)
{
    const QString measureOption = QStringLiteral("measure");
    CommandLine line(command, {scenePositional()});
    line.addOption({measureOption,
                    QStringLiteral("Measure, too, what each effect costs: it is drawn on and off "
                                   "in turn.")});
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
