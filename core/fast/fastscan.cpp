// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/fastscan.h"

#include "core/fast/crew.h"
#include "core/fast/fastkernels.h"
#include "core/fast/floatcolumns.h"
#include "core/fast/framebands.h"
#include "core/fast/machinethreads.h"
#include "core/scan/walks/columndrawing.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::int32_t narrowestWindow = 16; ///< the kernels' widest vector, in pixels

/// Below this, bands and threads cost more than they gain. A start takes some 10 to 50 µs.
constexpr double worthBands = 200'000; // ns

/// A rough cost on one thread, in ns: enough to tell a microsecond from a millisecond.
struct CostEstimate {
    double cost = 0;
    double triangles = 0; ///< triangles inside the frame

    bool isWorthBands() const { return cost >= worthBands; }
    /// Sorting a triangle into bands costs some 20 ns; the caches save that over some 200 pixels.
    bool isOfLargeTriangles() const { return cost >= 40 * triangles; }
};

/// Estimated from every n-th triangle, n odd: scenes repeat themselves in twos and fours.
CostEstimate estimatedCost(std::span<const Triangle> triangles, FrameView frame)
{
    constexpr double perTriangle = 15;
    constexpr double perPixel = 0.1;
    constexpr std::size_t lookedAt = 256;
    const std::size_t step = triangles.size() / lookedAt | 1;
    CostEstimate estimate;
    for (std::size_t i = 0; i < triangles.size(); i += step) {
        const auto &v = triangles[i].vertices;
        const auto [left, right] = std::minmax({v[0].position.x, v[1].position.x, v[2].position.x});
        const auto [low, high] = std::minmax({v[0].position.y, v[1].position.y, v[2].position.y});
        const auto columns = std::min(floorPixel(right) + 1, frame.endColumn())
            - std::max<std::int64_t>(ceilPixel(left), frame.firstColumn);
        const auto rows = std::min(floorPixel(high) + 1, frame.endRow())
            - std::max<std::int64_t>(ceilPixel(low), frame.firstRow);
        if (columns > 0 && rows > 0) {
            estimate.cost += perTriangle + perPixel * double(columns) * double(rows) / 2;
            ++estimate.triangles;
        }
    }
    estimate.cost *= double(step);
    estimate.triangles *= double(step);
    return estimate;
}

/// Draws one window's triangles, given one after another, with one instruction set.
class WindowDrawing {
public:
    WindowDrawing(const FastKernels &kernels, const ScanSettings &settings, FrameView window,
                  RouteTally &tally)
        : m_kernels(kernels)
        , m_settings(settings)
        , m_tally(tally)
        , m_isNarrow(window.width < narrowestWindow)
    {
        m_task.window = window;
        m_task.rounding = settings.rounding;
        m_task.rule = settings.fillRule;
        m_task.drawPlain = drawPlain;
        m_task.tally = &tally;
    }

    /// Draws consecutive triangles.
    void draw(std::span<const Triangle> triangles)
    {
        if (!isBatched()) {
            for (const Triangle &triangle : triangles)
                drawOne(triangle);
            return;
        }
        while (!triangles.empty()) {
            const std::size_t count = std::min(triangles.size(), TriangleBatch::capacity);
            drawBatch(triangles.first(count));
            triangles = triangles.subspan(count);
        }
    }
    /// Draws the triangles at these places of a scene.
    void draw(std::span<const Triangle> scene, std::span<const std::uint16_t> places)
    {
        if (!isBatched()) {
            for (const std::uint16_t place : places)
                drawOne(scene[place]);
            return;
        }
        while (!places.empty()) {
            const std::size_t count = std::min(places.size(), TriangleBatch::capacity);
            const auto rest = places.subspan(count);
            if (std::size_t(places[count - 1] - places[0]) == count - 1) { // consecutive, as in a
                                                                           // mesh
                drawBatch(scene.subspan(places[0], count));
                places = rest;
                continue;
            }
            for (std::size_t i = 0; i < count; ++i) {
                if (i < rest.size()) // loads while the current ones are drawn
                    prefetchTriangle(reinterpret_cast<std::uintptr_t>(&scene[rest[i]]));
                m_gathered[i] = scene[places[i]];
            }
            drawBatch(std::span(m_gathered).first(count));
            places = rest;
        }
    }

private:
    static void drawPlain(const Triangle &triangle, const BatchTask &task)
    {
        drawColumns(std::span(&triangle, 1), {Arithmetic::Exact, task.rule, task.rounding},
                    task.window);
    }

    bool isBatched() const
    {
        return !m_isNarrow && m_settings.arithmetic == Arithmetic::Exact
            && m_settings.fillRule != FillRule::Open;
    }

    void drawBatch(std::span<const Triangle> triangles)
    {
        m_batch.source = triangles.data();
        m_batch.size = triangles.size();
        m_kernels.drawBatch(m_batch, m_task);
    }

    void drawOne(const Triangle &triangle)
    {
        if (m_isNarrow)
            drawByPlainKernel(triangle, FastReason::SmallFrame);
        else if (m_settings.arithmetic == Arithmetic::Float32)
            drawFloats(triangle);
        else
            drawByPlainKernel(triangle,
                              m_settings.arithmetic == Arithmetic::Exact
                                  ? FastReason::NoFastRule
                                  : FastReason::NoFastArithmetic);
    }

    void drawFloats(const Triangle &triangle)
    {
        m_tally.count(FastKernel::FloatStrip16, ColourWord::Other, FastReason::FloatIncrements);
        drawFloatTriangle(triangle, m_settings, m_task.window, m_kernels);
    }

    void drawByPlainKernel(const Triangle &triangle, FastReason reason)
    {
        m_tally.count(FastKernel::Plain, ColourWord::Other, reason);
        drawColumns(std::span(&triangle, 1), m_settings, m_task.window);
    }

    const FastKernels &m_kernels;
    const ScanSettings &m_settings;
    RouteTally &m_tally;
    bool m_isNarrow;
    BatchTask m_task;
    TriangleBatch m_batch;
    std::array<Triangle, TriangleBatch::capacity> m_gathered;
};

std::vector<FastRouteUse> usesOf(const RouteTally &tally)
{
    std::vector<FastRouteUse> uses;
    for (std::size_t kernel = 0; kernel < fastKernelCount; ++kernel) {
        for (std::size_t word = 0; word < colourWordCount; ++word) {
            for (std::size_t reason = 0; reason < fastReasonCount; ++reason) {
                FastRouteUse use{FastKernel(kernel), ColourWord(word), FastReason(reason), 0};
                use.triangles = tally.of(use.kernel, use.word, use.reason);
                if (use.triangles > 0)
                    uses.push_back(use);
            }
        }
    }
    return uses;
}

/// Several bands per thread, so that none waits long for the last one.
constexpr int bandsPerThread = 3;

/// A larger frame, in bytes, does not stay in the caches while triangles all over it are drawn: it
/// is drawn in bands that do, even by a single thread.
constexpr std::int64_t largestCachedFrame = std::int64_t(16) << 20;
constexpr std::int64_t cachedBand = std::int64_t(4) << 20;

/// How many bands are worth their cost: 1 means the whole frame.
int bandCountFor(std::span<const Triangle> triangles, FrameView frame, int threads)
{
    const std::int64_t bytes = std::abs(frame.stride) * std::int64_t(sizeof(QRgb)) * frame.height;
    const bool isCached = bytes <= largestCachedFrame;
    if (threads == 1 && isCached)
        return 1;
    const CostEstimate estimate = estimatedCost(triangles, frame);
    if (!estimate.isWorthBands())
        return 1;
    const std::int64_t forCaches
        = isCached || !estimate.isOfLargeTriangles() ? 1 : bytes / cachedBand;
    const std::int64_t forThreads = threads > 1 ? threads * bandsPerThread : 1;
    return int(std::min<std::int64_t>(std::max(forCaches, forThreads), frame.height));
}

RouteTally drawInBands(std::span<const Triangle> triangles, const ScanSettings &settings,
                       const FrameBands &bands, const FastKernels &kernels, int threads)
{
    std::vector<RouteTally> tallies(std::size_t(bands.count()));
    BandBins bins(bands);
    while (!triangles.empty()) {
        // Each chunk is binned and drawn before the next, while it is in a cache shared by the
        // threads.
        const auto chunk = triangles.first(std::min(triangles.size(), BandBins::mostTriangles));
        triangles = triangles.subspan(chunk.size());
        bins.begin(chunk);
        shareJobs(threads, bands.count(), [&](int band) {
            WindowDrawing drawing(kernels, settings, bands.band(band), tallies[std::size_t(band)]);
            bins.forEach(
                band, [&](std::span<const Triangle> piece, std::span<const std::uint16_t> places) {
                    drawing.draw(piece, places);
                });
        });
    }
    RouteTally sum;
    for (const RouteTally &tally : tallies)
        sum.add(tally);
    return sum;
}

} // namespace

FastReport drawFast(std::span<const Triangle> triangles, const ScanSettings &settings,
                    FrameView frame, const FastOptions &options)
{
    FastReport report;
    report.instructionSet = options.instructionSet.value_or(supportedInstructionSets().back());
    const FastKernels kernels = fastKernelsFor(report.instructionSet);
    const int threads = options.threads > 0 ? options.threads : threadsOfMachine();
    // With rounded numbers, a band would restart its increments.
    const int bandCount
        = settings.arithmetic == Arithmetic::Exact ? bandCountFor(triangles, frame, threads) : 1;
    if (bandCount > 1) {
        const FrameBands bands(frame, bandCount);
        report.threads = threads;
        report.bands = bands.count();
        report.uses = usesOf(drawInBands(triangles, settings, bands, kernels, threads));
        return report;
    }
    RouteTally tally;
    WindowDrawing drawing(kernels, settings, frame, tally);
    drawing.draw(triangles);
    report.uses = usesOf(tally);
    return report;
}

} // namespace pixelplumb
