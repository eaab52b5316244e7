// SPDX-License-Identifier: GPL-3.0-or-later
#include "lineup.h"

#include <benchmark/benchmark.h>

#include <cstring>

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

/// The cost of storing without computing: memset over as many pixels as the triangles cover, from
/// the frame's start, wrapping around.
class MemoryLimit final : public Contender {
public:
    using Contender::Contender;

    void load(const Scene &scene) override
    {
        m_size = scene.size;
        m_pixels.assign(std::size_t(m_size.width) * std::size_t(m_size.height), 0);
        m_samples = std::size_t(coveredSamples(scene.triangles));
    }

    void draw() override
    {
        for (std::size_t left = m_samples; left > 0;) {
            const std::size_t now = std::min(left, m_pixels.size());
            std::memset(m_pixels.data(), 0x5a, now * sizeof(std::uint32_t));
            benchmark::DoNotOptimize(m_pixels.data());
            benchmark::ClobberMemory();
            left -= now;
        }
    }

    Picture picture() override { return Picture(m_size); }

private:
    FrameSize m_size;
    std::vector<std::uint32_t> m_pixels;
    std::size_t m_samples = 0;
};

} // namespace

void addMemoryLimit(Lineup &lineup)
{
    ContenderInfo info;
    info.id = u"memset"_s;
    info.name = u"memset of as many pixels"_s;
    info.role = Role::Limit;
    lineup.contenders.push_back(std::make_unique<MemoryLimit>(info));
}

} // namespace pixelplumb::bench
