// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/pixelreport.h"
#include "app/cli/rejectionreport.h"
#include "app/cli/sceneoptions.h"
#include "core/scene/colourtext.h"

#include <QJsonDocument>

namespace pixelplumb::cli {

namespace {

/// A whole number within the frame; the error names the range.
Result<std::int64_t> coordinate(const CommandLine &line, qsizetype index, const QString &axis,
                                std::int64_t first, std::int64_t size)
{
    bool isNumber = false;
    const QString word = line.argument(index);
    const qint64 value = word.toLongLong(&isNumber);
    const QString range = QStringLiteral("%1 … %2").arg(first).arg(first + size - 1);
    if (!isNumber)
        return InputError{axis, QStringLiteral("“%1” is no whole number").arg(word), range};
    if (value < first || value >= first + size)
        return InputError{axis, QStringLiteral("%1 is outside the frame").arg(value), range};
    return value;
}

} // namespace

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
    const Result<Scene> scene = readScene(line);
    if (!scene)
        return line.refuse(scene.error());
    const FrameSpec &frame = scene->frame;
    const auto x = coordinate(line, 1, QStringLiteral("X"), frame.firstColumn, frame.width);
    if (!x)
        return line.refuse(x.error());
    const auto y = coordinate(line, 2, QStringLiteral("Y"), frame.firstRow, frame.height);
    if (!y)
        return line.refuse(y.error());

    const auto traced = traceScene(*scene);
    reportRejections(line.argument(0) + QStringLiteral(", ") + traced->method->id,
                     rejectedPrimitives(traced->primitives, *traced->trace));
    const PixelReport report{*traced, *x, *y, pixelHistory(*traced, *x, *y)};
    if (line.isSet(jsonOption)) {
        printLine(QString::fromUtf8(QJsonDocument(jsonOf(report)).toJson().chopped(1)));
    } else {
        const QStringList text = textOf(report);
        for (const QString &each : text)
            printLine(each);
    }
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
