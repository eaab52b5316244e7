// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/programoptions.h"

#include "app/cli/suggestion.h"
#include "app/cli/wholenumber.h"
#include "core/grade/assignment.h"
#include "core/grade/sandbox.h"

namespace pixelplumb::cli {

namespace {

const QString inputOption = QStringLiteral("input");
const QString timeOption = QStringLiteral("time");
const QString memoryOption = QStringLiteral("memory");

Result<ProgramInput> chosenInput(const CommandLine &line)
{
    QStringList names;
    for (const ProgramInput input : allProgramInputs) {
        names += nameOf(input);
        if (line.value(inputOption) == names.back())
            return input;
    }
    return unknownName(QStringLiteral("--") + inputOption, QStringLiteral("name"),
                       line.value(inputOption), names);
}

/// The memory limit; 0: none.
Result<std::int64_t> chosenMegabytes(const CommandLine &line)
{
    const auto megabytes = wholeNumberOf(line, memoryOption, {0, mostMegabytes});
    if (!megabytes)
        return megabytes.error();
    if (**megabytes == 0 || **megabytes >= leastMegabytes)
        return **megabytes;
    return InputError{
        QStringLiteral("--") + memoryOption,
        QStringLiteral("no program starts in %1 MiB").arg(**megabytes),
        QStringLiteral("%1 … %2, or 0 for no limit").arg(leastMegabytes).arg(mostMegabytes)};
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

std::optional<InputError> refusalWithoutProgram(const CommandLine &line)
{
    for (const QString &option : {inputOption, timeOption, memoryOption}) {
        if (line.isSet(option))
            return InputError{QStringLiteral("--") + option,
                              QStringLiteral("says how a program is run, and none is named"),
                              QStringLiteral("“program:COMMAND” among %1")
                                  .arg(line.arguments().join(QStringLiteral(", ")))};
    }
    return std::nullopt;
}

Result<TrialTerms> chosenTerms(const CommandLine &line)
{
    TrialTerms terms;
    const Result<ProgramInput> input = chosenInput(line);
    if (!input)
        return input.error();
    terms.input = *input;
    const auto seconds = wholeNumberOf(line, timeOption, {1, 3600});
    if (!seconds)
        return seconds.error();
    terms.limits.time = std::chrono::seconds(**seconds);
    const Result<std::int64_t> megabytes = chosenMegabytes(line);
    if (!megabytes)
        return megabytes.error();
    terms.limits.memory = *megabytes << 20;
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
