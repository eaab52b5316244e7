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
    if (diagnosis.failure)
        return verdict + u' '
            + DiagnosisView::tr("The search for defects ended in an error: %1.")
                  .arg(*diagnosis.failure);
    if (diagnosis.candidates.empty())
        return diagnosis.verdict == DiagnosisVerdict::Wrong
            ? verdict + u' ' + DiagnosisView::tr("No known defect comes near.")
            : verdict;
    if (!diagnosis.isExplained())
        return verdict + u' ' + DiagnosisView::tr("No known defect explains it; the nearest ones:");
    return verdict + u' '
        + (diagnosis.candidates.front().undecidable > 0
               ? DiagnosisView::tr(
                   "Known defects draw this picture, but for pixels that may be either way:")
               : DiagnosisView::tr("%n sets of known defects draw this very picture:", nullptr,
                                   int(diagnosis.candidates.size())));
}

QString idsText(const DiagnosisCandidate &candidate)
{
    return candidate.ids().join(DiagnosisView::tr(" and "));
}

QString sentencesText(const DiagnosisCandidate &candidate, QString Defect::*words)
{
    return candidate.sentences(words).join(u' ');
}

QString distanceText(const DiagnosisCandidate &candidate)
{
    if (candidate.distance == 0 && candidate.undecidable == 0)
        return {};
    if (candidate.distance == 0)
        return DiagnosisView::tr(" · but for %n pixels that rounding or an edge may decide",
                                 nullptr, int(candidate.undecidable));
    return DiagnosisView::tr(" · %n pixels are left", nullptr, int(candidate.distance));
}

} // namespace pixelplumb
