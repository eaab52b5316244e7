// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
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
    const QString expected
        = isOpen ? u"%1 or more"_s.arg(range.first) : u"%1 … %2"_s.arg(range.first).arg(range.last);
    bool isNumber = false;
    const qint64 value = word.toLongLong(&isNumber);
    if (!isNumber)
        refuse({place, u"“%1” is no whole number"_s.arg(word), expected});
    if (value < range.first || value > range.last)
        refuse({place, u"%1 is %2"_s.arg(QString::number(value), range.outside), expected});
    return std::int64_t(value);
}

std::optional<std::int64_t> wholeNumberOf(const CommandLine &line, const QString &option,
                                          const WholeRange &range)
{
    const QString word = line.value(option);
    if (word.isEmpty() && !line.isSet(option))
        return std::nullopt;
    return wholeNumber(u"--"_s + option, word, range);
}

std::optional<std::size_t> chosenName(const CommandLine &line, const QString &option,
                                      const QStringList &names, const QString &what)
{
    if (!line.isSet(option))
        return std::nullopt;
    const qsizetype index = names.indexOf(line.value(option));
    if (index < 0)
        refuseUnknown(u"--"_s + option, what, line.value(option), names);
    return std::size_t(index);
}

TableFormat chosenTableFormat(const CommandLine &line, TableFormat unset)
{
    const QString option = u"format"_s;
    const auto index = chosenName(line, option, {u"text"_s, u"csv"_s, u"json"_s}, option);
    return index ? TableFormat(*index) : unset;
}

namespace {

const QString seedOption = u"seed"_s;

} // namespace

void addSeedOption(CommandLine &line, const QString &what)
{
    line.addOption(
        {seedOption, u"Of the random %1; 1 if left out."_s.arg(what), u"number"_s, u"1"_s});
}

std::uint64_t chosenSeed(const CommandLine &line)
{
    const QString word = line.value(seedOption);
    bool isNumber = false;
    const qulonglong seed = word.toULongLong(&isNumber);
    if (!isNumber)
        refuse({u"--seed"_s, u"“%1” is no whole number of 64 bits"_s.arg(word),
                u"0 … 18446744073709551615"_s});
    return std::uint64_t(seed);
}

namespace {

const QString toleranceOption = u"tolerance"_s;
const QString leewayOption = u"leeway"_s;

} // namespace

void addToleranceOption(CommandLine &line)
{
    line.addOption(
        {toleranceOption,
         u"The arithmetic that a right program may compute in; its rounding is allowed for: "
         "float32 or float64; float32 if left out."_s,
         u"name"_s, u"float32"_s});
}

void addMarginOptions(CommandLine &line)
{
    line.addOption(
        {leewayOption,
         u"What a right program may draw otherwise: strict, nothing; rule, what rounding decides; "
         "edges, also samples on edges; once, the same, but where two triangles share an edge one "
         "of them draws its samples; rule if left out."_s,
         u"name"_s, u"rule"_s});
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
    line.addRepeatedOption({forceOption,
                            u"Switch an effect on or off whatever the scene calls for: "_s
                                + effectWords().join(u", "_s)
                                + u", each with =on or =off. May be repeated."_s,
                            u"effect=on|off"_s});
}

EffectForcing chosenForcing(const CommandLine &line)
{
    const QString place = u"--"_s + forceOption;
    EffectForcing forced;
    for (const QString &entry : line.values(forceOption)) {
        const QString name = entry.section(u'=', 0, 0);
        const QString state = entry.section(u'=', 1);
        if (name == wordOf(Effect::Clipping))
            refuse({place,
                    u"clipping has no switch: the frame's border bounds every loop, at no cost"_s,
                    {}});
        const auto found = std::ranges::find(allEffects, name, wordOf);
        if (found == allEffects.end())
            refuseUnknown(place, u"effect"_s, name, effectWords());
        if (state != u"on"_s && state != u"off"_s)
            refuse({place, u"“%1”"_s.arg(entry), u"%1=on or %1=off"_s.arg(name)});
        const Forcing forcing = state == u"on"_s ? Forcing::On : Forcing::Off;
        if (forced[*found] != Forcing::AsCalledFor && forced[*found] != forcing)
            refuse({place, u"%1=on and %1=off"_s.arg(name), u"one of them"_s});
        forced[*found] = forcing;
    }
    return forced;
}

namespace {

const QString inputOption = u"input"_s;
const QString timeOption = u"time"_s;
const QString memoryOption = u"memory"_s;

/// The memory limit; 0: none.
std::int64_t chosenMegabytes(const CommandLine &line)
{
    const auto megabytes = wholeNumberOf(line, memoryOption, {0, mostMegabytes});
    if (*megabytes == 0 || *megabytes >= leastMegabytes)
        return *megabytes;
    refuse({u"--"_s + memoryOption, u"no program starts in %1 MiB"_s.arg(*megabytes),
            u"%1 … %2, or 0 for no limit"_s.arg(leastMegabytes).arg(mostMegabytes)});
}

} // namespace

void addProgramOptions(CommandLine &line)
{
    line.addOption(
        {inputOption,
         u"What a program gets on stdin: json, the scene; lines, its triangles as plain lines; "
         "json if left out."_s,
         u"kind"_s, u"json"_s});
    line.addOption(
        {timeOption,
         u"Seconds that it may compute for each scene; a program that waits four times as long is "
         "ended by the clock; 10 if left out."_s,
         u"seconds"_s, u"10"_s});
    line.addOption(
        {memoryOption,
         u"MiB of addresses for each process, %1 at least; 0: no limit; 1024 if left out."_s.arg(
             leastMegabytes),
         u"number"_s, u"1024"_s});
}

void refuseProgramOptions(const CommandLine &line)
{
    for (const QString &option : {inputOption, timeOption, memoryOption}) {
        if (line.isSet(option))
            refuse({u"--"_s + option, u"says how a program is run, and none is named"_s,
                    u"“program:COMMAND” among %1"_s.arg(line.arguments().join(u", "_s))});
    }
}

TrialTerms chosenTerms(const CommandLine &line)
{
    TrialTerms terms;
    const QStringList inputs = {nameOf(ProgramInput::Json), nameOf(ProgramInput::Lines)};
    terms.input = ProgramInput(chosenName(line, inputOption, inputs, u"name"_s).value_or(0));
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
        report.insert(u"noSandbox"_s, unsandboxedText(sandboxLack()));
}

} // namespace pixelplumb::cli
