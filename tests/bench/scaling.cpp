// SPDX-License-Identifier: GPL-3.0-or-later
#include "scaling.h"

#include "numbertext.h"

#include <QTextStream>

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

/// The memory of a single draw by the reference, beyond what was in use before.
std::optional<double> workingBytesOf(const std::vector<Result> &results, const QString &id)
{
    for (const Result &result : results) {
        if (result.contender->info().id != id)
            continue;
        const std::int64_t before = memoryInUse();
        if (!resetPeakMemory())
            return std::nullopt;
        result.contender->draw();
        const std::int64_t more = std::max<std::int64_t>(peakMemory() - before, 0);
        return double(more) / double(result.triangles);
    }
    return std::nullopt;
}

QString frameText(FrameSize size) { return u"%1 x %2"_s.arg(size.width).arg(size.height); }

} // namespace

std::vector<ScalingPoint> scalingPoints(Extent extent)
{
    std::vector<ScalingPoint> points;
    const bool quick = extent == Extent::Quick;
    for (std::size_t triangles = 10'000; triangles <= (quick ? 100'000U : 10'000'000U);
         triangles *= 10)
        points.push_back({{1920, 1080}, triangles, 4});
    for (int side = 64; side <= (quick ? 256 : 16384); side *= 2)
        points.push_back({{side, side}, quick ? 10'000U : 100'000U, 53});
    return points;
}

ScalingResult measureScaling(const ScalingPoint &point, const std::vector<Contender *> &contenders,
                             const QString &referenceId, const RaceOptions &options,
                             const std::function<void(const QString &)> &progress)
{
    ScalingResult scaling = {point, 0, {}, std::nullopt, {}};
    const double frameBytes = 4.0 * point.size.width * point.size.height;
    const double needed = frameBytes * double(contenders.size())
        + 2.0 * double(sizeof(Triangle)) * double(point.triangles);
    if (needed > 0.6 * double(installedMemory())) {
        scaling.skipped = u"needs %1 GiB of memory, of %2"_s.arg(needed / 0x1p30, 0, 'f', 1)
                              .arg(double(installedMemory()) / 0x1p30, 0, 'f', 1);
        return scaling;
    }
    Workload workload;
    workload.id = u"%1 triangles, %2"_s.arg(point.triangles).arg(frameText(point.size));
    workload.size = point.size;
    workload.triangles = scatteredTriangles(point.size, point.triangles, point.area, 10);
    scaling.pixelsPerTriangle
        = double(coveredSamples(workload.triangles)) / double(point.triangles);
    Forms forms(workload);
    scaling.results = race(workload, forms, contenders, options, progress);
    scaling.workingBytes = workingBytesOf(scaling.results, referenceId);
    // Frees the frames before the next size.
    for (Contender *contender : contenders)
        contender->load({{1, 1}, {}});
    return scaling;
}

QString markdown(const MachineConditions &machine, const std::vector<ScalingResult> &series)
{
    QString text;
    QTextStream out(&text);
    out << "# Scaling\n\n"
        << markdown(machine) << "\nA triangle in a scene takes " << sizeof(Triangle)
        << " bytes, a pixel 4. Own memory: what the first renderer takes beyond that while it "
           "draws.\n\n"
           "| frame | triangles | px/triangle | renderer | ns/triangle | quartiles | ns/px | own "
           "bytes/triangle |\n|---|--:|--:|---|--:|--:|--:|--:|\n";
    for (const ScalingResult &scaling : series) {
        const QString start = u"| %1 | %2 | "_s.arg(frameText(scaling.point.size),
                                                    numberText(double(scaling.point.triangles)));
        if (!scaling.skipped.isEmpty())
            out << start << "– | " << scaling.skipped << " | – | – | – | – |\n";
        for (std::size_t i = 0; i < scaling.results.size(); ++i) {
            const Result &result = scaling.results[i];
            const Spread time = result.time();
            const QString bytes
                = i == 0 && scaling.workingBytes ? numberText(*scaling.workingBytes) : u"–"_s;
            out << start << numberText(scaling.pixelsPerTriangle) << " | "
                << result.contender->info().name << " | " << numberText(time.median) << " | "
                << numberText(time.lower) << " … " << numberText(time.upper) << " | "
                << numberText(time.median / scaling.pixelsPerTriangle) << " | " << bytes << " |\n";
        }
    }
    return text;
}

} // namespace pixelplumb::bench
