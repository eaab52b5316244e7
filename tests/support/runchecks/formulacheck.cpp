// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formulatext.h"
#include "tests/support/formularange.h"
#include "tests/support/runchecks/runcheck.h"
#include "tests/support/sanitized.h"

#include <QStringList>

#include <algorithm>

namespace pixelplumb {

namespace {

/// How many formulas may be known so badly from the digits that are shown that a wrong number would
/// pass: those that divide by a difference of two shortened numbers, as spans do.
constexpr double vagueShare = 0.06;
/// A method whose numbers have formulas shows more of them.
constexpr double fewestFormulas = 40;
/// Of one run, so that a message can be read.
constexpr qsizetype mostFaults = 5;

struct Tally {
    double count = 0; ///< formulas that were worked out
    double vague = 0; ///< of these, from too few digits
};

/// What an exact run has no exact number for it computes in double.
Arithmetic arithmeticOf(const FormulaLine &line, Arithmetic ofRun)
{
    return ofRun == Arithmetic::Exact && !line.used.isRational() ? Arithmetic::Float64 : ofRun;
}

QString faultOf(const CheckedRun &run, Tally &tally)
{
    QStringList faults;
    for (const ExplainedStep &each : run.steps) {
        for (const FormulaLine &line : each.explanation.lines) {
            // What no formula gives, where effects are done, stands by itself.
            if (run.traced->plan && line.substituted.isEmpty())
                continue;
            const Arithmetic arithmetic = arithmeticOf(line, run.traced->scene.settings.arithmetic);
            const auto range = FormulaRange::of(line.substituted, arithmetic);
            const QString fault = formulaFault(line, range, arithmetic);
            if (!fault.isEmpty() && faults.size() < mostFaults)
                faults += QStringLiteral("%1: %2 %3, not %4, at step %5")
                              .arg(line.symbols, line.substituted, fault, toText(line.used),
                                   QString::number(each.index));
            if (run.origin != RunOrigin::Scene)
                continue;
            ++tally.count;
            tally.vague += range && !range->isNarrow() ? 1 : 0;
        }
    }
    return faults.join(QStringLiteral("; "));
}

QString faultOfAll(const Method &method, const Tally &tally)
{
    const auto hasFormula
        = [](const NumberDescription &number) { return !number.formula.isEmpty(); };
    if (std::ranges::any_of(method.numbers.span, hasFormula) && tally.count <= fewestFormulas)
        return QStringLiteral("only %1 formulas").arg(tally.count);
    return tally.vague <= vagueShare * tally.count
        ? QString()
        : QStringLiteral("%1 of %2 are vague").arg(tally.vague).arg(tally.count);
}

} // namespace

RunCheck formulaCheck()
{
    const auto tally = std::make_shared<Tally>();
    return {QStringLiteral("every formula comes out at the number beside it"),
            [tally](const CheckedRun &run) { return faultOf(run, *tally); },
            [tally](const Method &method) { return faultOfAll(method, *tally); }};
}

} // namespace pixelplumb
