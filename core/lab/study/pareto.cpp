// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/pareto.h"

#include <algorithm>

namespace pixelplumb {

namespace {

using Figures = AccuracyFigures;

std::optional<double> share(std::int64_t count, const Figures &figures)
{
    if (figures.pixels == 0)
        return std::nullopt;
    return LabShare{count, figures.pixels}.perMillion();
}

constexpr ErrorAxis axes[] = {
    {"wrong-pixels", QT_TRANSLATE_NOOP("core", "wrong pixels"), "ppm",
     [](const Figures &figures) { return share(figures.wrongPixels(), figures); }},
    {"wrong-coverage", QT_TRANSLATE_NOOP("core", "wrong coverage"), "ppm",
     [](const Figures &figures) { return share(figures.wrongCoverage(), figures); }},
    {"wrong-bytes", QT_TRANSLATE_NOOP("core", "wrong colours"), "ppm",
     [](const Figures &figures) { return share(figures.wrongBytes, figures); }},
    {"byte-error", QT_TRANSLATE_NOOP("core", "largest error of a byte"),
     QT_TRANSLATE_NOOP("core", "levels"),
     [](const Figures &figures) -> std::optional<double> { return figures.largestByteError; }},
    {"level-max", QT_TRANSLATE_NOOP("core", "largest error before rounding"), "levels",
     [](const Figures &figures) -> std::optional<double> {
         return figures.levels ? std::optional(figures.levels->largest) : std::nullopt;
     }},
    {"level-rms", QT_TRANSLATE_NOOP("core", "RMS error before rounding"), "levels",
     [](const Figures &figures) -> std::optional<double> {
         return figures.levels ? std::optional(figures.levels->rms) : std::nullopt;
     }},
    {"miss-distance", QT_TRANSLATE_NOOP("core", "farthest missed sample"), "px",
     [](const Figures &figures) -> std::optional<double> {
         return std::max(figures.farthestMissing, figures.farthestExtra);
     }},
};

/// From the worst class to the best.
int rankOf(ErrorClass errorClass) { return int(errorClass); }

bool isAsExact(const ParetoPoint &a, const ParetoPoint &b)
{
    if (a.errorClass != b.errorClass)
        return rankOf(a.errorClass) > rankOf(b.errorClass);
    return a.error <= b.error;
}

} // namespace

std::span<const ErrorAxis> errorAxes() { return axes; }

const ErrorAxis *errorAxisNamed(const QString &id)
{
    const auto *const found = std::ranges::find_if(
        axes, [&](const ErrorAxis &axis) { return id == QLatin1String(axis.id); });
    return found == std::end(axes) ? nullptr : found;
}

bool dominates(const ParetoPoint &a, const ParetoPoint &b)
{
    const bool isAsCheap = a.cost.median <= b.cost.median;
    if (a.kernel != b.kernel || !isAsCheap || !isAsExact(a, b))
        return false;
    return a.cost.median < b.cost.median || !isAsExact(b, a);
}

std::vector<std::size_t> ParetoChart::frontier(LabKernel kernel) const
{
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].isOnFrontier && points[i].kernel == kernel)
            indices.push_back(i);
    }
    std::ranges::stable_sort(indices, {}, [this](std::size_t i) { return points[i].cost.median; });
    return indices;
}

std::vector<StaircaseCorner> ParetoChart::staircase(LabKernel kernel) const
{
    std::vector<StaircaseCorner> corners;
    for (const std::size_t index : frontier(kernel)) {
        const ParetoPoint &point = points[index];
        if (!corners.empty()) {
            StaircaseCorner above = corners.back();
            above.cost = point.cost.median;
            corners.push_back(above);
        }
        corners.push_back({point.cost.median, point.errorClass, point.error});
    }
    return corners;
}

namespace {

ErrorClass classOf(double error, const StudyContender &contender)
{
    if (error > 0)
        return ErrorClass::Positive;
    if (!contender.isProved)
        return ErrorClass::ZeroObserved;
    return contender.kernel == LabKernel::Fast ? ErrorClass::ZeroTested : ErrorClass::ZeroProved;
}

} // namespace

ParetoChart paretoOf(const Study &study, const QString &family, const ErrorAxis &axis)
{
    ParetoChart chart;
    chart.family = family;
    chart.axis = QString::fromLatin1(axis.id);
    const StudyFamily *drawn = study.family(family);
    if (!drawn)
        return chart;
    const LabRow *reference = study.row(QLatin1String(referenceContenderId), family);
    for (const StudyContender &contender : study.contenders) {
        const LabRow *row = study.row(contender.id, family);
        const auto error
            = row && row->accuracy ? axis.read(*row->accuracy) : std::optional<double>();
        if (!error)
            continue;
        ParetoPoint point;
        point.contender = contender.id;
        point.label = contender.label;
        point.kernel = contender.kernel;
        point.error = *error;
        point.errorClass = classOf(*error, contender);
        point.pixels = row->accuracy->pixels;
        if (drawn->timedPixels == 0 || !row->cost || row->cost->rounds == 0) {
            chart.untimed.push_back(std::move(point));
            continue;
        }
        const double perPixel = 1 / double(drawn->timedPixels);
        point.cost = scaled(row->cost->perDraw, perPixel);
        if (reference && reference->cost && reference->cost->rounds > 0)
            point.timesReference = row->cost->perDraw.median / reference->cost->perDraw.median;
        if (row->cost->straight)
            point.straight = scaled(*row->cost->straight, perPixel);
        point.missesStraight = row->missesStraight();
        chart.points.push_back(std::move(point));
    }
    for (ParetoPoint &point : chart.points) {
        point.isOnFrontier = point.kernel != LabKernel::Peer
            && std::ranges::none_of(chart.points, [&](const ParetoPoint &other) {
                                 return dominates(other, point);
                             });
    }
    return chart;
}

} // namespace pixelplumb
