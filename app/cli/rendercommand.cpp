// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/output.h"
#include "app/cli/rejectionreport.h"
#include "app/cli/sceneoptions.h"
#include "core/frame/framebuffer.h"
#include "core/runs/tracedscene.h"
#include "core/scene/asciiraster.h"

#include <QFileInfo>
#include <QImageWriter>

namespace pixelplumb::cli {

namespace {

/// Formats without loss: each pixel can be read back.
const QStringList &pictureFormats()
{
    static const QStringList formats
        = {QStringLiteral("png"), QStringLiteral("bmp"), QStringLiteral("ppm")};
    return formats;
}

std::optional<InputError> writePicture(const Scene &scene, Output &output, const QString &format)
{
    const FrameBuffer frame(scene.frame);
    drawScene(scene, frame);
    if (auto error = output.open())
        return error;
    QImageWriter writer(&output.device(), format.toLatin1());
    if (!writer.write(frame.image()))
        return output.error(writer.errorString());
    return output.finish();
}

} // namespace

ExitCode render(const Command &command, const QStringList &arguments)
{
    const QString outputOption = QStringLiteral("output");
    const QString asciiOption = QStringLiteral("ascii");
    CommandLine line(command, {scenePositional()});
    line.addOption(
        {{QStringLiteral("o"), outputOption},
         QStringLiteral("Write the picture: PNG, BMP or PPM by the name's end; - is standard "
                        "output, as PNG."),
         QStringLiteral("file")});
    line.addOption(
        {asciiOption,
         QStringLiteral("Print the raster: # for each pixel that is written, . for others.")});
    addSettingOptions(line);
    if (const auto ended = line.parse(arguments))
        return *ended;

    const QString path = line.value(outputOption);
    const bool wantsPicture = line.isSet(outputOption);
    const bool wantsAscii = line.isSet(asciiOption);
    if (!wantsPicture && !wantsAscii)
        return line.refuse(QStringLiteral("nothing to do; expected -o FILE, --ascii or both"));
    if (wantsAscii && path == QStringLiteral("-"))
        return line.refuse(
            QStringLiteral("-o - and --ascii both need standard output; expected one"));
    // Standard output and names without an end, such as /dev/stdout, get the first of the formats.
    const QString suffix = path == QStringLiteral("-") ? QString() : QFileInfo(path).suffix();
    const QString format = suffix.isEmpty() ? pictureFormats().front() : suffix.toLower();
    if (wantsPicture && !pictureFormats().contains(format)) {
        return line.refuse(
            QStringLiteral("-o %1: unknown kind of picture; expected a name that ends in .")
                .arg(path)
            + pictureFormats().join(QStringLiteral(", .")));
    }

    const Result<Scene> scene = readScene(line);
    if (!scene)
        return line.refuse(scene.error());
    reportRejections(line.argument(0) + QStringLiteral(", ") + scene->method.c_str(),
                     rejectedPrimitives(*scene));
    if (wantsPicture) {
        Output output(path, line.argument(0));
        if (const auto error = writePicture(*scene, output, format))
            return line.refuse(*error);
    }
    if (wantsAscii)
        printLine(asciiRaster(coverageOf(*scene)).chopped(1));
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
