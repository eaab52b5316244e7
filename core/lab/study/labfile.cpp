// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/labfile.h"

#include "core/lab/study/labfields.h"
#include "core/scene/fields/fieldreader.h"
#include "core/scene/fields/fieldwriter.h"

namespace pixelplumb {

QByteArray writeStudy(const Study &study)
{
    QJsonObject object = jsonOf(study).toObject();
    object.insert(u"pixelplumbLab"_s, labFileVersion);
    object.insert(u"warnings"_s, QJsonArray::fromStringList(warningsOf(study)));
    return QJsonDocument(object).toJson();
}

QByteArray writeAccuracy(const Study &study)
{
    QJsonArray rows;
    for (const LabRow &row : study.rows)
        rows.append(jsonOf(row.withoutTimes()));
    return QJsonDocument(rows).toJson();
}

Result<Study> readStudy(const QByteArray &text)
{
    JsonReader json(text);
    if (json.hasFailed())
        return json.error();
    const QString versionKey = u"pixelplumbLab"_s;
    const JsonNode version = json.root()[versionKey];
    const QString expected = QString::number(labFileVersion);
    if (json.root().isObject() && version.isMissing()) {
        json.fail(json.root(), u"no “%1”"_s.arg(versionKey), expected);
        return json.error();
    }
    Study study;
    if (version.toInteger(0) != labFileVersion)
        json.fail(version, describe(version), expected);
    else
        FieldReader(json).readMembers(json.root(), study, {versionKey, u"warnings"_s});
    if (json.hasFailed())
        return json.error();
    return study;
}

} // namespace pixelplumb
