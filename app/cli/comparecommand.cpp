// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "core/compare/contest.h"
#include "core/scene/files/inputrecord.h"

#include <QImage>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

QRgb colourOf(Disagreement reason)
{
    switch (reason) {
    case Disagreement::TieRule:
        return qRgb(230, 159, 0);
    case Disagreement::Undrawn:
        return qRgb(128, 128, 128);
    case Disagreement::Rounding:
        return qRgb(240, 228, 66);
    case Disagreement::Drift:
        return qRgb(86, 180, 233);
    case Disagreement::Precision:
        return qRgb(213, 94, 0);
    case Disagreement::Method:
        return qRgb(204, 121, 167);
    case Disagreement::NotRecorded:
    case Disagreement::None:
        break;
    }
    return qRgb(0, 0, 0);
}

/// The first contender's picture, faint and grey. Pixels on which not all agree have the colour of
/// the reason (Okabe and Ito's palette): orange a tie rule, grey an undrawn kind, yellow rounding,
/// sky blue drift, vermilion precision, purple the method, black not recorded.
QImage pictureOf(const Contest &contest)
{
    const AgreementMap &agreement = contest.agreement;
    const FrameSpec &frame = agreement.spec();
    const WrittenFrame &first = contest.runs.front().picture;
    QImage picture(frame.width, frame.height, QImage::Format_RGB32);
    for (int line = 0; line < picture.height(); ++line) {
        auto *pixels = reinterpret_cast<QRgb *>(picture.scanLine(line));
        const std::int64_t y = rowOfPictureLine(frame, line);
        for (int column = 0; column < picture.width(); ++column) {
            const std::int64_t x = frame.firstColumn + column;
            const bool agree = agreement.agreeingAt(x, y) == agreement.contenderCount();
            const Colour shown = first.isWritten(x, y) ? first.colourAt(x, y) : frame.background;
            pixels[column] = agree ? faint(shown) : colourOf(agreement.reasonAt(x, y));
        }
    }
    return picture;
}

} // namespace

ExitCode compare(const Command &command, const QStringList &arguments)
{
    const QString methodsOption = u"methods"_s;
    const QString limitOption = u"limit"_s;
    const QString drawingOption = u"output"_s;
    CommandLine line(command, {scenePositional()});
    line.addOption(
        {methodsOption,
         u"Two to four of method[:arithmetic[:fill-rule[:variant…]]] and truth[:fill-rule], "
         "separated by commas; what is left out is the scene's."_s,
         u"list"_s});
    line.addOption(
        {limitOption, u"List this many differing pixels; 20 if left out."_s, u"count"_s, u"20"_s});
    line.addOption(
        {{u"o"_s, drawingOption},
         u"Write a picture, too: PNG, BMP or PPM by the name's extension. It is the first "
         "method's, faint, with differing pixels in the colours that the manual lists."_s,
         u"file"_s});
    line.addJsonOption();
    addSettingOptions(line);
    line.parse(arguments);
    if (!line.isSet(methodsOption))
        refuse(u"--methods is missing; expected a list such as "
               "column-scan:exact,column-scan:float32,truth"_s);
    const auto limit = wholeNumberOf(line, limitOption, {});
    const auto format = pictureFormatOf(line, drawingOption);
    refuseStandardOutput(line.value(drawingOption), u"a file"_s);
    const SceneRun run = readScene(line, line.argument(0));
    const Scene &scene = run.scene;
    const std::vector<Contender> contenders
        = contendersNamed(line.value(methodsOption), scene.settings);
    std::vector<SceneRun> runs;
    for (const Contender &contender : contenders) {
        if (contender.isTruth())
            continue;
        runs.emplace_back(sceneFor(scene, contender), run.primitives);
        refuseIf(refusalOf(runs.back(), u"--methods"_s));
    }

    if (line.isSet(drawingOption))
        refuseIf(refusalToWrite(line.value(drawingOption)));
    const auto contest = withProgress([&](const ProgressListener &listener) {
        ContestOptions options;
        options.progress = listener;
        return compareContenders(scene, contenders, options);
    });
    for (const SceneRun &each : runs)
        reportRejections(line.argument(0) + u", "_s + Contender{each.method, each.settings}.name(),
                         rejectedPrimitives(each));

    const CompareReport report{*contest, std::size_t(limit.value())};
    line.asksForJson() ? printJson(compareJson(report)) : printLines(compareLines(report));
    if (line.isSet(drawingOption)) {
        Output output(line.value(drawingOption));
        writePicture(pictureOf(*contest), output, format);
    }
    const bool agree = contest->agreement.differing() == 0
        && std::ranges::none_of(contest->carried,
                                [](const CarriedAgreement &each) { return each.differing > 0; });
    return agree ? ExitCode::Done : ExitCode::FallsShort;
}

} // namespace pixelplumb::cli
