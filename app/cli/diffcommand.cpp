// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/diffreport.h"
#include "app/cli/input.h"
#include "app/cli/marginoptions.h"
#include "app/cli/picturefile.h"
#include "app/cli/sceneoptions.h"
#include "core/grade/drawntwice.h"
#include "core/grade/undecidable.h"
#include "core/scene/colourtext.h"

namespace pixelplumb::cli {

namespace {

/// A side of the comparison: a picture, and the scene where it is one.
struct Side {
    Picture picture;
    std::optional<Scene> scene;
};

/// Reads a side; an input that is a JSON object is a scene.
Result<Side> readSide(const QString &path)
{
    const Result<QByteArray> content = readInput(path, largestPictureFile);
    if (!content)
        return content.error();
    const QString formats
        = pictureFormatsText() + QStringLiteral(", or a scene as a JSON object: {…}");
    const QByteArray text = content->trimmed();
    if (text.startsWith('['))
        return InputError{path, QStringLiteral("a list in JSON is no scene"), formats};
    if (!text.startsWith('{')) {
        Result<Picture> picture = parsePicture(*content, path, formats);
        if (!picture)
            return picture.error();
        return Side{std::move(*picture), std::nullopt};
    }
    const Result<SceneReading> reading = sceneIn(*content, path);
    if (!reading)
        return reading.error();
    const Scene &scene = reading->scene;
    if (const auto refusal = refusalOf(scene, path))
        return *refusal;
    return Side{pictureOf(scene), scene};
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
Result<Colour> backgroundFor(const CommandLine &line, const Side &expected, const Side &found)
{
    const QString option = QStringLiteral("background");
    if (line.isSet(option)) {
        if (const auto colour = parseColour(line.value(option)))
            return colour->colour;
        return InputError{QStringLiteral("--background"),
                          QStringLiteral("“%1” is no colour").arg(line.value(option)),
                          QStringLiteral("#rrggbb")};
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
    const QString asciiOption = QStringLiteral("ascii");
    const QString jsonOption = QStringLiteral("json");
    const QString what
        = QStringLiteral("a picture (PNG, PPM, BMP), a raster of # and ., or a scene");
    CommandLine line(command,
                     {{QStringLiteral("EXPECTED"), what}, {QStringLiteral("FOUND"), what}});
    line.addOption({{QStringLiteral("o"), markedOption},
                    QStringLiteral("Write a picture, too: what was expected, faint, with the "
                                   "pixels that differ in the colours of the manual."),
                    QStringLiteral("file")});
    line.addOption({asciiOption,
                    QStringLiteral("Print a raster, too: # the same, ? missing, ! extra, c another "
                                   "colour, = undecidable.")});
    line.addOption({QStringLiteral("background"),
                    QStringLiteral("What is not drawn has this colour; if left out, the scene's, "
                                   "else that of most corners of the picture."),
                    QStringLiteral("#rrggbb")});
    addMarginOptions(line);
    line.addOption({jsonOption, QStringLiteral("Print JSON.")});
    if (const auto ended = line.parse(arguments))
        return *ended;
    const auto format = pictureFormatOf(line, markedOption);
    if (!format)
        return line.refuse(format.error());
    if (const auto refusal
        = refusalOfStandardOutput(line.value(markedOption), QStringLiteral("a file")))
        return line.refuse(*refusal);
    if (line.isSet(asciiOption) && line.isSet(jsonOption))
        return line.refuse(QStringLiteral("--ascii and --json: a raster is no JSON; expected one "
                                          "of them"));
    const Result<Margin> margin = chosenMargin(line);
    if (!margin)
        return line.refuse(margin.error());
    if (line.argument(0) == QStringLiteral("-") && line.argument(1) == QStringLiteral("-"))
        return line.refuse(QStringLiteral("standard input can be only one of the two"));
    Result<Side> expected = readSide(line.argument(0));
    if (!expected)
        return line.refuse(expected.error());
    Result<Side> found = readSide(line.argument(1));
    if (!found)
        return line.refuse(found.error());
    const auto sizeOf = [](const Picture &picture) { return QSize(picture.width, picture.height); };
    if (const auto refusal = refusalOfSizes({line.argument(0), sizeOf(expected->picture)},
                                            {line.argument(1), sizeOf(found->picture)}))
        return *refusal;
    const Result<Colour> background = backgroundFor(line, *expected, *found);
    if (!background)
        return line.refuse(background.error());
    for (Side *side : {&*expected, &*found}) {
        if (!side->scene && side->picture.hasColours)
            coverAllBut(*background, side->picture);
    }
    for (const auto &[path, side] :
         {std::pair(line.argument(0), &*expected), std::pair(line.argument(1), &*found)}) {
        if (side->picture.isTransparent)
            sayLine(path + QStringLiteral(": ") + transparencyText());
    }
    const PictureDiff difference = differenceOf(expected->picture, found->picture,
                                                undecidableOf(*expected, *found, *margin));
    const std::int64_t twice = drawnTwiceIn(*expected, *found);
    if (line.isSet(jsonOption)) {
        QJsonObject object = jsonOf(difference);
        object.insert(QStringLiteral("drawnTwice"), qint64(twice));
        object.insert(QStringLiteral("transparencyIgnored"),
                      expected->picture.isTransparent || found->picture.isTransparent);
        printJson(QJsonDocument(object));
    } else {
        printLines(textOf(difference));
        if (twice > 0)
            printLine(QStringLiteral("drawn twice: %1 pixels are blended once more than the fill "
                                     "rule says, as on edges that two triangles share")
                          .arg(twice));
        if (line.isSet(asciiOption))
            printLines(rasterOf(difference, expected->picture).chopped(1).split(u'\n'));
    }
    if (line.isSet(markedOption)) {
        Output output(line.value(markedOption));
        if (const auto error
            = writePicture(markedPicture(difference, expected->picture), output, *format))
            return line.refuse(*error);
    }
    return difference.differing() > 0 ? ExitCode::FallsShort : ExitCode::Done;
}

} // namespace pixelplumb::cli
