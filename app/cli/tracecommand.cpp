// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/sceneoptions.h"
#include "app/cli/suggestion.h"
#include "core/export/traceexport.h"

#include <array>

namespace pixelplumb::cli {

namespace {

template <class Choice>
using ChoiceNames = std::array<std::pair<const char *, Choice>, 2>;

constexpr ChoiceNames<TraceLevel> levelNames
    = {{{"column", TraceLevel::Column}, {"pixel", TraceLevel::Pixel}}};
constexpr ChoiceNames<TableFormat> formatNames
    = {{{"csv", TableFormat::Csv}, {"json", TableFormat::Json}}};

template <class Choice>
Result<Choice> chosen(const CommandLine &line, const QString &option,
                      const ChoiceNames<Choice> &choices)
{
    const QString word = line.value(option);
    QStringList names;
    for (const auto &choice : choices) {
        names.append(QString::fromLatin1(choice.first));
        if (names.back() == word)
            return choice.second;
    }
    InputError error
        = unknownName(QStringLiteral("--") + option, QStringLiteral("name"), word, names);
    error.expected = names.join(QStringLiteral(" or "));
    return error;
}

} // namespace

ExitCode trace(const Command &command, const QStringList &arguments)
{
    const QString levelOption = QStringLiteral("level");
    const QString formatOption = QStringLiteral("format");
    const QString outputOption = QStringLiteral("output");
    CommandLine line(command, {scenePositional()});
    line.addOption({levelOption, QStringLiteral("A row a column or a row a pixel: column, pixel."),
                    QStringLiteral("level"), QStringLiteral("column")});
    line.addOption({formatOption, QStringLiteral("csv or json."), QStringLiteral("format"),
                    QStringLiteral("csv")});
    line.addOption({{QStringLiteral("o"), outputOption},
                    QStringLiteral("Write to a file; - is standard output."),
                    QStringLiteral("file"),
                    QStringLiteral("-")});
    addSettingOptions(line);
    if (const auto ended = line.parse(arguments))
        return *ended;
    const Result<TraceLevel> level = chosen(line, levelOption, levelNames);
    if (!level)
        return line.refuse(level.error());
    const Result<TableFormat> format = chosen(line, formatOption, formatNames);
    if (!format)
        return line.refuse(format.error());
    const Result<Scene> scene = readScene(line);
    if (!scene)
        return line.refuse(scene.error());

    Progress progress;
    TraceOptions recording;
    recording.progress = [&](std::size_t columns) {
        progress.show(QStringLiteral("drawing: %1 columns").arg(columns));
        return true;
    };
    const auto traced = traceScene(*scene, recording);

    Output output(line.value(outputOption));
    if (const auto error = output.open())
        return line.refuse(*error);
    TraceExportOptions options{*level, *format, [&](double done) {
                                   progress.show(
                                       QStringLiteral("writing: %1 %").arg(int(done * 100)));
                                   return true;
                               }};
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
