// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/sizestudy.h"

#include "core/frame/framebuffer.h"
#include "core/lab/drawsample.h"
#include "core/lab/familyshapes.h"
#include "core/number/failure.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pixelplumb {

namespace {

constexpr double sizedSampleNanoseconds = 1e6;

FrameSpec frameOf(std::int32_t width, std::int32_t height)
{
    FrameSpec spec;
    spec.width = width;
    spec.height = height;
    return spec;
}

/// A triangle of a box from (2, 2), its third vertex over the first third of its width.
Triangle triangleOf(std::int64_t width, std::int64_t height)
{
    return {{{{latticePixel(2, 2), {{255, 0, 0}}},
              {latticePixel(2 + width, 3), {{0, 255, 0}}},
              {latticePixel(2 + width / 3, 2 + height), {{0, 0, 255}}}}}};
}

/// What is drawn at one size.
struct SizedWork {
    double size = 0;
    FrameSpec frame;
    Primitives primitives;
};

std::vector<SizedWork> workAlong(SizeAxis axis)
{
    // Primes, each about twice the one before.
    static constexpr std::int32_t sides[] = {13, 29, 61, 127, 251, 509, 1021};
    std::vector<SizedWork> works;
    for (const std::int32_t side : sides) {
        SizedWork work;
        switch (axis) {
        case SizeAxis::Width:
            work.frame = frameOf(1031, 37);
            work.size = side;
            work.primitives.triangles = {triangleOf(side, 31)};
            break;
        case SizeAxis::Area:
            work.frame = frameOf(1031, 1031);
            work.size = double(side) * side / 2;
            work.primitives.triangles = {triangleOf(side, side)};
            break;
        case SizeAxis::Triangles: {
            work.frame = frameOf(251, 241);
            work.size = side;
            SeededRandom random(7);
            work.primitives.triangles
                = familyshapes::boxed(random, work.frame, std::size_t(side), 5, 13, unitsPerPixel);
            break;
        }
        }
        works.push_back(std::move(work));
    }
    return works;
}

/// One who draws at all sizes of an axis.
struct SizedContender {
    std::vector<std::vector<double>> samples; ///< by size, ns a draw
    std::vector<int> draws; ///< by size, of a sample

    explicit SizedContender(std::size_t sizes)
        : samples(sizes)
        , draws(sizes)
    {
    }
};

} // namespace

QString nameOf(SizeAxis axis)
{
    switch (axis) {
    case SizeAxis::Width:
        return QStringLiteral("width");
    case SizeAxis::Area:
        return QStringLiteral("area");
    case SizeAxis::Triangles:
        return QStringLiteral("triangles");
    }
    return {};
}

std::vector<LabContender> growingContenders()
{
    static constexpr const char *ids[]
        = {"column-scan:exact",   "column-scan:exact:fast", "column-scan:float32",
           "column-scan:float64", "column-scan:fixed16.16", "column-scan:fixed32.32",
           "row-walk:float32"};
    std::vector<LabContender> contenders;
    for (const char *id : ids)
        contenders.push_back(*labContenderNamed(QLatin1String(id)));
    return contenders;
}

std::optional<double> fittedExponent(std::span<const SizePoint> points)
{
    double count = 0, sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
    for (const SizePoint &point : points) {
        const double x = std::log(point.size), y = std::log(point.perDraw.median);
        count += 1;
        sumX += x;
        sumY += y;
        sumXX += x * x;
        sumXY += x * y;
    }
    const double spread = count * sumXX - sumX * sumX;
    if (points.size() < 2 || spread == 0)
        return std::nullopt;
    return (count * sumXY - sumX * sumY) / spread;
}

std::optional<std::vector<SizeCurve>> runSizeStudy(const std::vector<LabContender> &contenders,
                                                   int rounds, const ProgressListener &listener)
{
    std::vector<SizeCurve> curves;
    std::set<QString> failed;
    const std::int64_t all = std::int64_t(allSizeAxes.size()) * rounds;
    std::int64_t done = 0;
    for (const SizeAxis axis : allSizeAxes) {
        const std::vector<SizedWork> works = workAlong(axis);
        std::vector<SizedContender> sized(contenders.size(), SizedContender(works.size()));
        for (int round = 0; round < rounds; ++round, ++done) {
            for (std::size_t at = 0; at < works.size(); ++at) {
                const FrameBuffer frame(works[at].frame);
                for (std::size_t turn = 0; turn < contenders.size(); ++turn) {
                    if (!goesOn(listener, {JobPhase::Measuring, done, all}))
                        return std::nullopt;
                    const std::size_t who = (turn + std::size_t(round)) % contenders.size();
                    const LabContender &contender = contenders[who];
                    const ScanSettings settings = contender.settingsUnder(FillRule::Closed);
                    const auto draw
                        = [&] { contender.draw(works[at].primitives, settings, frame.view()); };
                    const auto sample = [&] {
                        sized[who].samples[at].push_back(
                            sampleDraw(draw, sized[who].draws[at], sizedSampleNanoseconds));
                    };
                    if (!failed.contains(contender.id) && failureOf(sample))
                        failed.insert(contender.id);
                }
            }
        }
        for (std::size_t who = 0; who < contenders.size() && rounds > 0; ++who) {
            if (failed.contains(contenders[who].id))
                continue;
            SizeCurve curve{contenders[who].id, axis, {}, {}};
            for (std::size_t at = 0; at < works.size(); ++at)
                curve.points.push_back({works[at].size, spreadOf(sized[who].samples[at])});
            curve.exponent
                = fittedExponent(std::span(curve.points).last((curve.points.size() + 1) / 2));
            curves.push_back(std::move(curve));
        }
    }
    std::erase_if(curves, [&](const SizeCurve &curve) { return failed.contains(curve.contender); });
    return curves;
}

} // namespace pixelplumb
