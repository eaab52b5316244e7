// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scanobserver.h"
#include "core/shade/edgepixels.h"
#include "core/shade/scratchframe.h"
#include "core/shade/shadedsample.h"
#include "core/shade/strokes/strokearea.h"
#include "core/shade/strokes/strokecolour.h"

#include <span>

/// Turns strokes (strokestrip.h) into pixels. By area: the colour at the pixel's sample is blended
/// over the pixel, with α = ⌊255·area + ½⌋ as its opacity, ⌊(s·α + d·(255 − α))/255 + ½⌋. By 4 or
/// 16 samples: each keeps its own colour, strokes paint over the samples that they cover, and the
/// pixel is their mean. By one: the pixel is painted where the stroke covers its sample.
namespace pixelplumb {

/// What is known about a stroke before any pixel.
struct StrokeSetUp {
    Shape shape; ///< sample coordinates
    StrokePoint half; ///< the half width of a line
    std::int64_t pieces = 0;
    std::int64_t nearFrame = 0; ///< pieces near the frame
};

/// The pixels of one column whose squares a stroke meets.
struct StrokeColumn {
    std::int64_t x = 0;
    std::int64_t firstRow = 0, endRow = 0;
};

struct StrokeSample {
    StrokeColour::Place place; ///< on a line, at the pixel's sample; not set with 4 or 16 samples
    std::array<std::int64_t, 3> level = {}; ///< the stroke's levels there, rounded; or those of the
                                            ///< mean
    QRgb before = 0, after = 0;
    int samples = 0; ///< 1, 4 or 16; 0: by area
    std::uint16_t covered = 0; ///< bit k: sample k
    PixelSamples current; ///< of 4 or 16; for readers of numbers
    std::uint8_t alpha = 0; ///< by area
    Quantity area; ///< px²; for observers that read numbers
};

struct StrokeNumbers {
    using SetUp = StrokeSetUp;
    using Span = StrokeColumn;
    using Sample = StrokeSample;
};

/// What the strokes of one picture are drawn into. It has sample frames only with 4 or 16 samples.
class StrokeCanvas {
public:
    StrokeCanvas(FrameView frame, Antialiasing antialiasing)
        : m_frame(frame)
        , m_antialiasing(antialiasing)
    {
        for (std::size_t i = 0; i < samplePattern(antialiasing).size(); ++i)
            m_samples.emplace_back(frame).copyFrom(frame);
    }

    const FrameView &frame() const { return m_frame; }
    bool isByArea() const { return m_antialiasing == Antialiasing::Area; }
    /// The sample offsets; one at the centre where the pattern is empty.
    std::span<const LatticePoint> pattern() const
    {
        static constexpr std::array<LatticePoint, 1> centre = {};
        const std::span<const LatticePoint> offsets = samplePattern(m_antialiasing);
        return offsets.empty() ? std::span<const LatticePoint>(centre) : offsets;
    }
    /// Paints one sample of a pixel, where pixels have more than one.
    void paint(std::size_t sample, std::int64_t x, std::int64_t y, const Colour &colour)
    {
        if (!m_samples.empty())
            *m_samples[sample].view().at(x, y) = packed(colour);
    }
    /// The mean of a pixel's samples.
    SampleMean mean(std::int64_t x, std::int64_t y) const
    {
        SampleMean mean;
        for (const ScratchFrame &sample : m_samples)
            mean.add(*sample.view().at(x, y));
        return mean;
    }
    PixelSamples samples(std::int64_t x, std::int64_t y) const
    {
        PixelSamples samples;
        for (const ScratchFrame &sample : m_samples)
            samples.add(*sample.view().at(x, y));
        return samples;
    }
    bool hasSampleFrames() const { return !m_samples.empty(); }

private:
    FrameView m_frame;
    Antialiasing m_antialiasing;
    std::vector<ScratchFrame> m_samples;
};

template <ScanObserver<StrokeNumbers> Observer>
class StrokeScan {
public:
    StrokeScan(const Shape &shape, const ScanSettings &settings, StrokeCanvas &canvas,
               Observer observer)
        : m_shape(shape)
        , m_colour(shape, settings.rounding)
        , m_canvas(canvas)
        , m_observer(observer)
    {
    }

    void run()
    {
        const StrokeStrip strip = strokeStripOf(m_shape, m_canvas.frame());
        if constexpr (readsNumbers<Observer>)
            m_observer.primitiveBegun(setUpOf(strip));
        const std::vector<StrokePixel> entries = strokePixels(strip.quads, m_canvas.frame());
        if (entries.empty())
            m_observer.primitiveRejected(strip.pieces > 0 ? PrimitiveRejection::OutsideFrame
                                                          : PrimitiveRejection::StrokeOfNoLength);
        const std::span<const StrokePixel> all = entries;
        for (std::size_t first = 0; first < all.size();) {
            const std::size_t end = endOf(
                all, first, [](const StrokePixel &a, const StrokePixel &b) { return a.x == b.x; });
            scanColumn(all.subspan(first, end - first), strip.quads);
            first = end;
        }
    }

private:
    template <class IsSame>
    static std::size_t endOf(std::span<const StrokePixel> entries, std::size_t first,
                             const IsSame &isSame)
    {
        std::size_t end = first + 1;
        while (end < entries.size() && isSame(entries[first], entries[end]))
            ++end;
        return end;
    }

    StrokeSetUp setUpOf(const StrokeStrip &strip) const
    {
        StrokeSetUp setUp{m_shape, {}, strip.pieces, std::int64_t(strip.quads.size())};
        if (m_shape.kind == PrimitiveKind::Line) {
            const LatticePoint &a = m_shape.vertices[0].position;
            const LatticePoint &b = m_shape.vertices[1].position;
            setUp.half = strokeHalfWidth(b.x - a.x, b.y - a.y);
        }
        return setUp;
    }

    void scanColumn(std::span<const StrokePixel> column, std::span<const StrokeQuad> quads)
    {
        m_observer.spanEntered(
            StrokeColumn{column.front().x, column.front().y, std::int64_t(column.back().y) + 1});
        for (std::size_t first = 0; first < column.size();) {
            const std::size_t end
                = endOf(column, first,
                        [](const StrokePixel &a, const StrokePixel &b) { return a.y == b.y; });
            const std::span<const StrokePixel> pixel = column.subspan(first, end - first);
            const StrokeCoverage coverage(pixel, quads);
            if (m_canvas.isByArea())
                drawArea(pixel.front(), coverage);
            else
                drawSamples(pixel.front(), coverage);
            first = end;
        }
    }

    void drawArea(const StrokePixel &pixel, const StrokeCoverage &coverage)
    {
        const StrokeCoverage::Share share = coverage.share();
        if (share.isEmpty)
            return;
        StrokeSample sample = sampleAt(pixel);
        sample.alpha = share.alpha;
        if constexpr (readsNumbers<Observer>)
            sample.area = coverage.area();
        sample.after = blended(m_colour.colourAt(sample.place), sample.before, share.alpha);
        write(pixel, sample);
    }

    void drawSamples(const StrokePixel &pixel, const StrokeCoverage &coverage)
    {
        const std::span<const LatticePoint> pattern = m_canvas.pattern();
        StrokeSample sample = sampleAt(pixel);
        sample.samples = int(pattern.size());
        for (std::size_t i = 0; i < pattern.size(); ++i) {
            if (!coverage.covers(pattern[i]))
                continue;
            sample.covered = std::uint16_t(sample.covered | 1U << i);
            m_canvas.paint(i, pixel.x, pixel.y,
                           m_colour.colourAt(m_colour.placeOf(pixel.x, pixel.y, pattern[i])));
        }
        if constexpr (readsNumbers<Observer>)
            sample.current = m_canvas.samples(pixel.x, pixel.y);
        if (sample.covered == 0) {
            sample.after = sample.before;
            m_observer.sampleRejected(pixel.x, pixel.y, sample.before, sample);
            return;
        }
        if (m_canvas.hasSampleFrames())
            takeMean(sample, pixel);
        else
            sample.after = packed(m_colour.colourAt(sample.place));
        write(pixel, sample);
    }

    StrokeSample sampleAt(const StrokePixel &pixel) const
    {
        StrokeSample sample;
        sample.place = m_colour.placeOf(pixel.x, pixel.y, {});
        sample.level = m_colour.levelsAt(sample.place);
        sample.before = *m_canvas.frame().at(pixel.x, pixel.y);
        return sample;
    }
    void takeMean(StrokeSample &sample, const StrokePixel &pixel)
    {
        sample.place = {};
        sample.after = m_canvas.mean(pixel.x, pixel.y).pixel();
        for (std::size_t i = 0; i < 3; ++i)
            sample.level[i] = unpacked(sample.after).channels[i];
    }
    void write(const StrokePixel &pixel, const StrokeSample &sample)
    {
        m_observer.pixelWritten(pixel.x, pixel.y, sample.before, sample.after, sample);
        *m_canvas.frame().at(pixel.x, pixel.y) = sample.after;
    }

    const Shape &m_shape;
    StrokeColour m_colour;
    StrokeCanvas &m_canvas;
    Observer m_observer;
};

} // namespace pixelplumb
