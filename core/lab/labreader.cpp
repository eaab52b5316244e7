// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/labfields.h"
#include "core/lab/labfile.h"
#include "core/scene/fieldreader.h"

#include <algorithm>

namespace pixelplumb {

template <>
inline constexpr int firstVersionWith<std::vector<DriftCurve>> = 2;
template <>
inline constexpr int firstVersionWith<std::vector<SizeCurve>> = 2;
template <>
inline constexpr int firstVersionWith<LabKernel> = 2;
template <>
inline constexpr int firstVersionWith<std::vector<EffectRow>> = 3;

Result<Study> readStudy(const QByteArray &text)
{
    JsonReader json(text);
    if (json.hasFailed())
        return json.error();
    const QString versionKey = QStringLiteral("pixelplumbLab");
    const JsonNode version = json.root()[versionKey];
    const QString expected
        = QStringLiteral("1 to %1, the versions of a lab's file").arg(labFileVersion);
    if (json.root().isObject() && version.isMissing()) {
        json.fail(json.root(), QStringLiteral("no “%1”").arg(versionKey), expected);
        return json.error();
    }
    Study study;
    const auto written = int(std::clamp<qint64>(version.toInteger(0), 0, labFileVersion + 1));
    if (written < 1 || written > labFileVersion)
        json.fail(version, describe(version), expected);
    else
        FieldReader(json, written)
            .readMembers(json.root(), study, {versionKey, QStringLiteral("warnings")});
    if (json.hasFailed())
        return json.error();
    if (written == 1) {
        for (StudyContender &contender : study.contenders)
            contender.kernel = kernelOf(contender.id);
    }
    return study;
}

} // namespace pixelplumb
