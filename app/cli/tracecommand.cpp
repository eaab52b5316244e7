// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/output.h"
#include "app/cli/outputpaths.h"
#include "app/cli/progress.h"
#include "app/cli/rejectionreport.h"
#include "app/cli/rowoptions.h"
#include "app/cli/sceneoptions.h"
#include "app/cli/suggestion.h"
#include "core/export/traceexport.h"
#include "core/space/vertexlight.h"

#include <unistd.h>

#include <algorithm>
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

/// Text for a person at a terminal, CSV for a pipe or a file.
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
        const QString written = word.trimmed();
        if (written.isEmpty())
            return InputError{place, QStringLiteral("a name is missing"),
                              QStringLiteral("names separated by commas, of ")
                                  + names.join(QStringLiteral(", "))};
        const QString name = traceColumnNamed(numbers, level, written);
        if (name.isEmpty())
            return unknownName(place, QStringLiteral("column"), written, names);
        // A second column of the same name would be lost to readers that go by name.
        if (columns.contains(name))
            return InputError{place, QStringLiteral("“%1” is named twice").arg(written),
                              QStringLiteral("each column once")};
        columns.append(name);
    }
    return columns;
}

QString suffixOf(TableFormat format)
{
    switch (format) {
    case TableFormat::Text:
        return QStringLiteral("txt");
    case TableFormat::Csv:
        return QStringLiteral("csv");
    case TableFormat::Json:
        break;
    }
    return QStringLiteral("json");
}

/// What is written about each scene.
struct TraceRequest {
    TraceLevel level = TraceLevel::Column;
    TableFormat format = TableFormat::Csv;
};

/// Traces a scene that is drawn to its end, and writes the table.
ExitCode traceTo(const CommandLine &line, const TraceRequest &request, const NamedScene &named,
                 const QString &outputPath)
{
    const std::optional<Scene> &scene = named.scene;
    const QString &path = named.path;
    const auto traced = withProgress([&scene](const ProgressListener &listener) {
        TraceOptions recording;
        recording.progress = listener;
        return traceScene(*scene, recording);
    });
    // The columns depend on the effects that the scene calls for, known only now.
    const Result<QStringList> columns
        = chosenColumns(line, traced->trace->numbers(), request.level);
    if (!columns)
        return line.refuse(columns.error());
    const Result<RowChoice> rows = chosenRows(line, *traced, request.level);
    if (!rows)
        return line.refuse(rows.error());
    reportRejections(path + QStringLiteral(", ") + traced->method->id, rejectedPrimitives(*traced));

    if (line.isSet(QStringLiteral("decimal")) && request.format != TableFormat::Text)
        return line.refuse({QStringLiteral("--decimal"),
                            QStringLiteral("only a table as text is printed in one kind of number"),
                            QStringLiteral("--format text")});
    Output output(outputPath);
    if (const auto error = output.open())
        return line.refuse(*error);
    TraceExportOptions options{request.level, request.format};
    options.columns = *columns;
    options.rows = *rows;
    if (line.isSet(QStringLiteral("frame")))
        options.frame = line.value(QStringLiteral("frame")).toInt();
    options.textNumbers
        = line.isSet(QStringLiteral("decimal")) ? TextNumbers::Decimal : TextNumbers::Mixed;
    const bool written = withProgress([&](const ProgressListener &listener) {
        options.progress = listener;
        return exportTrace(*traced, options, output.device());
    });
    if (const auto error = written ? output.finish() : std::optional(output.error()))
        return line.refuse(*error);
    if (request.level == TraceLevel::Stage && !scene->hasSolids()
        && !lightsVertices(scene->appearance))
        sayLine(
            QStringLiteral("%1: no stages: there is no solid in it that comes from space to the "
                           "frame, and no light at vertices")
                .arg(path));
    if (traced->trace->isCut()) {
        sayLine(QStringLiteral("The trace is incomplete: recording ended at its limit after %1 "
                               "pixels in %2 columns.")
                    .arg(traced->trace->sampleCount())
                    .arg(traced->trace->spanCount()));
        return ExitCode::FallsShort;
    }
    return ExitCode::Done;
}

} // namespace

ExitCode trace(const Command &command, const QStringList &arguments)
{
    const QString levelOption = QStringLiteral("level");
    const QString formatOption = QStringLiteral("format");
    const QString outputOption = QStringLiteral("output");
    CommandLine line(command, {scenesPositional()});
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
                    QStringLiteral("Print these columns alone, named as in the header of the CSV "
                                   "or of the text: a,b,c."),
                    QStringLiteral("names")});
    line.addOption(
        {QStringLiteral("decimal"), QStringLiteral("In text, print 5.129630 instead of 5 7/54.")});
    line.addOption({{QStringLiteral("o"), outputOption},
                    QStringLiteral("Write to a file; - is standard output. A folder, DIR/, gets "
                                   "each scene's table under the scene's name."),
                    QStringLiteral("file"),
                    QStringLiteral("-")});
    addRowOptions(line);
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
    const auto outputs = outputPaths(line.value(outputOption), line.arguments(), suffixOf(*format));
    if (!outputs)
        return line.refuse(outputs.error());
    const TraceRequest request{*level, *format};
    ExitCode code = ExitCode::Done;
    const std::vector<NamedScene> scenes = readScenes(line, readScene);
    for (std::size_t i = 0; i < scenes.size(); ++i)
        code = std::max(code,
                        scenes[i].scene
                            ? traceTo(line, request, scenes[i], outputs->at(qsizetype(i)))
                            : ExitCode::Usage);
    return code;
}

} // namespace pixelplumb::cli
