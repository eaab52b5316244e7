// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/marginoptions.h"

#include "app/cli/suggestion.h"
#include "core/scan/choicenames.h"

#include <algorithm>

namespace pixelplumb::cli {

namespace {

const QString toleranceOption = QStringLiteral("tolerance");
const QString leewayOption = QStringLiteral("leeway");

InputError unknownWord(const QString &option, const QString &word, const QStringList &words)
{
    return unknownName(QStringLiteral("--") + option, QStringLiteral("name"), word, words);
}

} // namespace

void addToleranceOption(CommandLine &line)
{
    line.addOption(
        {toleranceOption,
         QStringLiteral("The arithmetic that a right program may compute in; its rounding is "
                        "allowed for: float32 or float64; float32 if left out."),
         QStringLiteral("name"), QStringLiteral("float32")});
}

void addMarginOptions(CommandLine &line)
{
    line.addOption({leewayOption,
                    QStringLiteral("What a right program may draw otherwise: strict, nothing; "
                                   "rule, what rounding decides; edges, also samples on edges; "
                                   "once, the same, but where two triangles share an edge one of "
                                   "them draws its samples; rule if left out."),
                    QStringLiteral("name"), QStringLiteral("rule")});
    addToleranceOption(line);
}

Result<Arithmetic> chosenTolerance(const CommandLine &line)
{
    const QString tolerance = line.value(toleranceOption);
    const auto arithmetic = arithmeticNamed(tolerance.toStdString());
    if (!arithmetic || std::ranges::find(allTolerances, *arithmetic) == allTolerances.end())
        return unknownWord(toleranceOption, tolerance, namesOf(allTolerances));
    return *arithmetic;
}

Result<Margin> chosenMargin(const CommandLine &line)
{
    const Result<Arithmetic> tolerance = chosenTolerance(line);
    if (!tolerance)
        return tolerance.error();
    Margin margin{Leeway::Rule, *tolerance};
    const QString word = line.value(leewayOption);
    QStringList words;
    for (const Leeway each : allLeeways) {
        words += nameOf(each);
        if (words.back() == word)
            margin.leeway = each;
    }
    if (!words.contains(word))
        return unknownWord(leewayOption, word, words);
    return margin;
}

} // namespace pixelplumb::cli
