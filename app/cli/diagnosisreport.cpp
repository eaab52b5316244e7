// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/diagnosisreport.h"

#include <QJsonArray>

namespace pixelplumb::cli {

namespace {

struct PartingPlace {
    std::size_t scene = 0; ///< of those given, from 1
    PartingStep step;
};

/// The first step of the first scene at which a candidate's run parts from the right one.
std::optional<PartingPlace> partingPlaceOf(std::span<const Submission> submissions,
                                           const DiagnosisCandidate &candidate)
{
    for (std::size_t i = 0; i < submissions.size(); ++i) {
        if (auto step = partingStepOf(submissions[i].scene, candidate.defects))
            return PartingPlace{i + 1, *std::move(step)};
    }
    return std::nullopt;
}

/// "3 pixels differ"; one differs.
QString countText(std::int64_t pixels, const QString &verb)
{
    return pixels == 1 ? QStringLiteral("1 pixel %1s").arg(verb)
                       : QStringLiteral("%1 pixels %2").arg(pixels).arg(verb);
}

} // namespace

QStringList textOf(const Diagnosis &diagnosis, std::span<const Submission> submissions)
{
    if (diagnosis.verdict == DiagnosisVerdict::Right)
        return {QStringLiteral("right: no pixel differs")};
    QStringList lines = {QStringLiteral("%1: %2").arg(
        nameOf(diagnosis.verdict), countText(diagnosis.differing, QStringLiteral("differ")))};
    if (diagnosis.candidates.empty())
        lines += QStringLiteral("no known defect comes nearer");
    else if (!diagnosis.isExplained())
        lines += QStringLiteral("no known defect explains it; the nearest ones:");
    for (const DiagnosisCandidate &candidate : diagnosis.candidates) {
        QStringList ids;
        for (const Defect &defect : candidate.defects)
            ids += defect.id;
        lines += diagnosis.isExplained() ? ids.join(QStringLiteral(" and "))
                                         : QStringLiteral("%1 (%2 pixels are left)")
                                               .arg(ids.join(QStringLiteral(" and ")))
                                               .arg(candidate.distance);
        for (const Defect &defect : candidate.defects) {
            lines += QStringLiteral("    ") + defect.forAssistant;
            lines += QStringLiteral("    to the student: ") + defect.forStudent;
        }
        if (const auto place = partingPlaceOf(submissions, candidate)) {
            const QString where = submissions.size() > 1
                ? QStringLiteral("scene %1, ").arg(place->scene)
                : QString();
            lines += QStringLiteral("    parts at %1step %2, %3: %4")
                         .arg(where)
                         .arg(place->step.step + 1)
                         .arg(place->step.heading, place->step.text);
        }
    }
    return lines;
}

QJsonObject jsonOf(const Diagnosis &diagnosis, std::span<const Submission> submissions)
{
    QJsonArray candidates;
    for (const DiagnosisCandidate &candidate : diagnosis.candidates) {
        QJsonArray ids;
        QJsonArray forStudent;
        QJsonArray forAssistant;
        for (const Defect &defect : candidate.defects) {
            ids.append(defect.id);
            forStudent.append(defect.forStudent);
            forAssistant.append(defect.forAssistant);
        }
        QJsonObject object{{QStringLiteral("defects"), ids},
                           {QStringLiteral("distance"), qint64(candidate.distance)},
                           {QStringLiteral("student"), forStudent},
                           {QStringLiteral("assistant"), forAssistant}};
        if (const auto place = partingPlaceOf(submissions, candidate))
            object.insert(QStringLiteral("parts"),
                          QJsonObject{{QStringLiteral("scene"), qint64(place->scene)},
                                      {QStringLiteral("step"), qint64(place->step.step + 1)},
                                      {QStringLiteral("at"), place->step.heading},
                                      {QStringLiteral("how"), place->step.text}});
        candidates.append(object);
    }
    return {{QStringLiteral("verdict"), nameOf(diagnosis.verdict)},
            {QStringLiteral("differing"), qint64(diagnosis.differing)},
            {QStringLiteral("candidates"), candidates}};
}

} // namespace pixelplumb::cli
