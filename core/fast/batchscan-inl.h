// SPDX-License-Identifier: GPL-3.0-or-later
// Sets up and draws a batch of triangles. Compiled once for each instruction set.
#include "core/fast/batchload-inl.h"
#include "core/fast/batchsetup-inl.h"
#include "core/fast/blockscan-inl.h"
#include "core/fast/fastkernels.h"
#include "core/fast/floatstrip-inl.h"
#include "core/fast/routechoice.h"
#include "core/fast/rowspans-inl.h"
#include "core/fast/stripcolours-inl.h"
#include "core/fast/stripscan-inl.h"

#if defined(PIXELPLUMB_BATCHSCAN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_BATCHSCAN_INL
#undef PIXELPLUMB_BATCHSCAN_INL
#else
#define PIXELPLUMB_BATCHSCAN_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

/// Draws the triangles of a batch by the routes that routeFor() chooses.
template <FillRule Rule>
class BatchScan {
public:
    BatchScan(TriangleBatch &batch, const BatchTask &task)
        : m_batch(batch)
        , m_task(task)
    {
    }

    void run()
    {
        CornerLoad(m_batch, m_task.window).run();
        BatchSetUp<Rule>(m_batch, m_task.rounding, m_task.window.width, m_task.window.height).run();
        const auto all
            = TriangleBatch::Set((std::uint64_t(1) << m_batch.size) - 1) & ~m_batch.farAway;
        const TriangleBatch::Set small = m_batch.small & all;
        countSmall(small & m_batch.narrow, FastKernel::Block8);
        countSmall(small & ~m_batch.narrow, FastKernel::Block16);
        const auto next = reinterpret_cast<std::uintptr_t>(m_batch.source + m_batch.size);
        for (std::size_t i = 0; i < m_batch.size; ++i) {
            prefetchTriangle(next + i * sizeof(Triangle));
            if (TriangleBatch::contains(small, i)) {
                const ColourWord word = TriangleBatch::contains(m_batch.flat, i)
                    ? ColourWord::Flat
                    : ColourWord::Steps32;
                if (TriangleBatch::contains(m_batch.narrow, i)) {
                    prefetchBlock(i + blocksAhead);
                    drawBlockOf<8>(i, word);
                } else {
                    drawBlockOf<16>(i, word);
                }
                continue;
            }
            const Route route
                = routeFor(m_batch, i, Rule, HWY_MIN(m_task.window.width, widestStrip));
            m_task.tally->count(route.kernel, route.word, route.reason);
            draw(i, route);
        }
    }

private:
    /// Two vectors of sixteen pixels; the colours of more or shorter vectors do not stay in
    /// registers.
    static constexpr std::int32_t widestStrip = lanesOf<Pixels<16>> == 16 ? 32 : 16;

    /// A small triangle stores to one cache line per row, and each store waits for its line: blocks
    /// are prefetched this far ahead.
    static constexpr std::size_t blocksAhead = 3;
    static constexpr int prefetchedRows = 4;
    HWY_INLINE void prefetchBlock(std::size_t i) const
    {
        if (i >= m_batch.size)
            return;
        const FrameView &window = m_task.window;
        auto address = reinterpret_cast<std::uintptr_t>(window.base)
            + std::uintptr_t(m_batch.firstRow[i] * window.stride + m_batch.firstColumn[i])
                * sizeof(QRgb);
        for (int row = 0; row < prefetchedRows; ++row) {
            prefetchForStore(address);
            address += std::uintptr_t(window.stride) * sizeof(QRgb);
        }
    }

    void countSmall(TriangleBatch::Set set, FastKernel kernel)
    {
        const auto count = [&](TriangleBatch::Set part, ColourWord word) {
            if (part != 0)
                m_task.tally->count(kernel, word, FastReason::SmallBox,
                                    std::uint64_t(std::popcount(part)));
        };
        count(set & m_batch.flat, ColourWord::Flat);
        count(set & ~m_batch.flat, ColourWord::Steps32);
    }

    HWY_INLINE void draw(std::size_t i, const Route &route)
    {
        switch (route.kernel) {
        case FastKernel::None:
            return;
        case FastKernel::Block8:
            return drawBlockOf<8>(i, route.word);
        case FastKernel::Block16:
            return drawBlockOf<16>(i, route.word);
        case FastKernel::Strip8:
            return drawStrips<8>(i, route.word);
        case FastKernel::Strip16:
            return drawStrips<16>(i, route.word);
        case FastKernel::Strip32:
            return drawStrips<32>(i, route.word);
        case FastKernel::RowSpans:
            return drawRows(i, route.word);
        case FastKernel::FloatStrip16:
        case FastKernel::Plain:
            return m_task.drawPlain(m_batch.source[i], m_task);
        }
    }

    template <int Columns>
    HWY_INLINE void drawBlockOf(std::size_t i, ColourWord word)
    {
        if (word == ColourWord::Flat)
            drawBlock<Columns, Shading::Flat>(m_batch, i, m_task.window);
        else
            drawBlock<Columns, Shading::Smooth>(m_batch, i, m_task.window);
    }

    SampleBox boxOf(std::size_t i) const
    {
        return {m_batch.firstColumn[i], m_batch.endColumn[i], m_batch.firstRow[i],
                m_batch.endRow[i]};
    }
    ColourPlane planeOf(std::size_t i) const
    {
        if (hasExactWords(m_batch, i))
            return ColourPlane(m_batch, i);
        return *ColourPlane::wide(m_batch, i, m_task.rounding);
    }

    template <int Columns>
    HWY_NOINLINE void drawStrips(std::size_t i, ColourWord word)
    {
        using D = Pixels<HWY_MIN(Columns, 16)>;
        // Without the limit, one-lane vectors would be unrolled to no benefit.
        constexpr int vectors = HWY_MIN(Columns / lanesOf<D>, 4);
        constexpr Walk walk = Walk::UpRows;
        const BoundingLines lines(m_batch, i);
        const SampleBox box = boxOf(i);
        const auto scan = [&](const auto &colour, const SampleBox &part) HWY_ATTR {
            StripScan<std::decay_t<decltype(colour)>, D, vectors>(m_task.window, lines, part,
                                                                  box.firstColumn, box.firstRow)
                .run(colour);
        };
        if (word == ColourWord::Flat)
            return scan(FlatColour<D, walk>(packed(m_batch.source[i].vertices[0].colour)), box);
        const ColourPlane plane = planeOf(i);
        if (word == ColourWord::Steps32)
            return scan(Steps32Colour<D, walk>(plane), box);
        if (word == ColourWord::Steps64)
            return scan(Steps64Colour<D, walk>(plane), box);
        for (SampleBox part = box; part.firstRow < box.endRow; part.firstRow += tableLength) {
            part.endRow = HWY_MIN(box.endRow, part.firstRow + tableLength);
            const ColourTable<walk> table(plane, part.firstRow - box.firstRow,
                                          part.endRow - part.firstRow);
            scan(Table32Colour<D, walk>(table), part);
        }
    }

    HWY_NOINLINE void drawRows(std::size_t i, ColourWord word)
    {
        using D = Pixels<16>;
        constexpr Walk walk = Walk::AlongRow;
        const BoundingLines lines(m_batch, i);
        const SampleBox box = boxOf(i);
        const auto scan = [&](const auto &colour, const SampleBox &part) HWY_ATTR {
            RowSpanScan<std::decay_t<decltype(colour)>, D>(m_task.window, lines, part,
                                                           box.firstColumn, box.firstRow)
                .run(colour);
        };
        if (word == ColourWord::Flat)
            return scan(FlatColour<D, walk>(packed(m_batch.source[i].vertices[0].colour)), box);
        const ColourPlane plane = planeOf(i);
        if (word == ColourWord::Steps32)
            return scan(Steps32Colour<D, walk>(plane), box);
        if (word == ColourWord::Steps64)
            return scan(Steps64Colour<D, walk>(plane), box);
        for (SampleBox part = box; part.firstColumn < box.endColumn;
             part.firstColumn += tableLength) {
            part.endColumn = HWY_MIN(box.endColumn, part.firstColumn + tableLength);
            const ColourTable<walk> table(plane, part.firstColumn - box.firstColumn,
                                          part.endColumn - part.firstColumn);
            scan(Table32Colour<D, walk>(table), part);
        }
    }

    TriangleBatch &m_batch;
    const BatchTask &m_task;
};

void drawBatch(TriangleBatch &batch, const BatchTask &task)
{
    if (task.rule == FillRule::HalfOpenColumn)
        BatchScan<FillRule::HalfOpenColumn>(batch, task).run();
    else
        BatchScan<FillRule::Closed>(batch, task).run();
}

void drawFloatStrip(const FloatStrip &strip, ByteRounding rounding, FrameView window)
{
    FloatStripScan(strip, rounding, window).run();
}

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
