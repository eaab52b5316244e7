// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/labfields.h"
#include "core/lab/study/labfile.h"
#include "core/scene/fields/fieldwriter.h"

namespace pixelplumb {

QByteArray writeStudy(const Study &study)
{
    QJsonObject object = jsonOf(study).toObject();
    object.insert(QStringLiteral("pixelplumbLab"), labFileVersion);
    object.insert(QStringLiteral("warnings"), QJsonArray::fromStringList(warningsOf(study)));
    return QJsonDocument(object).toJson();
}

QByteArray writeAccuracy(const Study &study)
{
    QJsonArray rows;
    for (const LabRow &row : study.rows)
        rows.append(jsonOf(row.withoutTimes()));
    return QJsonDocument(rows).toJson();
}

} // namespace pixelplumb
