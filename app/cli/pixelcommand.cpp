// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "core/check/casepicture.h"
#include "core/runs/undrawn.h"

namespace pixelplumb::cli {

namespace {

Colour finalColour(const FrameSpec &frame, const std::vector<PixelAttempt> &attempts)
{
    Colour colour = frame.background;
    for (const PixelAttempt &attempt : attempts) {
        if (attempt.written)
            colour = unpacked(attempt.change.after);
    }
    return colour;
}

Colour trueColourOfAll(const TracedScene &traced, std::int64_t x, std::int64_t y)
{
    if (traced.drawsAll())
        return unpacked(*traced.truth.view().at(x, y));
    FrameSpec pixel = traced.scene.frame;
    pixel.width = pixel.height = 1;
    pixel.firstColumn = int(x);
    pixel.firstRow = int(y);
    const FrameBuffer frame(pixel);
    FrameView view = frame.view();
    // The default off-screen point is that of the whole frame.
    view.offScreenPoint = traced.truth.view().offScreenPoint;
    drawTruly(traced.primitives, traced.scene.settings, view);
    return unpacked(*view.at(x, y));
}

PixelReport reportOf(const TracedScene &traced, BriefPixelHistory history, std::int64_t x,
                     std::int64_t y)
{
    PixelReport report{traced, x, y, std::move(history), {}, {}, {}, {}};
    report.colour = finalColour(traced.scene.frame, report.history.attempts);
    report.truth = unpacked(*traced.truth.view().at(x, y));
    report.truthOfAll = trueColourOfAll(traced, x, y);
    report.undrawn
        = undrawnAt(traced.primitives, *traced.method, boundaryRuleOf(traced.scene), x, y);
    return report;
}

/// Of many primitives those whose box does not hold the pixel are only counted.
BriefPixelHistory shownHistory(const TracedScene &traced, std::int64_t x, std::int64_t y)
{
    const std::size_t all = traced.primitives.size();
    return briefPixelHistory(traced, x, y, {all, all > fewRefusals ? 0 : all});
}

} // namespace

ExitCode pixel(const Command &command, const QStringList &arguments)
{
    CommandLine line(command,
                     {scenePositional(),
                      {u"X"_s, u"the pixel's column"_s},
                      {u"Y"_s, u"the pixel's row, counted as the scene does"_s}});
    line.addJsonOption();
    addSettingOptions(line);
    line.parse(arguments);
    SceneRun run = readScene(line, line.argument(0));
    const FrameSpec frame = run.scene.frame;
    const auto along = [](std::int64_t first, std::int64_t size) {
        return WholeRange{first, first + size - 1, u"outside the frame"_s};
    };
    const auto x = wholeNumber(u"X"_s, line.argument(1), along(frame.firstColumn, frame.width));
    const auto y = wholeNumber(u"Y"_s, line.argument(2), along(frame.firstRow, frame.height));

    const auto traced = traceScene(std::move(run));
    reportRejections(line.argument(0) + u", "_s + traced->method->id, rejectedPrimitives(*traced));
    if (line.asksForJson())
        printJson(pixelJson(reportOf(*traced, {pixelHistory(*traced, x, y)}, x, y)));
    else
        printLines(pixelLines(reportOf(*traced, shownHistory(*traced, x, y), x, y)));
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
