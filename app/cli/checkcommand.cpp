// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "app/cli/options.h"
#include "core/check/casecheck.h"
#include "core/scan/choicenames.h"
#include "core/scene/files/fileaccess.h"

#include <QJsonArray>
#include <QJsonObject>

namespace pixelplumb::cli {

namespace {

const QString allArithmeticsWord = QStringLiteral("all");

/// Every method, arithmetic and rule that the options allow. Without --method, all methods; without
/// a rule, all of the method's rules; without an arithmetic, the method's stable ones, or exact
/// arithmetic for a single method.
std::vector<Contender> contendersFor(const CommandLine &line)
{
    const Method *method = chosenMethod(line, methods().front().id);
    const bool everyArithmetic = line.value(QStringLiteral("arithmetic")) == allArithmeticsWord;
    const Arithmetic arithmetic
        = everyArithmetic ? Arithmetic::Exact : chosenArithmetic(line, Arithmetic::Exact);
    const FillRule fillRule = chosenFillRule(line, FillRule::Closed);

    const bool chooses
        = line.isSet(QStringLiteral("method")) || line.isSet(QStringLiteral("arithmetic"));
    std::vector<Contender> contenders;
    for (const Method &each : methods()) {
        if (line.isSet(QStringLiteral("method")) && &each != method)
            continue;
        for (const Arithmetic number : each.arithmetics) {
            const bool isMeant = chooses ? number == arithmetic : each.isStableIn(number);
            if (!everyArithmetic && !isMeant)
                continue;
            for (const FillRule rule : each.fillRules) {
                if (!line.isSet(QStringLiteral("fill-rule")) || rule == fillRule)
                    contenders.push_back({&each, {number, rule, ByteRounding::Nearest}});
            }
        }
    }
    if (contenders.empty())
        refuse(QStringLiteral("no method draws in this arithmetic under this rule"));
    return contenders;
}

void printReport(const CaseReport &report)
{
    QString text = QStringLiteral("%1  %2").arg(nameOf(report.summary()), report.id);
    if (!report.verdicts.empty()) {
        const auto done = qsizetype(report.verdicts.size()) - report.count(CaseOutcome::Skipped);
        text += QStringLiteral("  %1 of %2").arg(report.count(CaseOutcome::Passed)).arg(done);
    }
    if (!report.remarks.isEmpty())
        text += QStringLiteral("  ") + report.remarks.join(QStringLiteral("; "));
    printLine(text);
    for (const ContenderVerdict &verdict : report.verdicts) {
        if (verdict.outcome == CaseOutcome::FellShort) {
            printLine(
                QStringLiteral("      %1: %2")
                    .arg(verdict.contender.name(), verdict.remarks.join(QStringLiteral("; "))));
        }
    }
}

QJsonObject jsonOf(const CaseReport &report)
{
    QJsonArray verdicts;
    for (const ContenderVerdict &verdict : report.verdicts) {
        const Contender &contender = verdict.contender;
        verdicts.append(QJsonObject{
            {QStringLiteral("method"), contender.method->id},
            {QStringLiteral("arithmetic"), nameText(nameOf(contender.settings.arithmetic))},
            {QStringLiteral("fillRule"), nameText(nameOf(contender.settings.fillRule))},
            {QStringLiteral("outcome"), nameOf(verdict.outcome).toLower()},
            {QStringLiteral("remarks"), QJsonArray::fromStringList(verdict.remarks)}});
    }
    return {{QStringLiteral("id"), report.id},
            {QStringLiteral("outcome"), nameOf(report.summary()).toLower()},
            {QStringLiteral("remarks"), QJsonArray::fromStringList(report.remarks)},
            {QStringLiteral("verdicts"), verdicts}};
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
    const QString name = QStringLiteral("name");
    CommandLine line(command,
                     {{QStringLiteral("CASES"),
                       QStringLiteral("a file of hard cases (JSON), or - for standard input")}});
    line.addJsonOption();
    line.addOption({QStringLiteral("method"), QStringLiteral("Check this method alone."), name});
    line.addOption({QStringLiteral("arithmetic"),
                    QStringLiteral("Check in this arithmetic, or in all; exact if left out."),
                    name});
    line.addOption(
        {QStringLiteral("fill-rule"), QStringLiteral("Check under this rule alone."), name});
    line.parse(arguments);

    const std::vector<Contender> contenders = contendersFor(line);
    const std::vector<HardCase> cases
        = requiredIn(line.argument(0), readHardCases(readInput(line.argument(0))));

    Progress progress;
    Tally tally;
    QJsonArray reports;
    for (const HardCase &hardCase : cases) {
        progress.show(QStringLiteral("case %1 of %2: %3")
                          .arg(tally.total() + 1)
                          .arg(cases.size())
                          .arg(hardCase.id));
        const CaseReport report = checkCase(hardCase, contenders);
        tally.add(report.summary());
        progress.clear();
        if (line.asksForJson())
            reports.append(jsonOf(report));
        else
            printReport(report);
    }
    if (line.asksForJson()) {
        const QJsonObject all{{QStringLiteral("cases"), reports},
                              {QStringLiteral("passed"), tally.passed},
                              {QStringLiteral("fellShort"), tally.fellShort},
                              {QStringLiteral("skipped"), tally.skipped}};
        printJson(all);
    } else {
        printLine(QStringLiteral("%1: %2 passed, %3 fell short, %4 skipped")
                      .arg(tally.total() == 1 ? QStringLiteral("1 case")
                                              : QStringLiteral("%1 cases").arg(tally.total()))
                      .arg(tally.passed)
                      .arg(tally.fellShort)
                      .arg(tally.skipped));
    }
    return tally.fellShort > 0 ? ExitCode::FallsShort : ExitCode::Done;
}

} // namespace pixelplumb::cli
