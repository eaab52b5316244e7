// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/planreport.h"

#include "core/scan/choicenames.h"

#include <QJsonArray>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

/// What is run of an effect, where it is not what the verdict says.
QString runText(const EffectPlan &plan, const EffectForcing &forced, Effect effect)
{
    const QString runs = plan.runs(effect) ? QStringLiteral("yes") : QStringLiteral("no");
    return forced[effect] == Forcing::AsCalledFor ? runs : runs + QStringLiteral(" (forced)");
}

/// The rows of a table with its columns aligned: all to the left but numbers; the last one open.
QStringList aligned(const std::vector<QStringList> &rows, const QList<qsizetype> &numbers)
{
    QList<qsizetype> widths(rows.front().size(), 0);
    for (const QStringList &row : rows) {
        for (qsizetype column = 0; column + 1 < row.size(); ++column)
            widths[column] = std::max(widths[column], row[column].size());
    }
    QStringList lines;
    for (const QStringList &row : rows) {
        QStringList cells;
        for (qsizetype column = 0; column < row.size(); ++column)
            cells.append(numbers.contains(column) ? row[column].rightJustified(widths[column])
                                                  : row[column].leftJustified(widths[column]));
        lines.append(cells.join(QStringLiteral("  ")).trimmed());
    }
    return lines;
}

/// "4", "0 … 3" of the first and the last triangle.
QString triangleRange(const EffectBatch &batch)
{
    if (batch.count == 1)
        return QString::number(batch.first);
    return QStringLiteral("%1 … %2").arg(batch.first).arg(batch.first + batch.count - 1);
}

QString samplesText(Antialiasing antialiasing)
{
    switch (antialiasing) {
    case Antialiasing::None:
        return QStringLiteral("one sample a pixel");
    case Antialiasing::Samples4:
        return QStringLiteral("4 samples in pixels that an edge passes");
    case Antialiasing::Samples16:
        return QStringLiteral("16 samples in pixels that an edge passes");
    case Antialiasing::Area:
        return QStringLiteral("exact areas");
    }
    return {};
}

} // namespace

QStringList textOf(const EffectPlan &plan, const EffectForcing &forced)
{
    std::vector<QStringList> rows
        = {{QStringLiteral("effect"), QStringLiteral("verdict"), QStringLiteral("runs"),
            QStringLiteral("primitives"), QStringLiteral("pixels ≤"), QStringLiteral("reason")}};
    for (const Effect effect : allEffects) {
        const EffectVerdict &verdict = plan.verdicts[effect];
        rows.push_back({nameText(nameOf(effect)), nameText(nameOf(verdict.verdict)),
                        runText(plan, forced, effect), QString::number(verdict.primitives),
                        QString::number(verdict.pixels), verdict.reason});
    }
    QStringList lines = aligned(rows, {3, 4});
    lines.append(QString());
    lines.append(samplesText(plan.antialiasing));
    constexpr std::size_t mostBatches = 20;
    std::vector<QStringList> batches = {{QStringLiteral("triangles"), QStringLiteral("what runs")}};
    for (std::size_t i = 0; i < std::min(plan.batches.size(), mostBatches); ++i)
        batches.push_back({triangleRange(plan.batches[i]), namesOf(plan.batches[i].effects)});
    lines.append(aligned(batches, {}));
    if (plan.batches.size() > mostBatches)
        lines.append(QStringLiteral("and %1 more batches").arg(plan.batches.size() - mostBatches));
    return lines;
}

QJsonObject jsonOf(const EffectPlan &plan, const EffectForcing &forced)
{
    QJsonArray effects;
    for (const Effect effect : allEffects) {
        const EffectVerdict &verdict = plan.verdicts[effect];
        effects.append(
            QJsonObject{{QStringLiteral("effect"), nameText(nameOf(effect))},
                        {QStringLiteral("verdict"), nameText(nameOf(verdict.verdict))},
                        {QStringLiteral("reason"), verdict.reason},
                        {QStringLiteral("primitives"), qint64(verdict.primitives)},
                        {QStringLiteral("mostPixels"), qint64(verdict.pixels)},
                        {QStringLiteral("forced"), forced[effect] != Forcing::AsCalledFor},
                        {QStringLiteral("runs"), plan.runs(effect)}});
    }
    QJsonArray batches;
    for (const EffectBatch &batch : plan.batches) {
        QJsonArray names;
        for (const Effect effect : allEffects) {
            if (contains(batch.effects, effect))
                names.append(nameText(nameOf(effect)));
        }
        batches.append(QJsonObject{{QStringLiteral("first"), qint64(batch.first)},
                                   {QStringLiteral("count"), qint64(batch.count)},
                                   {QStringLiteral("effects"), names}});
    }
    return {{QStringLiteral("effects"), effects},
            {QStringLiteral("antialiasing"), samplesText(plan.antialiasing)},
            {QStringLiteral("batches"), batches}};
}

} // namespace pixelplumb::cli
