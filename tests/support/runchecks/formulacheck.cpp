// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/words/formulatext.h"
#include "tests/support/formularange.h"
#include "tests/support/runchecks/runcheck.h"
#include "tests/support/sanitized.h"

#include <QStringList>

#include <algorithm>
#include <map>

namespace pixelplumb {

namespace {

/// The share of formulas whose shown digits are so few that a wrong number would pass: those that
/// divide by a difference of two shortened numbers, as spans do, or that round a whole number, as
/// boxes do.
constexpr double vagueShare = 0.065;
/// If a method's numbers have formulas at all, it shows more of them than this.
constexpr double fewestFormulas = 40;
/// Per run, so that a message stays readable.
constexpr qsizetype mostFaults = 5;

struct Tally {
    double count = 0; ///< formulas that were evaluated
    double vague = 0; ///< those evaluated from too few digits
    std::map<QString, int> vagueOnes; ///< how often each of them, by its symbols
};

/// Where an exact run has no exact number, it computes in double.
Arithmetic arithmeticOf(const FormulaLine &line, Arithmetic ofRun)
{
    return ofRun == Arithmetic::Exact && !line.used.isRational() ? Arithmetic::Float64 : ofRun;
}

QString faultOf(const CheckedRun &run, Tally &tally)
{
    QStringList faults;
    for (const ExplainedStep &each : run.steps) {
        for (const FormulaLine &line : each.explanation.lines) {
            // With effects, a number that no formula gives is shown without one.
            if (run.traced->shading() && line.substituted.isEmpty())
                continue;
            const Arithmetic arithmetic = arithmeticOf(line, run.traced->scene.settings.arithmetic);
            const auto range = FormulaRange::of(line.substituted, arithmetic);
            const QString fault = formulaFault(line, range, arithmetic);
            if (!fault.isEmpty() && faults.size() < mostFaults)
                faults += u"%1: %2 %3, not %4, at step %5"_s.arg(line.symbols, line.substituted,
                                                                 fault, toText(line.used),
                                                                 QString::number(each.index));
            if (run.origin != RunOrigin::Scene)
                continue;
            ++tally.count;
            if (range && !range->isNarrow()) {
                ++tally.vague;
                ++tally.vagueOnes[line.symbols];
            }
        }
    }
    return faults.join(u"; "_s);
}

QString faultOfAll(const Method &method, const Tally &tally)
{
    const auto hasFormula
        = [](const NumberDescription &number) { return !number.formula.isEmpty(); };
    if (std::ranges::any_of(method.numbers.span, hasFormula) && tally.count <= fewestFormulas)
        return u"only %1 formulas"_s.arg(tally.count);
    if (tally.vague <= vagueShare * tally.count)
        return {};
    const auto most = std::ranges::max_element(tally.vagueOnes, {},
                                               [](const auto &entry) { return entry.second; });
    return u"%1 of %2 are vague, %3 of them %4"_s.arg(tally.vague)
        .arg(tally.count)
        .arg(most->second)
        .arg(most->first);
}

} // namespace

RunCheck formulaCheck()
{
    const auto tally = std::make_shared<Tally>();
    return {u"every formula comes out at the number beside it"_s,
            [tally](const CheckedRun &run) { return faultOf(run, *tally); },
            [tally](const Method &method) { return faultOfAll(method, *tally); }};
}

} // namespace pixelplumb
