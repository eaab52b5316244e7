// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/scenecost.h"

#include "core/frame/framebuffer.h"
#include "core/lab/study/familyaccuracy.h"
#include "core/lab/study/labrace.h"
#include "core/measure/stopwatch.h"
#include "core/methods/method.h"
#include "core/number/failure.h"

namespace pixelplumb {

namespace {

constexpr double mostNanoseconds = 200e6; ///< of timing
constexpr int mostRounds = 7;

} // namespace

QString SceneCost::text() const
{
    return QStringLiteral(QT_TRANSLATE_NOOP("core", "plain kernel %1 ns a pixel"))
        .arg(perPixel.median, 0, 'f', 2);
}

QString SceneCost::details() const
{
    const auto number = [](double value) { return QString::number(value, 'f', 2); };
    return u"The time is that of the plain kernel, the one that is stepped through, "
           "on one thread:\nmedian of %1 rounds %2 ns a pixel, the middle half %3 … "
           "%4, over %5 px of triangles, each as often as it is written."_s.arg(rounds)
               .arg(number(perPixel.median), number(perPixel.lower), number(perPixel.upper))
               .arg(pixels);
}

std::optional<SceneCost> costOf(const std::shared_ptr<const Scene> &scene,
                                const ProgressListener &listener)
{
    const Method &method = *methodNamed(QString::fromStdString(scene->method));
    if (!method.draws(PrimitiveKind::Triangle))
        return std::nullopt;
    FamilyRequest request;
    request.ownScene = scene;
    const auto family = makeFamily(*labFamilyNamed("own-scene"), request);
    if (!family)
        return std::nullopt;
    const TimedFamily part = timedPartOf(*family, {});
    const LabContender contender = contenderOf(method, scene->settings.arithmetic);
    const auto settings = settingsFor(contender, *family);
    const std::int64_t pixels = part.described.timedPixels;
    if (pixels == 0 || !part.isTimed() || !settings)
        return std::nullopt;
    // The study knows a draw's time from its pictures; here the first triangle gives it.
    const LabPicture &picture = family->pictures.front();
    const FrameBuffer frame(picture.frame);
    const Run first = contender.runOf({{picture.triangles.front()}, {}}, *settings, frame.view());
    const Stopwatch stopwatch;
    if (failureOf([&] { contender.draw(first, frame.view()); }))
        return std::nullopt;
    LabRace race({});
    if (!race.enter(0, contender, part, *settings,
                    stopwatch.elapsed().thread * double(part.described.timedTriangles)))
        return std::nullopt;
    const Stopwatch all;
    for (int round = 0; round < mostRounds && all.elapsed().wall < mostNanoseconds; ++round) {
        const auto hear = [&](const JobProgress &progress) {
            return goesOn(listener, {progress.phase, round, mostRounds});
        };
        if (!race.runRound(round, hear))
            return std::nullopt;
    }
    const CostFigures cost = race.results().front().cost;
    if (cost.rounds == 0)
        return std::nullopt;
    return SceneCost{pixels, scaled(cost.perDraw, 1 / double(pixels)), cost.rounds};
}

} // namespace pixelplumb
