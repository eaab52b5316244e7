// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/fastroute.h"

namespace pixelplumb {

std::string_view nameOf(FastKernel kernel)
{
    static constexpr std::array names = {"none",
                                         "block of 8 columns",
                                         "blocks of 16 columns",
                                         "strip of 8 columns",
                                         "strips of 16 columns",
                                         "strips of 32 columns",
                                         "row spans",
                                         "float32 strips of 16 columns",
                                         "plain kernel"};
    static_assert(names.size() == std::size_t(FastKernel::Plain) + 1);
    return names[std::size_t(kernel)];
}

std::string_view nameOf(ColourWord word)
{
    static constexpr std::array names
        = {"flat", "32-bit steps", "32-bit table", "64-bit steps", "none"};
    static_assert(names.size() == std::size_t(ColourWord::Other) + 1);
    return names[std::size_t(word)];
}

std::string_view textOf(FastReason reason)
{
    static constexpr std::array names
        = {"its bounding box holds no sample of the frame",
           "zero area paints nothing under this fill rule",
           "only exact and float32 arithmetic have fast kernels",
           "in exact arithmetic only the rules closed and half-open-column have fast kernels",
           "the frame has fewer than 16 columns",
           "a corner is more than 2^15 px from the frame's first pixel",
           "the area is zero: a segment, coloured along its edge",
           "no 64-bit colour word is exact: 4 A' (n + 1) is 2^56 or more",
           "its bounding box is at most 32 columns wide and 63 px high, so each row is one or "
           "two vectors",
           "its bounding box fits into one strip",
           "its bounding box is at least four times as wide as high",
           "its bounding box is tall, so starting a strip costs comparatively little",
           "one colour fills a large bounding box, so stores come in long runs",
           "each lane makes the assignment's own additions for one column"};
    static_assert(names.size() == std::size_t(FastReason::FloatIncrements) + 1);
    return names[std::size_t(reason)];
}

} // namespace pixelplumb
