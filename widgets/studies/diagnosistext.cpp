// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/diagnosistext.h"

#include "widgets/studies/diagnosisview.h"

namespace pixelplumb {

QString diagnosisText(const Diagnosis &diagnosis)
{
    const auto tr = [](const char *text) { return DiagnosisView::tr(text); };
    if (diagnosis.verdict == DiagnosisVerdict::Right)
        return tr("Right: no pixel differs, there is no bug to name.");
    const QString verdict = diagnosis.verdict == DiagnosisVerdict::Wrong
        ? tr("Wrong.")
        : tr("Undecidable: what differs lies on edges, where rules differ, or within what "
             "rounding in float32 may do.");
    if (diagnosis.candidates.empty())
        return diagnosis.verdict == DiagnosisVerdict::Wrong
            ? verdict + u' ' + tr("No known defect comes near.")
            : verdict;
    if (!diagnosis.isExplained())
        return verdict + u' ' + tr("No known defect explains it; the nearest ones:");
    return verdict + u' '
        + (diagnosis.candidates.front().undecidable > 0
               ? tr("Known defects draw this picture, but for pixels that may be either way:")
               : diagnosis.candidates.size() == 1
               ? tr("One set of known defects draws this very picture:")
               : tr("%1 sets of known defects draw this very picture:")
                     .arg(diagnosis.candidates.size()));
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
        return candidate.undecidable == 1
            ? DiagnosisView::tr(" · but for 1 pixel that rounding or an edge may decide")
            : DiagnosisView::tr(" · but for %L1 pixels that rounding or an edge may decide")
                  .arg(candidate.undecidable);
    return candidate.distance == 1
        ? DiagnosisView::tr(" · 1 pixel is left")
        : DiagnosisView::tr(" · %L1 pixels are left").arg(candidate.distance);
}

} // namespace pixelplumb
