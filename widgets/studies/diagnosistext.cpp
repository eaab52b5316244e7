// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/diagnosistext.h"

#include "widgets/studies/diagnosisview.h"

namespace pixelplumb {

QString diagnosisText(const Diagnosis &diagnosis)
{
    if (diagnosis.verdict == DiagnosisVerdict::Right)
        return DiagnosisView::tr("Right: no pixel differs, there is no bug to name.");
    const QString verdict = diagnosis.verdict == DiagnosisVerdict::Wrong
        ? DiagnosisView::tr("Wrong.")
        : DiagnosisView::tr(
            "Undecidable: what differs lies on edges, where rules differ, or within what "
            "rounding in float32 may do.");
    if (diagnosis.candidates.empty())
        return verdict + u' ' + DiagnosisView::tr("No known defect comes near.");
    if (!diagnosis.isExplained())
        return verdict + u' ' + DiagnosisView::tr("No known defect explains it; the nearest ones:");
    return verdict + u' '
        + DiagnosisView::tr("%n sets of known defects draw this very picture:", nullptr,
                            int(diagnosis.candidates.size()));
}

QString idsText(const DiagnosisCandidate &candidate)
{
    QStringList ids;
    for (const Defect &defect : candidate.defects)
        ids += defect.id;
    return ids.join(DiagnosisView::tr(" and "));
}

QString sentencesText(const DiagnosisCandidate &candidate, QString Defect::*words)
{
    QStringList sentences;
    for (const Defect &defect : candidate.defects) {
        if (!sentences.contains(defect.*words))
            sentences += defect.*words;
    }
    return sentences.join(u' ');
}

QString distanceText(const DiagnosisCandidate &candidate)
{
    if (candidate.distance == 0)
        return {};
    return DiagnosisView::tr(" · %n pixels are left", nullptr, int(candidate.distance));
}

} // namespace pixelplumb
