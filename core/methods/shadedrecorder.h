// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/shadedpicture.h"
#include "core/methods/shadedrecording.h"

#include <map>
#include <memory>
#include <vector>

namespace pixelplumb {

/// Draws triangle by triangle with the samples of every edge pixel at hand, so that after each
/// triangle the frame shows what there is, and announces each pixel once.
template <InterpolationForm Form, class N, class A, class Recorder>
class SampledRecording {
public:
    SampledRecording(const Primitives &primitives, const ScanSettings &settings, FrameView frame,
                     const EffectPlan &plan, Recorder recorder)
        : m_primitives(primitives)
        , m_frame(frame)
        , m_edges(primitives.triangles, frame)
        , m_surroundings(plan, primitives.appearance, frame)
        , m_pattern(samplePattern(plan.antialiasing))
        , m_centre(primitives, settings, CentreListener{this, recorder})
        , m_recorder(recorder)
        , m_settings(settings)
    {
        for (std::size_t i = 0; i < m_pattern.size(); ++i) {
            m_samples.push_back(std::make_unique<Sample>(plan, primitives.appearance, frame));
            m_samples.back()->frame.copyFrom(frame);
        }
    }

    void draw(std::size_t index, const EffectSet &effects)
    {
        m_written.clear();
        for (std::size_t k = 0; k < m_samples.size(); ++k)
            drawSample(k, index, effects);
        m_centre.draw(index, effects, m_frame, m_surroundings, m_edges, false, {0, 0},
                      [this](const Column &column) { announceIn(column.x); });
        announceBefore(std::numeric_limits<std::int64_t>::max());
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
    /// Hears which pixels a sample's picture writes.
    struct Listener : NullObserver {
        SampledRecording *recording;
        std::uint16_t bit;

        Listener(SampledRecording *of, std::size_t sample)
            : recording(of)
            , bit(std::uint16_t(1U << sample))
        {
        }
        template <class AnySample>
        void pixelWritten(std::int64_t x, std::int64_t y, QRgb, QRgb, const AnySample &)
        {
            recording->m_written[x][y] |= bit;
        }
    };

    /// Hears the triangle as the samples at the centres have it. Columns that only other samples
    /// reach come before and after its own.
    struct CentreListener {
        SampledRecording *recording;
        Recorder recorder;

        void primitiveBegun(const ShadedSetUpRead<N> &setUp) { recorder.primitiveBegun(setUp); }
        void primitiveRejected(const Rejection &rejection)
        {
            recorder.primitiveRejected(rejection);
        }
        void spanEntered(const Column &column)
        {
            recording->announceBefore(column.x);
            recorder.spanEntered(column);
        }
        void sampleRejected(std::int64_t x, std::int64_t y, QRgb pixel,
                            const ShadedSample<N> &sample)
        {
            recorder.sampleRejected(x, y, pixel, sample);
        }
        void pixelWritten(std::int64_t x, std::int64_t y, QRgb before, QRgb after,
                          const ShadedSample<N> &sample)
        {
            recorder.pixelWritten(x, y, before, after, sample);
        }
    };

    void drawSample(std::size_t k, std::size_t index, const EffectSet &effects)
    {
        Sample &sample = *m_samples[k];
        ShadedRun<Form, N, A, Listener> run(m_primitives, m_settings, Listener(this, k));
        run.draw(index, effects, sample.frame.view(), sample.surroundings, m_edges, true,
                 m_pattern[k], [](const Column &) {});
    }

    /// The columns below x that no sample at a centre reaches.
    void announceBefore(std::int64_t x)
    {
        while (!m_written.empty() && m_written.begin()->first < x) {
            Column column;
            column.rate = {};
            column.x = m_written.begin()->first;
            m_recorder.spanEntered(column);
            announceIn(column.x);
        }
    }

    void announceIn(std::int64_t x)
    {
        const auto column = m_written.find(x);
        if (column == m_written.end())
            return;
        for (const auto &[y, samples] : column->second)
            announce(x, y, samples);
        m_written.erase(column);
    }

    void announce(std::int64_t x, std::int64_t y, std::uint16_t written)
    {
        ShadedSample<N> sample = {};
        sample.samples.count = int(m_samples.size());
        sample.samples.written = written;
        SampleMean mean;
        for (const std::unique_ptr<Sample> &each : m_samples)
            mean.add(*each->frame.view().at(x, y));
        sample.before = *m_frame.at(x, y);
        sample.after = mean.pixel();
        for (std::size_t i = 0; i < 3; ++i)
            sample.level[i] = unpacked(sample.after).channels[i];
        m_recorder.pixelWritten(x, y, sample.before, sample.after, sample);
        *m_frame.at(x, y) = sample.after;
    }

    const Primitives &m_primitives;
    FrameView m_frame;
    EdgePixels m_edges;
    ShadedSurroundings<N> m_surroundings;
    std::span<const LatticePoint> m_pattern;
    ShadedRun<Form, N, A, CentreListener> m_centre;
    Recorder m_recorder;
    ScanSettings m_settings;
    std::vector<std::unique_ptr<Sample>> m_samples;
    /// Of the triangle in hand: the samples that wrote each pixel, by column and row.
    std::map<std::int64_t, std::map<std::int64_t, std::uint16_t>> m_written;
};

} // namespace pixelplumb
