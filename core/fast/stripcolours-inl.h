// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of a vector of neighbouring pixels during a walk. Compiled once for each instruction
// set.
#include "core/fast/colourplane.h"
#include "core/fast/pixelvectors-inl.h"

#if defined(PIXELPLUMB_STRIPCOLOURS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_STRIPCOLOURS_INL
#undef PIXELPLUMB_STRIPCOLOURS_INL
#else
#define PIXELPLUMB_STRIPCOLOURS_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The direction of a walk: up the rows of a strip, or along a row by whole vectors.
enum class Walk { UpRows, AlongRow };

inline constexpr std::int32_t tableLength = 512; ///< rows (or columns) of one table

/// A 64-bit word for each pixel of a vector of 32-bit lanes: two vectors, or one where a vector has
/// one lane.
template <class D>
struct WideWords {
    using D64 = hn::CappedTag<std::uint64_t, HWY_MAX(lanesOf<D> / 2, 1)>;
    using Vec64 = hn::Vec<D64>;

    Vec64 low; ///< of the first half of the pixels
    Vec64 high;

    /// 0, 1, 2 … times a word.
    static HWY_INLINE WideWords ramp(std::uint64_t perLane)
    {
        // Built from the bits of the lane's number: sums of values that stay in registers.
        constexpr D64 d{};
        const auto number = hn::Iota(d, 0);
        auto low = hn::Zero(d);
        for (std::uint64_t bit = 1; bit < std::uint64_t(lanesOf<D64>); bit *= 2) {
            const auto hasBit = hn::Ne(hn::And(number, hn::Set(d, bit)), hn::Zero(d));
            low = hn::Add(low, hn::IfThenElseZero(hasBit, hn::Set(d, bit * perLane)));
        }
        return {low, hn::Add(low, hn::Set(d, std::uint64_t(lanesOf<D64>) * perLane))};
    }
    HWY_INLINE WideWords plus(std::uint64_t all) const
    {
        const Vec64 each = hn::Set(D64(), all);
        return {hn::Add(low, each), hn::Add(high, each)};
    }
    /// The upper halves, in the order of the pixels.
    HWY_INLINE hn::Vec<D> tops() const
    {
        constexpr D d{};
#if HWY_TARGET == HWY_SCALAR
        return hn::TruncateTo(d, hn::ShiftRight<32>(low));
#else
        return hn::ConcatOdd(d, hn::BitCast(d, high), hn::BitCast(d, low));
#endif
    }
};

// The colours of a walk. Each class is a constant that makes a State at the walk's start and
// advances it; states are plain vectors by value, which compilers keep in registers.

/// One colour for all pixels.
template <class D, Walk W>
class FlatColour {
public:
    struct State { };

    explicit FlatColour(QRgb pixel)
        : m_pixels(hn::Set(D(), pixel))
    {
    }
    HWY_INLINE State begin(std::int64_t, std::int64_t) const { return {}; }
    HWY_INLINE hn::Vec<D> pixels(const State &) const { return m_pixels; }
    HWY_INLINE void advance(State &) const { }

private:
    hn::Vec<D> m_pixels;
};

/// The upper halves of the words, stepped: 24 fraction bits.
template <class D, Walk W>
class Steps32Colour {
    using Vec = hn::Vec<D>;

public:
    struct State {
        Vec red;
        Vec green;
        Vec blue;
    };

    explicit Steps32Colour(const ColourPlane &plane)
        : m_plane(plane)
        , m_ramp{ramp(0), ramp(1), ramp(2)}
        , m_step{step(0), step(1), step(2)}
    {
    }
    HWY_INLINE State begin(std::int64_t column, std::int64_t row) const
    {
        const auto at = [&](std::size_t c) HWY_ATTR {
            return hn::Set(D(), std::uint32_t(m_plane.at(c, column, row) >> 32));
        };
        return {hn::Add(m_ramp.red, at(0)), hn::Add(m_ramp.green, at(1)),
                hn::Add(m_ramp.blue, at(2))};
    }
    HWY_INLINE Vec pixels(const State &state) const
    {
        return pixelsOf(D(), state.red, state.green, state.blue);
    }
    HWY_INLINE void advance(State &state) const
    {
        state.red = hn::Add(state.red, m_step.red);
        state.green = hn::Add(state.green, m_step.green);
        state.blue = hn::Add(state.blue, m_step.blue);
    }

private:
    HWY_INLINE Vec ramp(std::size_t c) const
    {
        return hn::Mul(hn::Iota(D(), 0), hn::Set(D(), std::uint32_t(m_plane.perColumn[c] >> 32)));
    }
    HWY_INLINE Vec step(std::size_t c) const
    {
        return hn::Set(D(),
                       W == Walk::UpRows
                           ? std::uint32_t(m_plane.perRow[c] >> 32)
                           : std::uint32_t(m_plane.perColumn[c] >> 32) * std::uint32_t(lanesOf<D>));
    }

    const ColourPlane &m_plane;
    State m_ramp;
    State m_step;
};

/// The whole words, stepped: 40 or 56 fraction bits.
template <class D, Walk W>
class Steps64Colour {
    using Words = WideWords<D>;

public:
    struct State {
        Words red;
        Words green;
        Words blue;
    };

    explicit Steps64Colour(const ColourPlane &plane)
        : m_plane(plane)
        , m_ramp{Words::ramp(plane.perColumn[0]), Words::ramp(plane.perColumn[1]),
                 Words::ramp(plane.perColumn[2])}
        , m_step{step(0), step(1), step(2)}
    {
    }
    HWY_INLINE State begin(std::int64_t column, std::int64_t row) const
    {
        return {m_ramp.red.plus(m_plane.at(0, column, row)),
                m_ramp.green.plus(m_plane.at(1, column, row)),
                m_ramp.blue.plus(m_plane.at(2, column, row))};
    }
    HWY_INLINE hn::Vec<D> pixels(const State &state) const
    {
        return pixelsOf(D(), state.red.tops(), state.green.tops(), state.blue.tops());
    }
    HWY_INLINE void advance(State &state) const
    {
        state.red = state.red.plus(m_step[0]);
        state.green = state.green.plus(m_step[1]);
        state.blue = state.blue.plus(m_step[2]);
    }

private:
    std::uint64_t step(std::size_t c) const
    {
        return W == Walk::UpRows ? m_plane.perRow[c]
                                 : m_plane.perColumn[c] * std::uint64_t(lanesOf<D>);
    }

    const ColourPlane &m_plane;
    State m_ramp;
    std::array<std::uint64_t, 3> m_step;
};

/// The rows' (or columns') part of the colours of a large triangle. Each entry is cut to 24
/// fraction bits separately, so that no error grows along the walk (colourplane.h).
template <Walk W>
class ColourTable {
public:
    /// A row's first and last vectors may extend beyond the box.
    static constexpr std::int32_t margin = W == Walk::UpRows ? 0 : 16;
    static constexpr std::int32_t length = tableLength + 2 * margin;

    /// `used` rows (or columns) from `first` on, counted from the first sample of the triangle's
    /// box.
    ColourTable(const ColourPlane &plane, std::int64_t first, std::int32_t used)
        : m_plane(plane)
        , m_first(first - margin)
    {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint64_t step = W == Walk::UpRows ? plane.perRow[c] : plane.perColumn[c];
            std::uint64_t word = std::uint64_t(m_first) * step;
            std::uint32_t *const words = m_words.data() + c * length;
            for (std::int32_t n = 0; n < used + 2 * margin; ++n) {
                words[n] = std::uint32_t(word >> 32);
                word += step;
            }
        }
    }

    const ColourPlane &plane() const { return m_plane; }
    /// Red's words from a row (or column) on; green's and blue's follow after one and two lengths.
    const std::uint32_t *from(std::int64_t place) const
    {
        return m_words.data() + (place - m_first);
    }

private:
    const ColourPlane &m_plane;
    std::int64_t m_first;
    std::array<std::uint32_t, std::size_t(3) * length> m_words;
};

/// The other part's word, plus an entry of the table. The walk must stay within the table.
template <class D, Walk W>
class Table32Colour {
    using Vec = hn::Vec<D>;
    static constexpr std::ptrdiff_t stride = W == Walk::UpRows ? 1 : lanesOf<D>;

public:
    struct State {
        Vec red; ///< the part that is not in the table
        Vec green;
        Vec blue;
        const std::uint32_t *next; ///< red's entry in the table; green's and blue's follow it
    };

    explicit Table32Colour(const ColourTable<W> &table)
        : m_table(table)
        , m_ramp{ramp(0), ramp(1), ramp(2)}
    {
    }
    HWY_INLINE State begin(std::int64_t column, std::int64_t row) const
    {
        return {other(0, m_ramp[0], column, row), other(1, m_ramp[1], column, row),
                other(2, m_ramp[2], column, row), m_table.from(W == Walk::UpRows ? row : column)};
    }
    HWY_INLINE Vec pixels(const State &state) const
    {
        constexpr std::ptrdiff_t length = ColourTable<W>::length;
        return pixelsOf(D(), hn::Add(state.red, entries(state.next)),
                        hn::Add(state.green, entries(state.next + length)),
                        hn::Add(state.blue, entries(state.next + 2 * length)));
    }
    HWY_INLINE void advance(State &state) const { state.next += stride; }

private:
    WideWords<D> ramp(std::size_t c) const
    {
        return WideWords<D>::ramp(W == Walk::UpRows ? m_table.plane().perColumn[c] : 0);
    }
    HWY_INLINE Vec other(std::size_t c, const WideWords<D> &ramp, std::int64_t column,
                         std::int64_t row) const
    {
        const std::uint64_t word = tableBias
            + (W == Walk::UpRows ? m_table.plane().at(c, column, 0)
                                 : m_table.plane().at(c, 0, row));
        return ramp.plus(word).tops();
    }
    HWY_INLINE static Vec entries(const std::uint32_t *from)
    {
        return W == Walk::UpRows ? hn::Set(D(), *from) : hn::LoadU(D(), from);
    }

    const ColourTable<W> &m_table;
    std::array<WideWords<D>, 3> m_ramp; ///< zeros along a row
};

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
