// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/livefigures.h"

#include "core/frame/framebuffer.h"
#include "core/measure/stopwatch.h"
#include "core/methods/method.h"
#include "core/runs/scenepicture.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr double liveSampleNanoseconds = 5e6;
constexpr double mostLiveNanoseconds = 200e6; ///< of timing
constexpr int mostLiveRounds = 7;

std::int64_t pixelsOf(const Primitives &primitives, const ScanSettings &settings,
                      const FrameSpec &spec)
{
    // Every pixel that the method writes, each once: kernels write opaque ones.
    const FrameBuffer frame(spec);
    const FrameView view = frame.view();
    for (std::int64_t y = view.firstRow; y < view.endRow(); ++y)
        std::fill_n(view.at(view.firstColumn, y), view.width, 0U);
    methodNamed(u"column-scan")->drawFastest(primitives, settings, view);
    std::int64_t pixels = 0;
    for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
        const QRgb *const row = view.at(view.firstColumn, y);
        pixels += view.width - std::count(row, row + view.width, 0U);
    }
    return pixels;
}

} // namespace

QString LiveFigures::text() const
{
    QString wrong = QStringLiteral("truth not known");
    if (isProved)
        wrong = QStringLiteral("0 wrong, proved");
    else if (wrongPixels)
        wrong = QStringLiteral("%1 wrong of %2 px").arg(*wrongPixels).arg(pixels);
    if (!perPixel)
        return wrong;
    return wrong + QStringLiteral(" · %1 ns/px").arg(perPixel->median, 0, 'f', 2);
}

std::optional<LiveFigures> liveFiguresOf(const std::shared_ptr<const Scene> &scene,
                                         const ProgressListener &listener)
{
    const Method &method = *methodNamed(QString::fromStdString(scene->method));
    LiveFigures figures;
    ScenePicture picture(scene->frame);
    if (!picture.draw(scene, listener))
        return std::nullopt;
    figures.isProved = method.isStableIn(scene->settings.arithmetic);
    if (figures.isProved)
        figures.wrongPixels = 0;
    else if (picture.exactTwin())
        figures.wrongPixels = picture.differences().total();

    const Primitives primitives = primitivesOnSamples(*scene);
    const ScanSettings closest = methodNamed(u"column-scan")->adapted(scene->settings);
    figures.pixels = pixelsOf(primitives, {Arithmetic::Exact, closest.fillRule, closest.rounding},
                              scene->frame);
    if (figures.pixels == 0 || !method.draws(PrimitiveKind::Triangle))
        return figures;
    const FrameBuffer frame(scene->frame);
    std::vector<double> samples;
    const Stopwatch all;
    while (samples.size() < mostLiveRounds && all.elapsed().wall < mostLiveNanoseconds) {
        if (!goesOn(listener, {JobPhase::Measuring, std::int64_t(samples.size()), mostLiveRounds}))
            return std::nullopt;
        const Stopwatch stopwatch;
        int draws = 0;
        do {
            method.drawFastest(primitives, scene->settings, frame.view());
            ++draws;
        } while (stopwatch.elapsed().wall < liveSampleNanoseconds);
        samples.push_back(stopwatch.elapsed().wall / draws / double(figures.pixels));
    }
    figures.perPixel = spreadOf(samples);
    figures.rounds = int(samples.size());
    return figures;
}

} // namespace pixelplumb
