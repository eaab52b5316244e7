// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "core/export/traceexport.h"
#include "core/runs/spanheadings.h"
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
    const QString place = u"--"_s + option;
    if (level == TraceLevel::Stage || level == TraceLevel::SetUp)
        refuse({place,
                level == TraceLevel::Stage ? u"a stage has no place in the frame"_s
                                           : u"a primitive's set-up has no place"_s,
                u"--level column or --level pixel"_s});
    const bool isX = option == xOption;
    if (level == TraceLevel::Column
        && !hasSpansAlong(*traced.trace, isX ? SpanAxis::Column : SpanAxis::Row))
        refuse({place,
                u"“%1” walks along no such %2"_s.arg(traced.method->id,
                                                     isX ? u"columns"_s : u"rows"_s),
                u"--level pixel, or the other coordinate"_s});
    const FrameSpec &frame = traced.scene.frame;
    const std::int64_t first = isX ? frame.firstColumn : frame.firstRow;
    const std::int64_t size = isX ? frame.width : frame.height;
    return wholeNumberOf(line, option, {first, first + size - 1, u"outside the frame"_s});
}

/// --triangle, --x and --y, which choose rows of a trace's table.
void addRowOptions(CommandLine &line)
{
    const QString number = u"number"_s;
    line.addOption(
        {primitiveOption, u"Print the rows of this primitive alone, counted from 0."_s, number});
    line.addOption({xOption, u"Print the rows of this column of the frame alone."_s, number});
    line.addOption({yOption, u"Print the rows of this row of the frame alone."_s, number});
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

/// Text for a person at a terminal, CSV for a pipe or a file.
TableFormat formatFor(const QString &output)
{
    return isStandardOutput(output) && isatty(STDOUT_FILENO) != 0 ? TableFormat::Text
                                                                  : TableFormat::Csv;
}

QStringList chosenColumns(const CommandLine &line, const TraceNumbers &numbers, TraceLevel level)
{
    const QString option = u"columns"_s;
    if (!line.isSet(option))
        return QStringList();
    const QStringList names = traceColumnNames(numbers, level);
    const QString place = u"--"_s + option;
    QStringList columns;
    for (const QString &word : line.value(option).split(u',')) {
        const QString written = word.trimmed();
        if (written.isEmpty())
            refuse({place, u"a name is missing"_s,
                    u"names separated by commas, of "_s + names.join(u", "_s)});
        const QString name = traceColumnNamed(numbers, level, written);
        if (name.isEmpty())
            refuseUnknown(place, u"column"_s, written, names);
        // A second column of the same name would be lost to readers that go by name.
        if (columns.contains(name))
            refuse({place, u"“%1” is named twice"_s.arg(written), u"each column once"_s});
        columns.append(name);
    }
    return columns;
}

QString suffixOf(TableFormat format)
{
    return format == TableFormat::Text ? u"txt"_s
        : format == TableFormat::Csv   ? u"csv"_s
                                       : u"json"_s;
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
    TraceNumbers numbers = traced->trace->numbers();
    numbers.span = spanHeadings(*traced);
    const QStringList columns = chosenColumns(line, numbers, request.level);
    const RowChoice rows = chosenRows(line, *traced, request.level);
    reportRejections(path + u", "_s + traced->method->id, rejectedPrimitives(*traced));

    if (line.isSet(u"decimal"_s) && request.format != TableFormat::Text)
        refuse({u"--decimal"_s, u"only a table as text is printed in one kind of number"_s,
                u"--format text"_s});
    Output output(outputPath);
    output.open();
    TraceExportOptions options{request.level, request.format};
    options.columns = columns;
    options.rows = rows;
    if (line.isSet(u"frame"_s))
        options.frame = line.value(u"frame"_s).toInt();
    options.textNumbers = line.isSet(u"decimal"_s) ? TextNumbers::Decimal : TextNumbers::Mixed;
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
            u"%1: no stages: there is no solid in it that comes from space to the frame, and no "
            "light at vertices"_s.arg(path));
    if (traced->trace->isCut()) {
        sayLine(u"The trace is incomplete: recording ended at its limit after %1 pixels in %2 "
                "columns."_s.arg(traced->trace->sampleCount())
                    .arg(traced->trace->spanCount()));
        return ExitCode::FallsShort;
    }
    return ExitCode::Done;
}

} // namespace

ExitCode trace(const Command &command, const QStringList &arguments)
{
    const QString levelOption = u"level"_s;
    const QString outputOption = u"output"_s;
    CommandLine line(command, {scenesPositional()});
    line.addOption(
        {levelOption,
         u"A row a primitive, a column of the scan, a pixel, or a number on a solid's way from "
         "space to the frame: setup, column, pixel, stage; column if left out."_s,
         u"level"_s});
    line.addOption({u"format"_s,
                    u"text (aligned), csv or json; if left out, text on a terminal, else csv."_s,
                    u"format"_s});
    line.addOption(
        {u"columns"_s,
         u"Print these columns alone, named as in the header of the CSV or of the text: a,b,c. "
         "In a pixel's row KEY_exact is the truth there, in others what the same run gives in "
         "exact numbers."_s,
         u"names"_s});
    line.addOption({u"decimal"_s, u"In text, print 5.129630 instead of 5 7/54."_s});
    line.addOption(
        {{u"o"_s, outputOption},
         u"Write to a file; - is standard output. A folder, DIR/, gets each scene's table under "
         "the scene's name."_s,
         u"file"_s,
         u"-"_s});
    addRowOptions(line);
    addSettingOptions(line);
    line.parse(arguments);
    const QStringList levels = {u"setup"_s, u"column"_s, u"pixel"_s, u"stage"_s};
    const auto level = TraceLevel(chosenName(line, levelOption, levels, levelOption)
                                      .value_or(std::size_t(TraceLevel::Column)));
    const TableFormat format = chosenTableFormat(line, formatFor(line.value(outputOption)));
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
