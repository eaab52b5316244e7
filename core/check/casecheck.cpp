// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecheck.h"

#include "core/check/attributecase.h"
#include "core/check/effectcase.h"
#include "core/check/linecase.h"
#include "core/check/shapecase.h"
#include "core/check/strokecase.h"
#include "core/check/trianglecase.h"

#include <algorithm>

namespace pixelplumb {

namespace {

bool draws(const Method &method, const HardCase &hardCase)
{
    return hardCase.shapes.empty() ? method.draws(PrimitiveKind::Triangle)
                                   : method.draws(hardCase.shapes.front());
}

/// "a triangle", "an outlined circle": what a method must be able to draw.
QString subjectOf(const HardCase &hardCase)
{
    if (hardCase.shapes.empty())
        return QStringLiteral("a ") + nameOf(PrimitiveKind::Triangle);
    const Shape &shape = hardCase.shapes.front();
    if (shape.kind != PrimitiveKind::Circle)
        return QStringLiteral("a ") + nameOf(shape.kind);
    return (shape.fill == ShapeFill::Outline ? QStringLiteral("an outlined ")
                                             : QStringLiteral("a filled "))
        + nameOf(shape.kind);
}

/// Why none of the contenders draws the case: no method can, or those that can were not chosen.
QString whyNoneDraws(const HardCase &hardCase)
{
    QStringList able;
    for (const Method &method : methods()) {
        if (draws(method, hardCase))
            able.append(method.id);
    }
    const QString none = QStringLiteral("none of the methods checked draws ") + subjectOf(hardCase);
    return able.isEmpty()
        ? none
        : none + QStringLiteral("; by name can be checked: ") + able.join(QStringLiteral(", "));
}

/// Why the contender refuses to draw the case; empty where it does not.
QString refusalOf(const Contender &contender, const HardCase &hardCase)
{
    if (hardCase.kind == HardCaseKind::Polygon)
        return shapeRefusal(hardCase, contender.settings, *contender.method);
    if (hardCase.kind == HardCaseKind::Effects)
        return effectRefusal(contender.settings, *contender.method);
    return {};
}

/// Shortfalls of the method's plain kernel, and of its fast ones where theirs differ.
QStringList paintingShortfalls(const HardCase &hardCase, const Contender &contender)
{
    const Method &method = *contender.method;
    const Drawing drawn = drawingBy(method, Kernels::Plain);
    if (isStrokeCase(hardCase, method))
        return strokeShortfalls(hardCase, contender.settings, drawn);
    QStringList shortfalls = shortfallsOf(hardCase, contender.settings, drawn);
    if (!method.hasFastKernels)
        return shortfalls;
    const QStringList byFast
        = shortfallsOf(hardCase, contender.settings, drawingBy(method, Kernels::Fastest));
    if (byFast != shortfalls) {
        for (const QString &shortfall : byFast)
            shortfalls += QStringLiteral("fast kernels: ") + shortfall;
    }
    return shortfalls;
}

ContenderVerdict verdictOn(const Contender &contender, const HardCase &hardCase)
{
    ContenderVerdict verdict{contender, CaseOutcome::Passed, {}};
    if (!hardCase.facts.contains(contender.settings.fillRule)) {
        verdict.outcome = CaseOutcome::Skipped;
        verdict.remarks = {QStringLiteral("the case has no facts under this rule")};
        return verdict;
    }
    const QString refusal = refusalOf(contender, hardCase);
    if (!refusal.isEmpty()) {
        verdict.outcome = CaseOutcome::Skipped;
        verdict.remarks = {refusal};
        return verdict;
    }
    verdict.remarks = paintingShortfalls(hardCase, contender);
    if (hardCase.kind == HardCaseKind::Attributes)
        verdict.remarks += valueShortfalls(hardCase, contender.settings, *contender.method);
    if (!verdict.remarks.isEmpty())
        verdict.outcome = CaseOutcome::FellShort;
    return verdict;
}

} // namespace

QString nameOf(CaseOutcome outcome)
{
    switch (outcome) {
    case CaseOutcome::Passed:
        return QStringLiteral("pass");
    case CaseOutcome::FellShort:
        return QStringLiteral("FAIL");
    case CaseOutcome::Skipped:
        return QStringLiteral("skip");
    }
    return {};
}

std::int64_t CaseReport::count(CaseOutcome of) const
{
    return std::ranges::count(verdicts, of, &ContenderVerdict::outcome);
}

CaseOutcome CaseReport::summary() const
{
    if (outcome != CaseOutcome::Passed)
        return outcome;
    if (count(CaseOutcome::FellShort) > 0)
        return CaseOutcome::FellShort;
    const bool nothingDone = !verdicts.empty() && count(CaseOutcome::Passed) == 0;
    return nothingDone ? CaseOutcome::Skipped : CaseOutcome::Passed;
}

QStringList shortfallsOf(const HardCase &hardCase, const ScanSettings &settings,
                         const Drawing &drawing)
{
    switch (hardCase.kind) {
    case HardCaseKind::Triangle:
    case HardCaseKind::Attributes:
    case HardCaseKind::Mesh:
    case HardCaseKind::Sequence:
    case HardCaseKind::Translation:
        return triangleShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Line:
        return lineShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Circle:
    case HardCaseKind::Polygon:
        return shapeShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Effects:
        return effectShortfalls(hardCase, settings, drawing);
    case HardCaseKind::Invalid:
        break;
    }
    return {};
}

CaseReport checkCase(const HardCase &hardCase, const std::vector<Contender> &contenders)
{
    CaseReport report;
    report.id = hardCase.id;
    if (hardCase.kind == HardCaseKind::Invalid) {
        if (hardCase.refusal.isEmpty()) {
            report.outcome = CaseOutcome::FellShort;
            report.remarks = {QStringLiteral("its coordinates are accepted")};
        } else {
            report.remarks = {QStringLiteral("refused: ") + hardCase.refusal};
        }
        return report;
    }
    if (!hardCase.displacements.isEmpty()) {
        report.remarks = {QStringLiteral("compared with the truth after snapping ")
                          + hardCase.displacements.join(QStringLiteral(", "))};
    }
    for (const Contender &contender : contenders) {
        if (draws(*contender.method, hardCase))
            report.verdicts.push_back(verdictOn(contender, hardCase));
    }
    if (report.verdicts.empty()) {
        report.outcome = CaseOutcome::Skipped;
        report.remarks.append(whyNoneDraws(hardCase));
    }
    return report;
}

} // namespace pixelplumb
