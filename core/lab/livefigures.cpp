// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/livefigures.h"

#include "core/frame/framebuffer.h"
#include "core/frame/writtenframe.h"
#include "core/lab/familyaccuracy.h"
#include "core/lab/labrace.h"
#include "core/measure/stopwatch.h"
#include "core/methods/method.h"
#include "core/number/failure.h"
#include "core/runs/scenepicture.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr double mostLiveNanoseconds = 200e6; ///< of timing
constexpr int mostLiveRounds = 7;

std::int64_t pixelsDrawn(const Scene &scene, const Method &method, const ScanSettings &settings)
{
    const WrittenFrame frame(scene.frame);
    method.drawFastest(primitivesOnSamples(scene), settings, frame.view());
    std::int64_t pixels = 0;
    const FrameView view = frame.view();
    for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
        for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x)
            pixels += frame.isWritten(x, y) ? 1 : 0;
    }
    return pixels;
}

/// Pixels of the exact picture: for triangles the column scan's, which accepts all rules, for other
/// primitives the method's own.
std::int64_t pixelsOf(const Scene &scene, const Method &method)
{
    const Method &drawing
        = method.draws(PrimitiveKind::Triangle) ? *methodNamed(u"column-scan") : method;
    ScanSettings exact = scene.settings;
    exact.arithmetic = Arithmetic::Exact;
    exact.variants = {};
    return pixelsDrawn(scene, drawing, drawing.adapted(exact));
}

/// Times the scene like the study's family own-scene: the same triangles by the plain kernel, in
/// the same samples. False if the listener ended it.
bool addTimes(LiveFigures &figures, const std::shared_ptr<const Scene> &scene, const Method &method,
              const ProgressListener &listener)
{
    FamilyRequest request;
    request.ownScene = scene;
    const auto family = makeFamily(*labFamilyNamed(QStringLiteral("own-scene")), request);
    if (!family)
        return true;
    const RaceOptions options;
    const TimedFamily part = timedPartOf(*family, {});
    const LabContender contender = contenderOf(method, scene->settings.arithmetic);
    const auto settings = settingsFor(contender, *family);
    figures.timedPixels = part.described.timedPixels;
    if (!part.isTimed() || !settings)
        return true;
    // The study knows a draw's time from its pictures; here the first triangle gives it.
    const LabPicture &picture = family->pictures.front();
    const FrameBuffer frame(picture.frame);
    const Stopwatch stopwatch;
    if (failureOf([&] {
            contender.draw({{picture.triangles.front()}, {}}, *settings, frame.view());
        }))
        return true;
    LabRace race(options);
    if (!race.enter(0, contender, part, *settings,
                    stopwatch.elapsed().thread * double(part.described.timedTriangles)))
        return true;
    const Stopwatch all;
    for (int round = 0; round < mostLiveRounds && all.elapsed().wall < mostLiveNanoseconds;
         ++round) {
        const auto hear = [&](const JobProgress &progress) {
            return goesOn(listener, {progress.phase, round, mostLiveRounds});
        };
        if (!race.runRound(round, hear))
            return false;
    }
    const CostFigures cost = race.results().front().cost;
    figures.rounds = cost.rounds;
    if (cost.rounds > 0)
        figures.perPixel = scaled(cost.perDraw, 1 / double(figures.timedPixels));
    return true;
}

} // namespace

QString LiveFigures::text() const
{
    if (pixels == 0 && wrongPixels.value_or(0) == 0)
        return QStringLiteral("nothing to measure yet");
    if (!wrongPixels)
        return QStringLiteral("truth not known");
    if (*wrongPixels == 0)
        return QStringLiteral("When finished: all pixels correct");
    return QStringLiteral("When finished: %1 px wrong, truth %2 px").arg(*wrongPixels).arg(pixels);
}

QString LiveFigures::timeText() const
{
    if (!perPixel)
        return {};
    return QStringLiteral("plain kernel %1 ns a pixel").arg(perPixel->median, 0, 'f', 2);
}

QString LiveFigures::details() const
{
    QString shown = text();
    if (isProved && pixels > 0 && wrongPixels == 0)
        shown += QStringLiteral("\nThe method is proved to draw every pixel right.");
    if (!perPixel)
        return shown;
    const auto number = [](double value) { return QString::number(value, 'f', 2); };
    return shown
        + QStringLiteral("\nThe time is that of the plain kernel, the one that is stepped through, "
                         "on one thread:\nmedian of %1 rounds %2 ns a pixel, the middle half "
                         "%3 … %4, over %5 px of triangles, each as often as it is written.")
              .arg(rounds)
              .arg(number(perPixel->median), number(perPixel->lower), number(perPixel->upper))
              .arg(timedPixels);
}

std::optional<LiveFigures> liveFiguresOf(const std::shared_ptr<const Scene> &scene,
                                         const ProgressListener &listener)
{
    const Method &method = *methodNamed(QString::fromStdString(scene->method));
    LiveFigures figures;
    ScenePicture picture(scene->frame);
    if (!picture.draw(scene, listener))
        return std::nullopt;
    figures.isProved = method.isStableUnder(scene->settings);
    if (figures.isProved)
        figures.wrongPixels = 0;
    else if (picture.exactTwin())
        figures.wrongPixels = picture.differences().total();

    figures.pixels = pixelsOf(*scene, method);
    if (figures.pixels > 0 && method.draws(PrimitiveKind::Triangle)
        && !addTimes(figures, scene, method, listener))
        return std::nullopt;
    return figures;
}

std::optional<LiveFigures> liveFiguresOf(const std::shared_ptr<const TracedScene> &traced,
                                         const ProgressListener &listener)
{
    auto figures = liveFiguresOf(std::shared_ptr<const Scene>(traced, &traced->scene), listener);
    const DifferenceMap &differences = traced->differences;
    // A proof about a method's picture says nothing of primitives that it refuses to draw.
    if (!figures || (figures->wrongPixels && !(figures->isProved && differences.total() > 0)))
        return figures;
    figures->isProved = false;
    figures->wrongPixels = differences.total();
    const Scene &drawn = traced->scene;
    // The exact picture of a method that draws no triangles need not be the true one.
    if (!traced->method->draws(PrimitiveKind::Triangle))
        figures->pixels = pixelsDrawn(drawn, *traced->method, drawn.settings)
            - differences.count(Difference::Extra) + differences.count(Difference::Missing);
    return figures;
}

} // namespace pixelplumb
