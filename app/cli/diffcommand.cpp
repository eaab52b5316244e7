// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/options.h"
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/diagnose/undecidable.h"
#include "core/grade/pictures/drawntwice.h"
#include "core/scene/files/inputrecord.h"
#include "core/scene/text/byteordermark.h"
#include "core/scene/text/colourtext.h"

#include <QJsonArray>

namespace pixelplumb::cli {

namespace {

/// The expected picture, faint and grey, with the differing pixels marked.
QImage markedPicture(const PictureDiff &diff, const Picture &expected)
{
    QImage picture(diff.width, diff.height, QImage::Format_RGB32);
    for (int line = 0; line < diff.height; ++line) {
        auto *pixels = reinterpret_cast<QRgb *>(picture.scanLine(line));
        for (int x = 0; x < diff.width; ++x) {
            const std::size_t place = expected.placeOf(x, line);
            pixels[x] = markOf(diff.verdicts[place]).value_or(faint(expected.colours[place]));
        }
    }
    return picture;
}

QString wordOf(Difference verdict)
{
    return verdict == Difference::None ? QStringLiteral("same") : nameOf(verdict);
}

} // namespace

QStringList diffLines(const PictureDiff &diff)
{
    QStringList counts;
    for (const Difference verdict : allDifferences) {
        if (verdict == Difference::None || diff.count(verdict) > 0)
            counts.append(QStringLiteral("%1 %2").arg(diff.count(verdict)).arg(wordOf(verdict)));
    }
    QString text = QStringLiteral("%1 × %2 pixels: %3")
                       .arg(diff.width)
                       .arg(diff.height)
                       .arg(counts.join(QStringLiteral(", ")));
    if (diff.largestError > 0)
        text += QStringLiteral("; largest channel difference %1").arg(diff.largestError);
    QStringList lines = {text};
    constexpr qsizetype mostCauses = 3;
    for (const PictureCause &cause : diff.causes) {
        if (lines.size() > mostCauses)
            break;
        lines.append(cause.left == 0 ? QStringLiteral("explained wholly by: %1").arg(cause.name)
                                     : QStringLiteral("explained but for %1 by: %2")
                                           .arg(pixelsText(cause.left), cause.name));
    }
    return lines;
}

QJsonObject diffJson(const PictureDiff &diff)
{
    QJsonObject object{{QStringLiteral("width"), diff.width},
                       {QStringLiteral("height"), diff.height},
                       {QStringLiteral("largestError"), diff.largestError}};
    for (const Difference verdict : allDifferences)
        object.insert(wordOf(verdict), qint64(diff.count(verdict)));
    QJsonArray causes;
    for (const PictureCause &cause : diff.causes)
        causes.append(QJsonObject{{QStringLiteral("cause"), cause.name},
                                  {QStringLiteral("left"), qint64(cause.left)}});
    object.insert(QStringLiteral("causes"), causes);
    return object;
}

namespace {

/// A side of the comparison: a picture, and the scene where it is one.
struct Side {
    Picture picture;
    std::optional<Scene> scene;
};

/// Reads a side; an input that is a JSON object is a scene.
Side readSide(const QString &path, const Margin &margin)
{
    const QByteArray content = readInput(path, largestPictureFile);
    const QString formats
        = pictureFormatsText() + QStringLiteral(", or a scene as a JSON object: {…}");
    const QByteArray text = withoutByteOrderMark(content).trimmed();
    if (text.startsWith('['))
        refuse({path, QStringLiteral("a list in JSON is no scene"), formats});
    if (!text.startsWith('{'))
        return {required(parsePicture(content, path, formats)), std::nullopt};
    const Scene scene = sceneIn(content, path).scene;
    const SceneRun run(scene);
    refuseIf(refusalOf(run, path));
    const Scene judged = judgedScene(scene, margin);
    return {judged == scene ? pictureOf(run) : pictureOf(judged), judged};
}

/// What the scene on either side leaves open at the other side's pixels.
std::vector<std::uint8_t> undecidableOf(const Side &expected, const Side &found,
                                        const Margin &margin)
{
    if (expected.scene)
        return undecidablePixels(*expected.scene, expected.picture, found.picture, margin);
    if (found.scene)
        return undecidablePixels(*found.scene, found.picture, expected.picture, margin);
    return {};
}

/// The pixels drawn twice, of the side that is a scene; 0 where neither is.
std::int64_t drawnTwiceIn(const Side &expected, const Side &found)
{
    if (expected.scene)
        return drawnTwice(*expected.scene, found.picture);
    return found.scene ? drawnTwice(*found.scene, expected.picture) : 0;
}

/// The background: the option's, else the scene's; a raster needs none.
Colour backgroundFor(const CommandLine &line, const Side &expected, const Side &found)
{
    const QString option = QStringLiteral("background");
    if (line.isSet(option)) {
        if (const auto colour = parseColour(line.value(option)))
            return colour->colour;
        refuse({QStringLiteral("--background"),
                QStringLiteral("“%1” is no colour").arg(line.value(option)),
                QStringLiteral("#rrggbb")});
    }
    for (const Side *side : {&expected, &found}) {
        if (side->scene)
            return side->scene->frame.background;
    }
    return backgroundOf(expected.picture.hasColours ? expected.picture : found.picture);
}

} // namespace

ExitCode diff(const Command &command, const QStringList &arguments)
{
    const QString markedOption = QStringLiteral("output");
    const QString rasterOption = QStringLiteral("ascii");
    const QString what
        = QStringLiteral("a picture (PNG, PPM, BMP), a raster of # and ., or a scene");
    CommandLine line(command,
                     {{QStringLiteral("EXPECTED"), what}, {QStringLiteral("FOUND"), what}});
    line.addOption({{QStringLiteral("o"), markedOption},
                    QStringLiteral("Write a picture, too: what was expected, faint, with the "
                                   "pixels that differ in the colours of the manual."),
                    QStringLiteral("file")});
    line.addOption({rasterOption,
                    QStringLiteral("Print a raster, too: # the same, ? missing, ! extra, c another "
                                   "colour, = undecidable.")});
    line.addOption({QStringLiteral("background"),
                    QStringLiteral("What is not drawn has this colour; if left out, the scene's, "
                                   "else that of most corners of the picture."),
                    QStringLiteral("#rrggbb")});
    addMarginOptions(line);
    line.addJsonOption();
    line.parse(arguments);
    const auto format = pictureFormatOf(line, markedOption);
    refuseStandardOutput(line.value(markedOption), QStringLiteral("a file"));
    if (line.isSet(rasterOption) && line.asksForJson())
        refuse(QStringLiteral("--ascii and --json: a raster is no JSON; expected one "
                              "of them"));
    const Margin margin = chosenMargin(line);
    if (line.argument(0) == QStringLiteral("-") && line.argument(1) == QStringLiteral("-"))
        refuse(QStringLiteral("standard input can be only one of the two"));
    Side expected = readSide(line.argument(0), margin);
    Side found = readSide(line.argument(1), margin);
    if (line.isSet(markedOption))
        refuseIf(refusalToWrite(line.value(markedOption)));
    const auto sizeOf = [](const Picture &picture) { return QSize(picture.width, picture.height); };
    refuseOtherSizes({line.argument(0), sizeOf(expected.picture)},
                     {line.argument(1), sizeOf(found.picture)});
    const Colour background = backgroundFor(line, expected, found);
    for (Side *side : {&expected, &found}) {
        if (!side->scene && side->picture.hasColours)
            coverAllBut(background, side->picture);
    }
    for (const auto &[path, side] :
         {std::pair(line.argument(0), &expected), std::pair(line.argument(1), &found)}) {
        if (side->picture.isTransparent)
            sayLine(path + QStringLiteral(": ") + transparencyText());
    }
    const PictureDiff difference
        = differenceOf(expected.picture, found.picture, undecidableOf(expected, found, margin));
    const std::int64_t twice = drawnTwiceIn(expected, found);
    if (line.asksForJson()) {
        QJsonObject object = diffJson(difference);
        object.insert(QStringLiteral("drawnTwice"), qint64(twice));
        object.insert(QStringLiteral("transparencyIgnored"),
                      expected.picture.isTransparent || found.picture.isTransparent);
        printJson(object);
    } else {
        printLines(diffLines(difference));
        if (twice > 0)
            printLine(QStringLiteral("drawn twice: %1 pixels are blended once more than the fill "
                                     "rule says, as on edges that two triangles share")
                          .arg(twice));
        if (line.isSet(rasterOption))
            printLines(rasterOf(difference, expected.picture).chopped(1).split(u'\n'));
    }
    if (line.isSet(markedOption)) {
        Output output(line.value(markedOption));
        writePicture(markedPicture(difference, expected.picture), output, format);
    }
    return difference.differing() > 0 ? ExitCode::FallsShort : ExitCode::Done;
}

} // namespace pixelplumb::cli
