// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
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
    return verdict == Difference::None ? u"same"_s : nameOf(verdict);
}

} // namespace

QStringList diffLines(const PictureDiff &diff)
{
    QStringList counts;
    for (const Difference verdict : allDifferences) {
        if (verdict == Difference::None || diff.count(verdict) > 0)
            counts.append(u"%1 %2"_s.arg(diff.count(verdict)).arg(wordOf(verdict)));
    }
    QString text
        = u"%1 × %2 pixels: %3"_s.arg(diff.width).arg(diff.height).arg(counts.join(u", "_s));
    if (diff.largestError > 0)
        text += u"; largest channel difference %1"_s.arg(diff.largestError);
    QStringList lines = {text};
    constexpr qsizetype mostCauses = 3;
    for (const PictureCause &cause : diff.causes) {
        if (lines.size() > mostCauses)
            break;
        lines.append(cause.left == 0 ? u"explained wholly by: %1"_s.arg(cause.name)
                                     : u"explained but for %1 by: %2"_s.arg(pixelsText(cause.left),
                                                                            cause.name));
    }
    return lines;
}

QJsonObject diffJson(const PictureDiff &diff)
{
    QJsonObject object{{u"width"_s, diff.width},
                       {u"height"_s, diff.height},
                       {u"largestError"_s, diff.largestError}};
    for (const Difference verdict : allDifferences)
        object.insert(wordOf(verdict), qint64(diff.count(verdict)));
    QJsonArray causes;
    for (const PictureCause &cause : diff.causes)
        causes.append(QJsonObject{{u"cause"_s, cause.name}, {u"left"_s, qint64(cause.left)}});
    object.insert(u"causes"_s, causes);
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
    const QString formats = pictureFormatsText() + u", or a scene as a JSON object: {…}"_s;
    const QByteArray text = withoutByteOrderMark(content).trimmed();
    if (text.startsWith('['))
        refuse({path, u"a list in JSON is no scene"_s, formats});
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
    const QString option = u"background"_s;
    if (line.isSet(option)) {
        if (const auto colour = parseColour(line.value(option)))
            return colour->colour;
        refuse({u"--background"_s, u"“%1” is no colour"_s.arg(line.value(option)), u"#rrggbb"_s});
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
    const QString markedOption = u"output"_s;
    const QString rasterOption = u"ascii"_s;
    const QString what = u"a picture (PNG, PPM, BMP), a raster of # and ., or a scene"_s;
    CommandLine line(command, {{u"EXPECTED"_s, what}, {u"FOUND"_s, what}});
    line.addOption(
        {{u"o"_s, markedOption},
         u"Write a picture, too: what was expected, faint, with the pixels that differ in the "
         "colours of the manual."_s,
         u"file"_s});
    line.addOption(
        {rasterOption,
         u"Print a raster, too: # the same, ? missing, ! extra, c another colour, = undecidable."_s});
    line.addOption(
        {u"background"_s,
         u"What is not drawn has this colour; if left out, the scene's, else that of most corners "
         "of the picture."_s,
         u"#rrggbb"_s});
    addMarginOptions(line);
    line.addJsonOption();
    line.parse(arguments);
    const auto format = pictureFormatOf(line, markedOption);
    refuseStandardOutput(line.value(markedOption), u"a file"_s);
    if (line.isSet(rasterOption) && line.asksForJson())
        refuse(u"--ascii and --json: a raster is no JSON; expected one of them"_s);
    const Margin margin = chosenMargin(line);
    if (line.argument(0) == u"-"_s && line.argument(1) == u"-"_s)
        refuse(u"standard input can be only one of the two"_s);
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
            sayLine(path + u": "_s + transparencyText());
    }
    const PictureDiff difference
        = differenceOf(expected.picture, found.picture, undecidableOf(expected, found, margin));
    const std::int64_t twice = drawnTwiceIn(expected, found);
    if (line.asksForJson()) {
        QJsonObject object = diffJson(difference);
        object.insert(u"drawnTwice"_s, qint64(twice));
        object.insert(u"transparencyIgnored"_s,
                      expected.picture.isTransparent || found.picture.isTransparent);
        printJson(object);
    } else {
        printLines(diffLines(difference));
        if (twice > 0)
            printLine(
                u"drawn twice: %1 pixels are blended once more than the fill rule says, as on "
                "edges that two triangles share"_s.arg(twice));
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
