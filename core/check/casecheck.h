// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casepicture.h"
#include "core/check/hardcase.h"
#include "core/runs/contender.h"

#include <QStringList>

namespace pixelplumb {

enum class CaseOutcome { Passed, FellShort, Skipped };

/// Where a drawing falls short of a case's facts, one sentence each; empty when all is right. The
/// case must have facts for the rule of `settings`.
QStringList shortfallsOf(const HardCase &hardCase, const ScanSettings &settings,
                         const Drawing &drawing);

/// How one contender did at a case.
struct ContenderVerdict {
    Contender contender;
    CaseOutcome outcome = CaseOutcome::Passed;
    QStringList remarks; ///< what falls short, or why it was skipped
};

/// How all contenders did at a case.
struct CaseReport {
    QString id;
    /// Of the case itself: skipped where no contender draws its kind; for invalid input, which is
    /// refused before any method sees it, passed or not.
    CaseOutcome outcome = CaseOutcome::Passed;
    QStringList remarks;
    std::vector<ContenderVerdict> verdicts; ///< of the contenders that draw the case's kind

    std::int64_t count(CaseOutcome of) const;
    /// The worst of the case's own outcome and its verdicts; skipped if every verdict was.
    CaseOutcome summary() const;
};

/// The contenders must not include the truth.
CaseReport checkCase(const HardCase &hardCase, const std::vector<Contender> &contenders);

/// "pass", "FAIL" or "skip"
QString nameOf(CaseOutcome outcome);

} // namespace pixelplumb
