// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace pixelplumb::bench {

namespace {

QJsonObject jsonOf(const Spread &spread)
{
    return {{QStringLiteral("firstQuartile"), spread.lower},
            {QStringLiteral("median"), spread.median},
            {QStringLiteral("thirdQuartile"), spread.upper}};
}

QJsonObject jsonOf(const PictureDifference &picture)
{
    return {{QStringLiteral("nearestRule"), QString::fromUtf8(picture.rule.name)},
            {QStringLiteral("coverage"), picture.coverage},
            {QStringLiteral("colour"), picture.colour},
            {QStringLiteral("bytes"), picture.bytes}};
}

QJsonObject jsonOf(const ReportRow &row, const ReportRow *reference, const ReportRow *memset)
{
    const Result &result = row.result;
    const ContenderInfo &info = result.contender->info();
    QJsonArray samples;
    for (const double sample : result.nanosecondsPerTriangle)
        samples.append(sample);
    QJsonObject object = {
        {QStringLiteral("contender"), info.id},
        {QStringLiteral("name"), info.name},
        {QStringLiteral("shading"),
         info.shading == Shading::Smooth ? QStringLiteral("smooth") : QStringLiteral("flat")},
        {QStringLiteral("threads"), info.threads},
        {QStringLiteral("trianglesDrawn"), qint64(result.triangles)},
        {QStringLiteral("drawsPerSample"), result.drawsPerSample},
        {QStringLiteral("processorsUsed"), spreadOf(result.processorsUsed).median},
        {QStringLiteral("disturbedSamples"), result.disturbedSamples},
        {QStringLiteral("nanosecondsPerTriangle"), jsonOf(result.time())},
        {QStringLiteral("samples"), samples},
    };
    if (reference != nullptr)
        object[QStringLiteral("timesOurs")] = jsonOf(ratio(result, reference->result));
    if (memset != nullptr)
        object[QStringLiteral("timesMemset")] = jsonOf(ratio(result, memset->result));
    if (row.picture)
        object[QStringLiteral("picture")] = jsonOf(*row.picture);
    if (row.differsFromPlain)
        object[QStringLiteral("differsFromPlain")] = *row.differsFromPlain;
    return object;
}

} // namespace

QByteArray json(const Report &report)
{
    QJsonArray workloads;
    for (const WorkloadReport &workload : report.workloads) {
        QJsonArray rows;
        for (const ReportRow &row : workload.rows) {
            rows.append(jsonOf(row, workload.row(report.referenceId),
                               workload.row(QStringLiteral("memset"))));
        }
        workloads.append(
            QJsonObject{{QStringLiteral("id"), workload.id},
                        {QStringLiteral("title"), workload.title},
                        {QStringLiteral("width"), workload.size.width},
                        {QStringLiteral("height"), workload.size.height},
                        {QStringLiteral("triangles"), qint64(workload.triangles)},
                        {QStringLiteral("pixelsPerTriangle"), workload.pixelsPerTriangle},
                        {QStringLiteral("results"), rows}});
    }
    QJsonArray absent;
    for (const Absence &absence : report.absent) {
        absent.append(QJsonObject{{QStringLiteral("name"), absence.name},
                                  {QStringLiteral("reason"), absence.reason}});
    }
    const QJsonObject root = {
        {QStringLiteral("pixelplumbBenchmark"), 1},
        {QStringLiteral("machine"), json(report.machine)},
        {QStringLiteral("loadAfter"), report.loadAtEnd},
        {QStringLiteral("rounds"), report.rounds},
        {QStringLiteral("quick"), report.extent == Extent::Quick},
        {QStringLiteral("reference"), report.referenceId},
        {QStringLiteral("absent"), absent},
        {QStringLiteral("brokenPromises"), QJsonArray::fromStringList(report.brokenPromises())},
        {QStringLiteral("workloads"), workloads},
    };
    return QJsonDocument(root).toJson();
}

} // namespace pixelplumb::bench
