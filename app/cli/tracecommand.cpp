// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/rejectionreport.h"
#include "app/cli/sceneoptions.h"
#include "app/cli/suggestion.h"
#include "core/export/traceexport.h"

#include <unistd.h>

#include <array>

namespace pixelplumb::cli {

namespace {

template <class Choice, std::size_t count>
using ChoiceNames = std::array<std::pair<const char *, Choice>, count>;

constexpr ChoiceNames<TraceLevel, 4> levelNames = {{{"setup", TraceLevel::SetUp},
                                                    {"column", TraceLevel::Column},
                                                    {"pixel", TraceLevel::Pixel},
                                                    {"stage", TraceLevel::Stage}}};
constexpr ChoiceNames<TableFormat, 3> formatNames
    = {{{"text", TableFormat::Text}, {"csv", TableFormat::Csv}, {"json", TableFormat::Json}}};

template <class Choice, std::size_t count>
Result<Choice> chosen(const CommandLine &line, const QString &option, Choice unset,
                      const ChoiceNames<Choice, count> &choices)
{
    if (!line.isSet(option))
        return unset;
    const QString word = line.value(option);
    QStringList names;
    for (const auto &choice : choices) {
        names.append(QString::fromLatin1(choice.first));
        if (names.back() == word)
            return choice.second;
    }
    InputError error
        = unknownName(QStringLiteral("--") + option, QStringLiteral("name"), word, names);
    error.expected = names.join(QStringLiteral(", "));
    return error;
}

/// Text for a person who looks on, CSV for whatever reads a pipe or a file.
TableFormat formatFor(const QString &output)
{
    return output == QStringLiteral("-") && isatty(STDOUT_FILENO) != 0 ? TableFormat::Text
                                                                       : TableFormat::Csv;
}

Result<QStringList> chosenColumns(const CommandLine &line, const TraceNumbers &numbers,
                                  TraceLevel level)
{
    const QString option = QStringLiteral("columns");
    if (!line.isSet(option))
        return QStringList();
    const QStringList names = traceColumnNames(numbers, level);
    const QString place = QStringLiteral("--") + option;
    QStringList columns;
    for (const QString &word : line.value(option).split(u',')) {
        const QString name = word.trimmed();
        if (name.isEmpty())
            return InputError{place, QStringLiteral("a name is missing"),
                              QStringLiteral("names separated by commas, of ")
                                  + names.join(QStringLiteral(", "))};
        if (!names.contains(name))
            return unknownName(place, QStringLiteral("column"), name, names);
        // A second one of the same name would be lost to whoever reads by name.
        if (columns.contains(name))
            return InputError{place, QStringLiteral("“%1” is named twice").arg(name),
                              QStringLiteral("each column once")};
        columns.append(name);
    }
    return columns;
}

} // namespace

ExitCode trace(const Command &command, const QStringList &arguments)
{
    const QString levelOption = QStringLiteral("level");
    const QString formatOption = QStringLiteral("format");
    const QString decimalOption = QStringLiteral("decimal");
    const QString outputOption = QStringLiteral("output");
    CommandLine line(command, {scenePositional()});
    line.addOption({levelOption,
                    QStringLiteral("A row a primitive, a column of the scan, a pixel, or a number "
                                   "on a solid's way from space to the frame: setup, column, "
                                   "pixel, stage; column if left out."),
                    QStringLiteral("level")});
    line.addOption({formatOption,
                    QStringLiteral("text (aligned), csv or json; if left out, text on a terminal, "
                                   "else csv."),
                    QStringLiteral("format")});
    line.addOption({QStringLiteral("columns"),
                    QStringLiteral("Print these columns alone, named as in the CSV's header: "
                                   "a,b,c."),
                    QStringLiteral("names")});
    line.addOption({decimalOption, QStringLiteral("In text, print 5.129630 instead of 5 7/54.")});
    line.addOption({{QStringLiteral("o"), outputOption},
                    QStringLiteral("Write to a file; - is standard output."),
                    QStringLiteral("file"),
                    QStringLiteral("-")});
    addSettingOptions(line);
    if (const auto ended = line.parse(arguments))
        return *ended;
    const Result<TraceLevel> level = chosen(line, levelOption, TraceLevel::Column, levelNames);
    if (!level)
        return line.refuse(level.error());
    const Result<TableFormat> format
        = chosen(line, formatOption, formatFor(line.value(outputOption)), formatNames);
    if (!format)
        return line.refuse(format.error());
    const Result<Scene> scene = readScene(line);
    if (!scene)
        return line.refuse(scene.error());

    Progress progress;
    TraceOptions recording;
    recording.progress = progress.listener();
    const auto traced = traceScene(*scene, recording);
    // Which there are is known when it is known what the scene calls for.
    const Result<QStringList> columns = chosenColumns(line, traced->trace->numbers(), *level);
    if (!columns)
        return line.refuse(columns.error());
    reportRejections(line.argument(0) + QStringLiteral(", ") + traced->method->id,
                     rejectedPrimitives(traced->primitives, *traced->trace));

    Output output(line.value(outputOption), line.argument(0));
    if (const auto error = output.open())
        return line.refuse(*error);
    TraceExportOptions options{*level, *format};
    options.progress = progress.listener();
    options.columns = *columns;
    options.textNumbers = line.isSet(decimalOption) ? TextNumbers::Decimal : TextNumbers::Mixed;
    const bool written = exportTrace(*traced, options, output.device());
    const auto error = output.finish();
    if (!written || error)
        return line.refuse(error.value_or(
            InputError{line.value(outputOption), QStringLiteral("cannot be written"), {}}));
    if (traced->trace->isCut()) {
        sayLine(QStringLiteral(
                    "The trace is incomplete: recording ended at its limit after %1 pixels in "
                    "%2 columns.")
                    .arg(traced->trace->sampleCount())
                    .arg(traced->trace->spanCount()));
        return ExitCode::FallsShort;
    }
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
