// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/shading/shadedrecording.h"
#include "core/shade/shadedpicture.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace pixelplumb {

/// Draws triangle by triangle and announces each pixel once. Where pixels have several samples,
/// those of every edge pixel are kept, so that after each triangle the frame shows the picture so
/// far.
template <class N, class A>
class ShadedPictureRecorder {
public:
    using Recorder = ObserverOf<ShadedNumbers<N, A>>;

    ShadedPictureRecorder(InterpolationForm form, const Primitives &primitives,
                          const ScanSettings &settings, FrameView frame, const EffectPlan &plan,
                          Recorder recorder)
        : m_frame(frame)
        , m_surroundings(plan, primitives.appearance, frame)
        , m_antialiasing(plan.antialiasing)
        , m_pattern(samplePattern(plan.antialiasing))
        , m_recorder(recorder)
        , m_run(form, primitives, settings, Listener{this})
    {
        if (m_pattern.empty())
            return;
        m_edges.emplace(primitives.triangles, frame);
        for (std::size_t i = 0; i < m_pattern.size(); ++i) {
            m_samples.push_back(std::make_unique<Sample>(plan, primitives.appearance, frame));
            m_samples.back()->frame.copyFrom(frame);
        }
    }

    void draw(std::size_t index, const EffectSet &effects)
    {
        if (m_antialiasing == Antialiasing::Area)
            m_run.drawAreas(index, effects, m_frame, m_surroundings);
        else if (m_pattern.empty())
            m_run.draw(index, effects, m_frame, m_surroundings);
        else
            drawSamples(index, effects);
    }

private:
    using Column = BoundedColumn<N, A>;
    /// One sample's picture of the edge pixels.
    struct Sample {
        Sample(const EffectPlan &plan, const Appearance &appearance, const FrameView &like)
            : frame(like)
            , surroundings(plan, appearance, like)
        {
        }
        ScratchFrame frame;
        ShadedSurroundings<N> surroundings;
    };
    /// Receives the triangle as sampled at pixel centres; columns that only other samples reach
    /// come before and after its own. While another sample's picture is drawn, it notes which
    /// pixels that sample visits and writes.
    struct Listener {
        ShadedPictureRecorder *picture;

        void primitiveBegun(const ShadedSetUpRead<N> &setUp)
        {
            if (!picture->m_sample)
                picture->m_recorder.primitiveBegun(setUp);
        }
        void primitiveRejected(const Rejection &rejection)
        {
            // No sample at a centre is in the frame, but others may be.
            if (!picture->m_sample && picture->m_visited.empty())
                picture->m_recorder.primitiveRejected(rejection);
        }
        void spanEntered(const Column &column)
        {
            if (picture->m_sample)
                return;
            picture->announceBefore(column.x);
            picture->m_entered = column.x;
            picture->m_recorder.spanEntered(column);
        }
        void sampleRejected(std::int64_t x, std::int64_t y, QRgb pixel,
                            const ShadedSample<N> &sample)
        {
            if (picture->m_sample)
                picture->m_visited[x].try_emplace(y, std::uint16_t(0));
            else
                picture->m_recorder.sampleRejected(x, y, pixel, sample);
        }
        void pixelWritten(std::int64_t x, std::int64_t y, QRgb before, QRgb after,
                          const ShadedSample<N> &sample)
        {
            if (picture->m_sample)
                picture->m_visited[x][y] |= std::uint16_t(1U << *picture->m_sample);
            else
                picture->m_recorder.pixelWritten(x, y, before, after, sample);
        }
    };

    void drawSamples(std::size_t index, const EffectSet &effects)
    {
        m_visited.clear();
        for (std::size_t k = 0; k < m_samples.size(); ++k) {
            m_sample = k;
            const SampledPixels pixels{*m_edges, true, m_pattern[k]};
            m_run.draw(index, effects, m_samples[k]->frame.view(), m_samples[k]->surroundings,
                       &pixels);
        }
        m_sample.reset();
        m_entered.reset();
        const SampledPixels others{*m_edges, false, {0, 0}};
        m_run.draw(index, effects, m_frame, m_surroundings, &others);
        announceBefore(std::numeric_limits<std::int64_t>::max());
    }

    /// Announces the pixels of several samples in the columns below x: in those that no sample at a
    /// centre reaches, and in the last one that was entered.
    void announceBefore(std::int64_t x)
    {
        while (!m_visited.empty() && m_visited.begin()->first < x) {
            const auto visited = m_visited.begin();
            if (visited->first != m_entered) {
                Column column;
                column.rate = {};
                column.x = visited->first;
                m_recorder.spanEntered(column);
            }
            for (const auto &[y, samples] : visited->second)
                announce(visited->first, y, samples);
            m_visited.erase(visited);
        }
    }

    void announce(std::int64_t x, std::int64_t y, std::uint16_t written)
    {
        ShadedSample<N> sample = {};
        sample.samples.written = written;
        SampleMean mean;
        for (const std::unique_ptr<Sample> &each : m_samples) {
            const QRgb colour = *each->frame.view().at(x, y);
            mean.add(colour);
            sample.samples.current.add(colour);
        }
        sample.before = *m_frame.at(x, y);
        sample.after = mean.pixel();
        for (std::size_t i = 0; i < 3; ++i)
            sample.level[i] = unpacked(sample.after).channels[i];
        if (written == 0) {
            m_recorder.sampleRejected(x, y, sample.before, sample);
            return;
        }
        m_recorder.pixelWritten(x, y, sample.before, sample.after, sample);
        *m_frame.at(x, y) = sample.after;
    }

    FrameView m_frame;
    std::optional<EdgePixels> m_edges; ///< where pixels have several samples
    ShadedSurroundings<N> m_surroundings;
    Antialiasing m_antialiasing;
    std::span<const LatticePoint> m_pattern;
    Recorder m_recorder;
    ShadedRun<N, A, Listener> m_run;
    std::vector<std::unique_ptr<Sample>> m_samples;
    std::optional<std::int64_t> m_entered; ///< the column whose samples at centres are drawn
    std::optional<std::size_t> m_sample; ///< the sample whose picture is drawn; none: the centres'
    /// For the current triangle: which samples wrote each visited pixel, by column and row.
    std::map<std::int64_t, std::map<std::int64_t, std::uint16_t>> m_visited;
};

} // namespace pixelplumb
