// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "core/check/casecheck.h"
#include "core/scan/choicenames.h"
#include "core/scene/files/fileaccess.h"

#include <QJsonArray>
#include <QJsonObject>

namespace pixelplumb::cli {

namespace {

const QString allArithmeticsWord = u"all"_s;

/// Every method, arithmetic and rule that the options allow. Without --method, all methods; without
/// a rule, all of the method's rules; without an arithmetic, the method's stable ones, or exact
/// arithmetic for a single method.
std::vector<Contender> contendersFor(const CommandLine &line)
{
    const Method *method = chosenMethod(line, methods().front().id);
    const bool everyArithmetic = line.value(u"arithmetic"_s) == allArithmeticsWord;
    const Arithmetic arithmetic
        = everyArithmetic ? Arithmetic::Exact : chosenArithmetic(line, Arithmetic::Exact);
    const FillRule fillRule = chosenFillRule(line, FillRule::Closed);

    const bool chooses = line.isSet(u"method"_s) || line.isSet(u"arithmetic"_s);
    std::vector<Contender> contenders;
    for (const Method &each : methods()) {
        if (line.isSet(u"method"_s) && &each != method)
            continue;
        for (const Arithmetic number : each.arithmetics) {
            const bool isMeant = chooses ? number == arithmetic : each.isStableIn(number);
            if (!everyArithmetic && !isMeant)
                continue;
            for (const FillRule rule : each.fillRules) {
                if (!line.isSet(u"fill-rule"_s) || rule == fillRule)
                    contenders.push_back({&each, {number, rule, ByteRounding::Nearest}});
            }
        }
    }
    if (contenders.empty())
        refuse(u"no method draws in this arithmetic under this rule"_s);
    return contenders;
}

void printReport(const CaseReport &report)
{
    QString text = u"%1  %2"_s.arg(nameOf(report.summary()), report.id);
    if (!report.verdicts.empty()) {
        const auto done = qsizetype(report.verdicts.size()) - report.count(CaseOutcome::Skipped);
        text += u"  %1 of %2"_s.arg(report.count(CaseOutcome::Passed)).arg(done);
    }
    if (!report.remarks.isEmpty())
        text += u"  "_s + report.remarks.join(u"; "_s);
    printLine(text);
    for (const ContenderVerdict &verdict : report.verdicts) {
        if (verdict.outcome == CaseOutcome::FellShort) {
            printLine(
                u"      %1: %2"_s.arg(verdict.contender.name(), verdict.remarks.join(u"; "_s)));
        }
    }
}

QJsonObject jsonOf(const CaseReport &report)
{
    QJsonArray verdicts;
    for (const ContenderVerdict &verdict : report.verdicts) {
        const Contender &contender = verdict.contender;
        verdicts.append(
            QJsonObject{{u"method"_s, contender.method->id},
                        {u"arithmetic"_s, nameText(nameOf(contender.settings.arithmetic))},
                        {u"fillRule"_s, nameText(nameOf(contender.settings.fillRule))},
                        {u"outcome"_s, nameOf(verdict.outcome).toLower()},
                        {u"remarks"_s, QJsonArray::fromStringList(verdict.remarks)}});
    }
    return {{u"id"_s, report.id},
            {u"outcome"_s, nameOf(report.summary()).toLower()},
            {u"remarks"_s, QJsonArray::fromStringList(report.remarks)},
            {u"verdicts"_s, verdicts}};
}

/// How many cases had each outcome.
struct Tally {
    int passed = 0;
    int fellShort = 0;
    int skipped = 0;

    void add(CaseOutcome outcome)
    {
        passed += outcome == CaseOutcome::Passed ? 1 : 0;
        fellShort += outcome == CaseOutcome::FellShort ? 1 : 0;
        skipped += outcome == CaseOutcome::Skipped ? 1 : 0;
    }
    int total() const { return passed + fellShort + skipped; }
};

} // namespace

ExitCode check(const Command &command, const QStringList &arguments)
{
    const QString name = u"name"_s;
    CommandLine line(command,
                     {{u"CASES"_s, u"a file of hard cases (JSON), or - for standard input"_s}});
    line.addJsonOption();
    line.addOption({u"method"_s, u"Check this method alone."_s, name});
    line.addOption(
        {u"arithmetic"_s, u"Check in this arithmetic, or in all; exact if left out."_s, name});
    line.addOption({u"fill-rule"_s, u"Check under this rule alone."_s, name});
    line.parse(arguments);

    const std::vector<Contender> contenders = contendersFor(line);
    const std::vector<HardCase> cases
        = requiredIn(line.argument(0), readHardCases(readInput(line.argument(0))));

    Progress progress;
    Tally tally;
    QJsonArray reports;
    for (const HardCase &hardCase : cases) {
        progress.show(
            u"case %1 of %2: %3"_s.arg(tally.total() + 1).arg(cases.size()).arg(hardCase.id));
        const CaseReport report = checkCase(hardCase, contenders);
        tally.add(report.summary());
        progress.clear();
        if (line.asksForJson())
            reports.append(jsonOf(report));
        else
            printReport(report);
    }
    if (line.asksForJson()) {
        const QJsonObject all{{u"cases"_s, reports},
                              {u"passed"_s, tally.passed},
                              {u"fellShort"_s, tally.fellShort},
                              {u"skipped"_s, tally.skipped}};
        printJson(all);
    } else {
        printLine(u"%1: %2 passed, %3 fell short, %4 skipped"_s
                      .arg(tally.total() == 1 ? u"1 case"_s : u"%1 cases"_s.arg(tally.total()))
                      .arg(tally.passed)
                      .arg(tally.fellShort)
                      .arg(tally.skipped));
    }
    return tally.fellShort > 0 ? ExitCode::FallsShort : ExitCode::Done;
}

} // namespace pixelplumb::cli
