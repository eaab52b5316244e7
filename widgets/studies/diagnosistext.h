// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/diagnosis.h"

namespace pixelplumb {

/// "Wrong: 12 pixels differ. These defects draw the very picture:"
QString diagnosisText(const Diagnosis &diagnosis);
/// "unsorted-colours and y-truncated"
QString idsText(const DiagnosisCandidate &candidate);
/// One sentence per defect; `words`: for the student or the assistant.
QString sentencesText(const DiagnosisCandidate &candidate, QString Defect::*words);
/// " · 3 pixels are left"; empty where none are.
QString distanceText(const DiagnosisCandidate &candidate);

} // namespace pixelplumb
