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

} // namespace

void addProgramOptions(CommandLine &line)
{
    line.addOption({inputOption,
                    QStringLiteral("What a program gets on stdin: json, the scene; lines, its "
                                   "triangles as plain lines; json if left out."),
                    QStringLiteral("kind"), QStringLiteral("json")});
    line.addOption(
        {timeOption,
         QStringLiteral("Seconds that it may compute for each scene; who waits four times "
                        "as long is ended by the clock; 10 if left out."),
         QStringLiteral("seconds"), QStringLiteral("10")});
    line.addOption({memoryOption,
                    QStringLiteral("MiB of addresses for each process; 0: no limit; 1024 if left "
                                   "out."),
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
    const auto megabytes = wholeNumberOf(line, memoryOption, {0, 1 << 20});
    if (!megabytes)
        return megabytes.error();
    terms.limits.memory = **megabytes << 20;
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
