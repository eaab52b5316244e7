// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the corners of a batch from the scene's array. Compiled once for each instruction set.
#include "core/fast/pixelvectors-inl.h"
#include "core/fast/trianglebatch.h"

#if defined(PIXELPLUMB_BATCHLOAD_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_BATCHLOAD_INL
#undef PIXELPLUMB_BATCHLOAD_INL
#else
#define PIXELPLUMB_BATCHLOAD_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A scene is an array of vertices of three 64-bit words: x, y, and the colour in the lowest three
/// bytes of the third. Vectors of vertices are split into x, y and colours, moved to the window,
/// truncated to 32 bits, and then split into the three corners.
class CornerLoad {
    using Words = hn::CappedTag<std::uint64_t, 8>;
    using Halves = hn::Rebind<std::uint32_t, Words>;
    using Word = hn::Vec<Words>;
    using ByVertex = std::array<std::uint32_t, 3 * TriangleBatch::capacity>;

    static constexpr std::size_t wordsPerVertex = 3;
    static_assert(sizeof(Vertex) == wordsPerVertex * sizeof(std::uint64_t)
                  && offsetof(Vertex, colour) == 2 * sizeof(std::uint64_t)
                  && sizeof(Triangle) == 3 * sizeof(Vertex));
    static_assert(std::endian::native == std::endian::little);

public:
    CornerLoad(TriangleBatch &batch, const FrameView &window)
        : m_batch(batch)
        , m_firstX(std::uint64_t(window.firstColumn) * std::uint64_t(unitsPerPixel))
        , m_firstY(std::uint64_t(window.firstRow) * std::uint64_t(unitsPerPixel))
    {
    }

    void run()
    {
        const std::size_t vertices = 3 * m_batch.size;
        const auto *const scene = reinterpret_cast<const std::byte *>(m_batch.source);
        auto beyond = hn::Zero(words);
        std::size_t vertex = 0;
        for (; vertex + lanesOf<Words> <= vertices; vertex += lanesOf<Words>)
            beyond = hn::Or(beyond, take(scene + vertex * sizeof(Vertex), vertex));
        if (vertex < vertices) {
            std::array<std::byte, lanesOf<Words> * sizeof(Vertex)> last = {};
            std::memcpy(last.data(), scene + vertex * sizeof(Vertex),
                        (vertices - vertex) * sizeof(Vertex));
            beyond = hn::Or(beyond, take(last.data(), vertex));
        }
        for (std::size_t i = 0; i < m_batch.size; i += lanesOf<Halves>) {
            separate(m_x, m_batch.x, i);
            separate(m_y, m_batch.y, i);
            separate(m_colour, m_batch.colour, i);
        }
        const auto isNear = hn::Eq(hn::ShiftRight<beyondBits>(beyond), hn::Zero(words));
        m_batch.farAway = hn::AllTrue(words, isNear) ? 0 : farAway();
    }

private:
    static constexpr Words words{};
    static constexpr Halves halves{};
    /// c + 2^23 has no bits from this one on if -2^23 <= c < 2^23.
    static constexpr int beyondBits = 24;
    static constexpr std::uint64_t limit = std::uint64_t(1) << (beyondBits - 1);

    /// Copies vertices to the places from `vertex` on; the result has bits from beyondBits on if a
    /// coordinate is beyond ±2^23.
    HWY_INLINE Word take(const std::byte *from, std::size_t vertex)
    {
        Word x;
        Word y;
        Word colour;
#if HWY_TARGET == HWY_SCALAR
        std::array<std::uint64_t, wordsPerVertex> word;
        std::memcpy(word.data(), from, sizeof(word));
        x = hn::Set(words, word[0]);
        y = hn::Set(words, word[1]);
        colour = hn::Set(words, word[2]);
#else
        hn::LoadInterleaved3(words, reinterpret_cast<const std::uint64_t *>(from), x, y, colour);
#endif
        x = hn::Sub(x, hn::Set(words, m_firstX));
        y = hn::Sub(y, hn::Set(words, m_firstY));
        // The bytes after the three channels are padding.
        colour = hn::And(colour, hn::Set(words, 0xffffff));
        hn::StoreU(hn::TruncateTo(halves, x), halves, m_x.data() + vertex);
        hn::StoreU(hn::TruncateTo(halves, y), halves, m_y.data() + vertex);
        hn::StoreU(hn::TruncateTo(halves, colour), halves, m_colour.data() + vertex);
        return hn::Or(hn::Add(x, hn::Set(words, limit)), hn::Add(y, hn::Set(words, limit)));
    }

    template <class Value>
    HWY_INLINE static void separate(const ByVertex &from, TriangleBatch::PerCorner<Value> &to,
                                    std::size_t i)
    {
        const hn::Rebind<Value, Halves> values;
        hn::Vec<Halves> corner0;
        hn::Vec<Halves> corner1;
        hn::Vec<Halves> corner2;
        hn::LoadInterleaved3(halves, from.data() + 3 * i, corner0, corner1, corner2);
        hn::Store(hn::BitCast(values, corner0), values, to[0].data() + i);
        hn::Store(hn::BitCast(values, corner1), values, to[1].data() + i);
        hn::Store(hn::BitCast(values, corner2), values, to[2].data() + i);
    }

    TriangleBatch::Set farAway() const
    {
        TriangleBatch::Set set = 0;
        for (std::size_t i = 0; i < m_batch.size; ++i) {
            std::uint64_t beyond = 0;
            for (const Vertex &vertex : m_batch.source[i].vertices) {
                beyond |= std::uint64_t(vertex.position.x) - m_firstX + limit;
                beyond |= std::uint64_t(vertex.position.y) - m_firstY + limit;
            }
            set |= TriangleBatch::Set(beyond >> beyondBits != 0) << i;
        }
        return set;
    }

    TriangleBatch &m_batch;
    std::uint64_t m_firstX;
    std::uint64_t m_firstY;
    alignas(64) ByVertex m_x;
    alignas(64) ByVertex m_y;
    alignas(64) ByVertex m_colour;
};

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
