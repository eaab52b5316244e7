// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/diagnosisreport.h"

#include "core/number/failure.h"
#include "core/scan/choicenames.h"

#include <QJsonArray>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

struct PartingPlace {
    std::size_t scene = 0; ///< of those given, from 1
    PartingStep step;
};

/// The first step of the first scene at which a candidate's run departs from the right one; none
/// where an error makes the runs impossible to compare.
std::optional<PartingPlace> partingPlaceOf(std::span<const Submission> submissions,
                                           const DiagnosisCandidate &candidate)
{
    for (std::size_t i = 0; i < submissions.size(); ++i) {
        const Scene &scene = submissions[i].scene;
        const auto own = ownDefects(defectsFor(scene), candidate.defects);
        std::optional<PartingStep> step;
        failureOf([&] { step = partingStepOf(scene, own); });
        if (step)
            return PartingPlace{i + 1, *std::move(step)};
    }
    return std::nullopt;
}

/// "unsorted-colours, but for 3 pixels that …", "flat-first (1 pixel is left)"
QString titleOf(const DiagnosisCandidate &candidate)
{
    QString title = candidate.ids().join(QStringLiteral(" and "));
    if (candidate.undecidable > 0)
        title += QStringLiteral(", ") + undecidableText(candidate.undecidable);
    if (candidate.distance > 0)
        title += QStringLiteral(" (%1 %2 left)")
                     .arg(pixelsText(candidate.distance),
                          candidate.distance == 1 ? QStringLiteral("is") : QStringLiteral("are"));
    return title;
}

} // namespace

QStringList textOf(const Diagnosis &diagnosis, std::span<const Submission> submissions)
{
    if (diagnosis.verdict == DiagnosisVerdict::Right)
        return {QStringLiteral("right: no pixel differs")};
    const bool isWrong = diagnosis.verdict == DiagnosisVerdict::Wrong;
    QString verdict
        = QStringLiteral("%1: %2 %3")
              .arg(nameOf(diagnosis.verdict), pixelsText(diagnosis.differing),
                   diagnosis.differing == 1 ? QStringLiteral("differs") : QStringLiteral("differ"));
    if (isWrong && diagnosis.undecidable > 0)
        verdict += QStringLiteral(", %1 of them undecidable").arg(diagnosis.undecidable);
    QStringList lines = {verdict};
    if (diagnosis.failure)
        lines += QStringLiteral("the search for defects ended in an error: %1")
                     .arg(*diagnosis.failure);
    else if (diagnosis.candidates.empty() && isWrong)
        lines += QStringLiteral("no known defect comes nearer");
    else if (!diagnosis.isExplained() && isWrong)
        lines += QStringLiteral("no known defect explains it; the nearest ones:");
    for (const DiagnosisCandidate &candidate : diagnosis.candidates) {
        lines += titleOf(candidate);
        if (!isRelevant(candidate.distance, diagnosis.differing))
            continue;
        for (const QString &sentence : candidate.sentences(&Defect::forAssistant))
            lines += QStringLiteral("    ") + sentence;
        for (const QString &sentence : candidate.sentences(&Defect::forStudent))
            lines += QStringLiteral("    to the student: ") + sentence;
        if (const auto place = partingPlaceOf(submissions, candidate)) {
            const QString where = submissions.size() > 1
                ? QStringLiteral("scene %1, ").arg(place->scene)
                : QString();
            lines += QStringLiteral("    departs from the right run at %1step %2, %3: %4")
                         .arg(where, QString::number(place->step.step + 1), place->step.heading,
                              place->step.text);
        }
    }
    return lines;
}

QJsonObject jsonOf(const Diagnosis &diagnosis, std::span<const Submission> submissions)
{
    QJsonArray candidates;
    for (const DiagnosisCandidate &candidate : diagnosis.candidates) {
        const auto array = &QJsonArray::fromStringList;
        QJsonObject object{
            {QStringLiteral("defects"), array(candidate.ids())},
            {QStringLiteral("distance"), qint64(candidate.distance)},
            {QStringLiteral("undecidable"), qint64(candidate.undecidable)},
            {QStringLiteral("student"), array(candidate.sentences(&Defect::forStudent))},
            {QStringLiteral("assistant"), array(candidate.sentences(&Defect::forAssistant))}};
        if (candidate.arithmetic)
            object.insert(QStringLiteral("arithmetic"), nameText(nameOf(*candidate.arithmetic)));
        if (const auto place = partingPlaceOf(submissions, candidate))
            object.insert(QStringLiteral("parts"),
                          QJsonObject{{QStringLiteral("scene"), qint64(place->scene)},
                                      {QStringLiteral("step"), qint64(place->step.step + 1)},
                                      {QStringLiteral("at"), place->step.heading},
                                      {QStringLiteral("how"), place->step.text}});
        candidates.append(object);
    }
    const bool isTransparent = std::ranges::any_of(
        submissions, [](const Submission &submission) { return submission.picture.isTransparent; });
    QJsonObject object{{QStringLiteral("verdict"), nameOf(diagnosis.verdict)},
                       {QStringLiteral("transparencyIgnored"), isTransparent},
                       {QStringLiteral("differing"), qint64(diagnosis.differing)},
                       {QStringLiteral("undecidable"), qint64(diagnosis.undecidable)},
                       {QStringLiteral("candidates"), candidates}};
    if (diagnosis.failure)
        object.insert(QStringLiteral("searchError"), *diagnosis.failure);
    return object;
}

} // namespace pixelplumb::cli
