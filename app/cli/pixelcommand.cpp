// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/pixelreport.h"
#include "app/cli/rejectionreport.h"
#include "app/cli/sceneoptions.h"
#include "app/cli/wholenumber.h"
#include "core/scene/colourtext.h"

namespace pixelplumb::cli {

ExitCode pixel(const Command &command, const QStringList &arguments)
{
    const QString jsonOption = QStringLiteral("json");
    CommandLine line(
        command,
        {scenePositional(),
         {QStringLiteral("X"), QStringLiteral("the pixel's column")},
         {QStringLiteral("Y"), QStringLiteral("the pixel's row, counted as the scene does")}});
    line.addOption({jsonOption, QStringLiteral("Print JSON.")});
    addSettingOptions(line);
    if (const auto ended = line.parse(arguments))
        return *ended;
    const Result<Scene> scene = readScene(line, line.argument(0));
    if (!scene)
        return line.refuse(scene.error());
    const FrameSpec &frame = scene->frame;
    const auto along = [](std::int64_t first, std::int64_t size) {
        return WholeRange{first, first + size - 1, QStringLiteral("outside the frame")};
    };
    const auto x
        = wholeNumber(QStringLiteral("X"), line.argument(1), along(frame.firstColumn, frame.width));
    if (!x)
        return line.refuse(x.error());
    const auto y
        = wholeNumber(QStringLiteral("Y"), line.argument(2), along(frame.firstRow, frame.height));
    if (!y)
        return line.refuse(y.error());

    const auto traced = traceScene(*scene);
    reportRejections(line.argument(0) + QStringLiteral(", ") + traced->method->id,
                     rejectedPrimitives(*traced));
    const PixelReport report{*traced, *x, *y, pixelHistory(*traced, *x, *y)};
    if (line.isSet(jsonOption))
        printJson(QJsonDocument(jsonOf(report)));
    else
        printLines(textOf(report));
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
