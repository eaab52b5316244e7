// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/options.h"

#include "app/cli/console.h"
#include "core/grade/class/assignment.h"
#include "core/grade/try/sandbox.h"
#include "core/scan/choicenames.h"

#include <algorithm>
#include <array>

namespace pixelplumb::cli {

std::int64_t wholeNumber(const QString &place, const QString &word, const WholeRange &range)
{
    const bool isOpen = range.last == std::numeric_limits<std::int64_t>::max();
    const QString expected = isOpen ? QStringLiteral("%1 or more").arg(range.first)
                                    : QStringLiteral("%1 … %2").arg(range.first).arg(range.last);
    bool isNumber = false;
    const qint64 value = word.toLongLong(&isNumber);
    if (!isNumber)
        refuse({place, QStringLiteral("“%1” is no whole number").arg(word), expected});
    if (value < range.first || value > range.last)
        refuse({place, QStringLiteral("%1 is %2").arg(QString::number(value), range.outside),
                expected});
    return std::int64_t(value);
}

std::optional<std::int64_t> wholeNumberOf(const CommandLine &line, const QString &option,
                                          const WholeRange &range)
{
    const QString word = line.value(option);
    if (word.isEmpty() && !line.isSet(option))
        return std::nullopt;
    return wholeNumber(QStringLiteral("--") + option, word, range);
}

namespace {

const QString seedOption = QStringLiteral("seed");

} // namespace

void addSeedOption(CommandLine &line, const QString &what)
{
    line.addOption({seedOption, QStringLiteral("Of the random %1; 1 if left out.").arg(what),
                    QStringLiteral("number"), QStringLiteral("1")});
}

std::uint64_t chosenSeed(const CommandLine &line)
{
    const QString word = line.value(seedOption);
    bool isNumber = false;
    const qulonglong seed = word.toULongLong(&isNumber);
    if (!isNumber)
        refuse({QStringLiteral("--seed"),
                QStringLiteral("“%1” is no whole number of 64 bits").arg(word),
                QStringLiteral("0 … 18446744073709551615")});
    return std::uint64_t(seed);
}

namespace {

const QString toleranceOption = QStringLiteral("tolerance");
const QString leewayOption = QStringLiteral("leeway");

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

Arithmetic chosenTolerance(const CommandLine &line)
{
    return chosen(line, toleranceOption, allTolerances, Arithmetic::Float32);
}

Margin chosenMargin(const CommandLine &line)
{
    return {chosen(line, leewayOption, allLeeways, Leeway::Rule), chosenTolerance(line)};
}

namespace {

constexpr QLatin1String forceOption("force");

/// "smooth-colour".
QString wordOf(Effect effect) { return nameText(nameOf(effect)).replace(u' ', u'-'); }

/// The words of the effects that have a switch.
QStringList effectWords()
{
    QStringList words;
    for (const Effect effect : allEffects) {
        if (effect != Effect::Clipping)
            words.append(wordOf(effect));
    }
    return words;
}

} // namespace

void addForceOption(CommandLine &line)
{
    line.addRepeatedOption(
        {forceOption,
         QStringLiteral("Switch an effect on or off whatever the scene calls for: ")
             + effectWords().join(QStringLiteral(", "))
             + QStringLiteral(", each with =on or =off. May be repeated."),
         QStringLiteral("effect=on|off")});
}

EffectForcing chosenForcing(const CommandLine &line)
{
    const QString place = QStringLiteral("--") + forceOption;
    EffectForcing forced;
    for (const QString &entry : line.values(forceOption)) {
        const QString name = entry.section(u'=', 0, 0);
        const QString state = entry.section(u'=', 1);
        if (name == wordOf(Effect::Clipping))
            refuse({place,
                    QStringLiteral("clipping has no switch: the frame's border bounds "
                                   "every loop, at no cost"),
                    {}});
        const auto found = std::ranges::find(allEffects, name, wordOf);
        if (found == allEffects.end())
            refuseUnknown(place, QStringLiteral("effect"), name, effectWords());
        if (state != QStringLiteral("on") && state != QStringLiteral("off"))
            refuse({place, QStringLiteral("“%1”").arg(entry),
                    QStringLiteral("%1=on or %1=off").arg(name)});
        const Forcing forcing = state == QStringLiteral("on") ? Forcing::On : Forcing::Off;
        if (forced[*found] != Forcing::AsCalledFor && forced[*found] != forcing)
            refuse({place, QStringLiteral("%1=on and %1=off").arg(name),
                    QStringLiteral("one of them")});
        forced[*found] = forcing;
    }
    return forced;
}

namespace {

const QString inputOption = QStringLiteral("input");
const QString timeOption = QStringLiteral("time");
const QString memoryOption = QStringLiteral("memory");

ProgramInput chosenInput(const CommandLine &line)
{
    QStringList names;
    for (const ProgramInput input : allProgramInputs) {
        names += nameOf(input);
        if (line.value(inputOption) == names.back())
            return input;
    }
    refuseUnknown(QStringLiteral("--") + inputOption, QStringLiteral("name"),
                  line.value(inputOption), names);
}

/// The memory limit; 0: none.
std::int64_t chosenMegabytes(const CommandLine &line)
{
    const auto megabytes = wholeNumberOf(line, memoryOption, {0, mostMegabytes});
    if (*megabytes == 0 || *megabytes >= leastMegabytes)
        return *megabytes;
    refuse({QStringLiteral("--") + memoryOption,
            QStringLiteral("no program starts in %1 MiB").arg(*megabytes),
            QStringLiteral("%1 … %2, or 0 for no limit").arg(leastMegabytes).arg(mostMegabytes)});
}

} // namespace

void addProgramOptions(CommandLine &line)
{
    line.addOption({inputOption,
                    QStringLiteral("What a program gets on stdin: json, the scene; lines, its "
                                   "triangles as plain lines; json if left out."),
                    QStringLiteral("kind"), QStringLiteral("json")});
    line.addOption(
        {timeOption,
         QStringLiteral("Seconds that it may compute for each scene; a program that waits four "
                        "times as long is ended by the clock; 10 if left out."),
         QStringLiteral("seconds"), QStringLiteral("10")});
    line.addOption({memoryOption,
                    QStringLiteral("MiB of addresses for each process, %1 at least; 0: no limit; "
                                   "1024 if left out.")
                        .arg(leastMegabytes),
                    QStringLiteral("number"), QStringLiteral("1024")});
}

void refuseProgramOptions(const CommandLine &line)
{
    for (const QString &option : {inputOption, timeOption, memoryOption}) {
        if (line.isSet(option))
            refuse({QStringLiteral("--") + option,
                    QStringLiteral("says how a program is run, and none is named"),
                    QStringLiteral("“program:COMMAND” among %1")
                        .arg(line.arguments().join(QStringLiteral(", ")))});
    }
}

TrialTerms chosenTerms(const CommandLine &line)
{
    TrialTerms terms;
    terms.input = chosenInput(line);
    terms.limits.time = std::chrono::seconds(*wholeNumberOf(line, timeOption, {1, 3600}));
    terms.limits.memory = chosenMegabytes(line) << 20;
    return terms;
}

QStringList confinementLines()
{
    return sandboxLack().isEmpty() ? QStringList() : QStringList(unsandboxedText(sandboxLack()));
}

void addConfinement(QJsonObject &report)
{
    if (!sandboxLack().isEmpty())
        report.insert(QStringLiteral("noSandbox"), unsandboxedText(sandboxLack()));
}

} // namespace pixelplumb::cli
