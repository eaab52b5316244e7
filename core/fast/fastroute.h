// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pixelplumb {

/// Which kernel of the fast path drew a triangle.
enum class FastKernel {
    None, ///< nothing to draw: culled before any work on columns
    Block8, ///< at most 8 columns: one store per row, coverage by edge functions
    Block16, ///< at most 32 columns, the same in blocks of 16
    Strip8, ///< a strip of 8 columns, where the box is no wider
    Strip16, ///< strips of 16 columns, one cache line wide
    Strip32, ///< strips of 32 columns
    RowSpans, ///< spans of rows
    FloatStrip16, ///< the assignment's float32 increments in strips of 16 columns
    Plain, ///< the plain kernel, column by column
};

/// Why that kernel was chosen. The reasons are checked in the order of the values.
enum class FastReason {
    OutsideFrame, ///< no sample of the frame in its bounding box
    ZeroAreaPaintsNothing,
    NoFastArithmetic,
    NoFastRule,
    SmallFrame,
    FarAway,
    ZeroAreaSegment,
    BeyondExactWords,
    SmallBox,
    NarrowBox,
    WideBox,
    TallBox,
    LargeFlat,
    FloatIncrements,
};

/// How the colours of a triangle were stored (colourplane.h).
enum class ColourWord {
    Flat, ///< the three vertices have one colour
    Steps32, ///< 8.24, stepped from row to row
    Table32, ///< 8.24, the sum of a column's and a row's part
    Steps64, ///< 8.56, stepped from row to row
    Other, ///< the plain kernel's or the assignment's numbers
};

inline constexpr std::size_t fastKernelCount = 9;
inline constexpr std::size_t fastReasonCount = 14;
inline constexpr std::size_t colourWordCount = 5;

std::string_view nameOf(FastKernel kernel);
std::string_view nameOf(ColourWord word);
/// One sentence for a person who asks why.
std::string_view textOf(FastReason reason);

/// Counts triangles by kernel, word and reason. Plain counters: each thread has its own.
class RouteTally {
public:
    void count(FastKernel kernel, ColourWord word, FastReason reason, std::uint64_t triangles = 1)
    {
        m_counts[(std::size_t(kernel) * colourWordCount + std::size_t(word)) * fastReasonCount
                 + std::size_t(reason)]
            += triangles;
    }
    std::uint64_t of(FastKernel kernel, ColourWord word, FastReason reason) const
    {
        return m_counts[(std::size_t(kernel) * colourWordCount + std::size_t(word))
                            * fastReasonCount
                        + std::size_t(reason)];
    }
    void add(const RouteTally &other)
    {
        for (std::size_t i = 0; i < m_counts.size(); ++i)
            m_counts[i] += other.m_counts[i];
    }

private:
    std::array<std::uint64_t, fastKernelCount *colourWordCount *fastReasonCount> m_counts = {};
};

} // namespace pixelplumb
