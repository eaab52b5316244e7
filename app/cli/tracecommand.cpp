// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "app/cli/options.h"
#include "core/export/traceexport.h"
#include "core/space/vertexlight.h"

#include <unistd.h>

#include <algorithm>
#include <array>

namespace pixelplumb::cli {

namespace {

constexpr QLatin1String primitiveOption("triangle");
constexpr QLatin1String xOption("x");
constexpr QLatin1String yOption("y");

bool hasSpansAlong(const ScanTrace &trace, SpanAxis axis)
{
    for (std::size_t i = 0; i < trace.spanCount(); ++i) {
        if (trace.span(i).place.axis == axis)
            return true;
    }
    return trace.spanCount() == 0;
}

std::optional<std::int64_t> coordinate(const CommandLine &line, const QString &option,
                                       const TracedScene &traced, TraceLevel level)
{
    if (!line.isSet(option))
        return std::nullopt;
    const QString place = QStringLiteral("--") + option;
    if (level == TraceLevel::Stage || level == TraceLevel::SetUp)
        refuse({place,
                level == TraceLevel::Stage ? QStringLiteral("a stage has no place in the frame")
                                           : QStringLiteral("a primitive's set-up has no place"),
                QStringLiteral("--level column or --level pixel")});
    const bool isX = option == xOption;
    if (level == TraceLevel::Column
        && !hasSpansAlong(*traced.trace, isX ? SpanAxis::Column : SpanAxis::Row))
        refuse(
            {place,
             QStringLiteral("“%1” walks along no such %2")
                 .arg(traced.method->id, isX ? QStringLiteral("columns") : QStringLiteral("rows")),
             QStringLiteral("--level pixel, or the other coordinate")});
    const FrameSpec &frame = traced.scene.frame;
    const std::int64_t first = isX ? frame.firstColumn : frame.firstRow;
    const std::int64_t size = isX ? frame.width : frame.height;
    return wholeNumberOf(line, option,
                         {first, first + size - 1, QStringLiteral("outside the frame")});
}

/// --triangle, --x and --y, which choose rows of a trace's table.
void addRowOptions(CommandLine &line)
{
    const QString number = QStringLiteral("number");
    line.addOption({primitiveOption,
                    QStringLiteral("Print the rows of this primitive alone, counted from 0."),
                    number});
    line.addOption(
        {xOption, QStringLiteral("Print the rows of this column of the frame alone."), number});
    line.addOption(
        {yOption, QStringLiteral("Print the rows of this row of the frame alone."), number});
}

/// The chosen rows; refuses an option that names what the run or the table lacks.
RowChoice chosenRows(const CommandLine &line, const TracedScene &traced, TraceLevel level)
{
    const auto primitive = wholeNumberOf(line, primitiveOption, primitivesOf(*traced.trace));
    const auto x = coordinate(line, xOption, traced, level);
    const auto y = coordinate(line, yOption, traced, level);
    RowChoice rows{std::nullopt, x, y};
    if (primitive)
        rows.primitive = std::size_t(*primitive);
    return rows;
}

template <class Choice, std::size_t count>
using ChoiceNames = std::array<std::pair<const char *, Choice>, count>;

constexpr ChoiceNames<TraceLevel, 4> levelNames = {{{"setup", TraceLevel::SetUp},
                                                    {"column", TraceLevel::Column},
                                                    {"pixel", TraceLevel::Pixel},
                                                    {"stage", TraceLevel::Stage}}};
constexpr ChoiceNames<TableFormat, 3> formatNames
    = {{{"text", TableFormat::Text}, {"csv", TableFormat::Csv}, {"json", TableFormat::Json}}};

template <class Choice, std::size_t count>
Choice chosen(const CommandLine &line, const QString &option, Choice unset,
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
    refuseUnknownAmongMany(QStringLiteral("--") + option, QStringLiteral("name"), word, names,
                           names.join(QStringLiteral(", ")));
}

/// Text for a person at a terminal, CSV for a pipe or a file.
TableFormat formatFor(const QString &output)
{
    return isStandardOutput(output) && isatty(STDOUT_FILENO) != 0 ? TableFormat::Text
                                                                  : TableFormat::Csv;
}

QStringList chosenColumns(const CommandLine &line, const TraceNumbers &numbers, TraceLevel level)
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
            refuse({place, QStringLiteral("a name is missing"),
                    QStringLiteral("names separated by commas, of ")
                        + names.join(QStringLiteral(", "))});
        const QString name = traceColumnNamed(numbers, level, written);
        if (name.isEmpty())
            refuseUnknown(place, QStringLiteral("column"), written, names);
        // A second column of the same name would be lost to readers that go by name.
        if (columns.contains(name))
            refuse({place, QStringLiteral("“%1” is named twice").arg(written),
                    QStringLiteral("each column once")});
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
    const QString &path = named.path;
    const auto traced = tracedWithProgress(*named.run);
    // The columns depend on the effects that the scene calls for, known only now.
    const QStringList columns = chosenColumns(line, traced->trace->numbers(), request.level);
    const RowChoice rows = chosenRows(line, *traced, request.level);
    reportRejections(path + QStringLiteral(", ") + traced->method->id, rejectedPrimitives(*traced));

    if (line.isSet(QStringLiteral("decimal")) && request.format != TableFormat::Text)
        refuse({QStringLiteral("--decimal"),
                QStringLiteral("only a table as text is printed in one kind of number"),
                QStringLiteral("--format text")});
    Output output(outputPath);
    output.open();
    TraceExportOptions options{request.level, request.format};
    options.columns = columns;
    options.rows = rows;
    if (line.isSet(QStringLiteral("frame")))
        options.frame = line.value(QStringLiteral("frame")).toInt();
    options.textNumbers
        = line.isSet(QStringLiteral("decimal")) ? TextNumbers::Decimal : TextNumbers::Mixed;
    const bool written = withProgress([&](const ProgressListener &listener) {
        options.progress = listener;
        return exportTrace(*traced, options, output.device());
    });
    if (!written)
        refuse(output.error());
    output.finish();
    if (request.level == TraceLevel::Stage && !named.run->scene.hasSolids()
        && !lightsVertices(named.run->scene.appearance))
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
    line.parse(arguments);
    const TraceLevel level = chosen(line, levelOption, TraceLevel::Column, levelNames);
    const TableFormat format
        = chosen(line, formatOption, formatFor(line.value(outputOption)), formatNames);
    const auto outputs = outputPaths(line.value(outputOption), line.arguments(), suffixOf(format));
    const TraceRequest request{level, format};
    ExitCode code = ExitCode::Done;
    const std::vector<NamedScene> scenes = readScenes(line, readScene);
    for (std::size_t i = 0; i < scenes.size(); ++i)
        code = std::max(code, !scenes[i].run ? ExitCode::Usage : endOf(line.command(), [&] {
                            return traceTo(line, request, scenes[i], outputs.at(qsizetype(i)));
                        }));
    return code;
}

} // namespace pixelplumb::cli
