// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/diffreport.h"
#include "app/cli/input.h"
#include "app/cli/picturefile.h"
#include "app/cli/sceneoptions.h"
#include "core/scene/colourtext.h"

namespace pixelplumb::cli {

namespace {

/// A side of the comparison: a picture, and the scene where it is one.
struct Side {
    Picture picture;
    std::optional<Scene> scene;
};

/// A scene is JSON: an object.
Result<Side> readSide(const QString &path)
{
    const Result<QByteArray> content = readInput(path);
    if (!content)
        return content.error();
    if (!content->trimmed().startsWith('{')) {
        Result<Picture> picture = parsePicture(*content, path);
        if (!picture)
            return picture.error();
        return Side{std::move(*picture), std::nullopt};
    }
    const Result<Scene> scene = sceneIn(*content, path);
    if (!scene)
        return scene.error();
    if (const auto refusal = refusalOf(*scene, path))
        return *refusal;
    return Side{pictureOf(*scene), *scene};
}

/// A scene knows its background, a raster needs none.
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
    line.addOption({jsonOption, QStringLiteral("Print JSON.")});
    if (const auto ended = line.parse(arguments))
        return *ended;
    const auto format = pictureFormatOf(line.value(markedOption), QStringLiteral("-o"));
    if (!format)
        return line.refuse(format.error());
    if (line.argument(0) == QStringLiteral("-") && line.argument(1) == QStringLiteral("-"))
        return line.refuse(QStringLiteral("standard input can be only one of the two"));
    Result<Side> expected = readSide(line.argument(0));
    if (!expected)
        return line.refuse(expected.error());
    Result<Side> found = readSide(line.argument(1));
    if (!found)
        return line.refuse(found.error());
    if (expected->picture.width != found->picture.width
        || expected->picture.height != found->picture.height) {
        sayLine(QStringLiteral("%1 has %2 × %3 pixels, %4 has %5 × %6")
                    .arg(line.argument(0))
                    .arg(expected->picture.width)
                    .arg(expected->picture.height)
                    .arg(line.argument(1))
                    .arg(found->picture.width)
                    .arg(found->picture.height));
        return ExitCode::SizesDiffer;
    }
    const Result<Colour> background = backgroundFor(line, *expected, *found);
    if (!background)
        return line.refuse(background.error());
    for (Side *side : {&*expected, &*found}) {
        if (!side->scene && side->picture.hasColours)
            coverAllBut(*background, side->picture);
    }
    const std::optional<Scene> &scene = expected->scene ? expected->scene : found->scene;
    const PictureDiff difference = differenceOf(
        expected->picture, found->picture, scene ? tiesOf(*scene) : std::vector<std::uint8_t>());
    if (line.isSet(jsonOption)) {
        printJson(QJsonDocument(jsonOf(difference)));
    } else {
        printLines(textOf(difference));
        if (line.isSet(asciiOption))
            printLine(rasterOf(difference, expected->picture).chopped(1));
    }
    if (line.isSet(markedOption)) {
        Output output(line.value(markedOption), {line.argument(0), line.argument(1)});
        if (const auto error
            = writePicture(markedPicture(difference, expected->picture), output, *format))
            return line.refuse(*error);
    }
    return difference.differing() > 0 ? ExitCode::FallsShort : ExitCode::Done;
}

} // namespace pixelplumb::cli
