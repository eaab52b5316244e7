// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/scenetiming.h"

#include "core/frame/framebuffer.h"
#include "core/measure/writecount.h"
#include "core/methods/method.h"
#include "core/scan/walks/columndrawing.h"

#include <chrono>
#include <cmath>
#include <cstring>

namespace pixelplumb {

namespace {

using Clock = std::chrono::steady_clock;

/// Draws this many times.
double timeOf(const std::function<void()> &draw, int times)
{
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < times; ++i)
        draw();
    return double(std::chrono::nanoseconds(Clock::now() - start).count());
}

struct Contender {
    std::function<void()> draw;
    DrawTime *result;
    int drawsPerSample = 1;
    std::vector<double> samples = {}; ///< ns a draw
};

/// All the bytes of a frame's lines, their padding included.
std::span<QRgb> memoryOf(const FrameView &view)
{
    const std::ptrdiff_t lastRow = (view.height - 1) * view.stride;
    return {view.base + std::min<std::ptrdiff_t>(lastRow, 0),
            std::size_t(std::abs(lastRow) + view.width)};
}

void setMemory(std::span<QRgb> memory, std::uint64_t pixels)
{
    while (pixels > 0) {
        const std::size_t now = std::size_t(std::min<std::uint64_t>(pixels, memory.size()));
        std::memset(memory.data(), 0x5a, now * sizeof(QRgb));
        pixels -= now;
    }
}

bool hasSameBytes(const FrameView &a, const FrameView &b)
{
    for (std::int32_t row = 0; row < a.height; ++row) {
        if (std::memcmp(a.base + row * a.stride, b.base + row * b.stride,
                        std::size_t(a.width) * sizeof(QRgb))
            != 0)
            return false;
    }
    return true;
}

class Measurement {
public:
    Measurement(const Scene &scene, const TimingOptions &options)
        : m_options(options)
        , m_triangles(primitivesOnSamples(scene).triangles)
        , m_spec(scene.frame)
        , m_plain(scene.frame)
        , m_fast(scene.frame)
    {
        m_timing.settings = scene.settings;
        if (!methodNamed(u"column-scan")->supports(scene.settings.fillRule))
            m_timing.settings.fillRule = FillRule::HalfOpenColumn;
    }

    std::optional<SceneTiming> run()
    {
        if (m_triangles.empty())
            return m_timing;
        if (!chooseTriangles())
            return std::nullopt;
        const auto pixels
            = countWrites(m_drawn, m_timing.settings.fillRule, m_spec, m_options.progress);
        if (!pixels)
            return std::nullopt;
        m_timing.pixels = *pixels;
        if (m_timing.pixels == 0)
            return m_timing;
        lookAtPictures();
        if (!race())
            return std::nullopt;
        return m_timing;
    }

private:
    /// `all`: 0 while it is unknown.
    bool mayGoOn(int done, int all) const
    {
        return goesOn(m_options.progress, {JobPhase::Measuring, done, all});
    }
    FastReport drawFastOn(int threads)
    {
        return drawFast(m_drawn, m_timing.settings, m_fast.view(), {threads, std::nullopt});
    }
    void drawPlain() { drawColumns(m_drawn, m_timing.settings, m_plain.view()); }

    /// Chooses as many of the scene's triangles as the plain kernel draws within the longest draw.
    bool chooseTriangles()
    {
        constexpr std::size_t first = 16;
        m_drawn = std::span<const Triangle>(m_triangles).first(std::min(first, m_triangles.size()));
        while (m_drawn.size() < m_triangles.size()) {
            if (!mayGoOn(0, 0))
                return false;
            const double time = std::max(timeOf([this] { drawPlain(); }, 1), 1.0);
            if (2 * time > m_options.longestDraw)
                break;
            const double growth = std::clamp(m_options.longestDraw / time, 2.0, 32.0);
            const double count = double(m_drawn.size()) * growth;
            m_drawn = std::span<const Triangle>(m_triangles)
                          .first(count < double(m_triangles.size()) ? std::size_t(count)
                                                                    : m_triangles.size());
        }
        m_timing.triangles = m_drawn.size();
        return true;
    }

    void lookAtPictures()
    {
        m_plain.clear();
        m_fast.clear();
        drawPlain();
        m_timing.report = drawFastOn(1);
        m_timing.sameBytes = hasSameBytes(m_plain.view(), m_fast.view());
    }

    bool race()
    {
        const FastReport onAll = drawFastOn(0);
        std::vector<Contender> contenders;
        contenders.push_back({[this] { drawPlain(); }, &m_timing.plain});
        contenders.push_back({[this] { drawFastOn(1); }, &m_timing.fast});
        if (onAll.threads > 1) {
            m_timing.parallel.emplace().threads = onAll.threads;
            contenders.push_back({[this] { drawFastOn(0); }, &*m_timing.parallel});
        }
        contenders.push_back(
            {[this] { setMemory(memoryOf(m_fast.view()), m_timing.pixels); }, &m_timing.memory});

        const int all = m_options.rounds * int(contenders.size());
        for (Contender &contender : contenders) {
            if (!mayGoOn(0, all))
                return false;
            const double time = std::max(timeOf(contender.draw, 1), 1.0);
            contender.drawsPerSample
                = std::max(1, int(std::ceil(m_options.sampleNanoseconds / time)));
        }
        int done = 0;
        for (int round = 0; round < m_options.rounds; ++round) {
            // Each round begins with another contender, so that none always follows the same
            // neighbour.
            for (std::size_t turn = 0; turn < contenders.size(); ++turn) {
                if (!mayGoOn(done++, all))
                    return false;
                Contender &contender = contenders[(turn + std::size_t(round)) % contenders.size()];
                contender.samples.push_back(timeOf(contender.draw, contender.drawsPerSample)
                                            / contender.drawsPerSample);
            }
        }
        for (const Contender &contender : contenders)
            contender.result->perDraw = spreadOf(contender.samples);
        m_timing.rounds = m_options.rounds;
        return true;
    }

    const TimingOptions &m_options;
    std::vector<Triangle> m_triangles;
    std::span<const Triangle> m_drawn;
    FrameSpec m_spec;
    FrameBuffer m_plain;
    FrameBuffer m_fast;
    SceneTiming m_timing;
};

} // namespace

std::optional<SceneTiming> timeScene(const Scene &scene, const TimingOptions &options)
{
    return Measurement(scene, options).run();
}

} // namespace pixelplumb
