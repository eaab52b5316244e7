// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/fastroute.h"

namespace pixelplumb {

std::string_view nameOf(FastKernel kernel)
{
    switch (kernel) {
    case FastKernel::None:
        return "none";
    case FastKernel::Block8:
        return "block of 8 columns";
    case FastKernel::Block16:
        return "blocks of 16 columns";
    case FastKernel::Strip8:
        return "strip of 8 columns";
    case FastKernel::Strip16:
        return "strips of 16 columns";
    case FastKernel::Strip32:
        return "strips of 32 columns";
    case FastKernel::RowSpans:
        return "row spans";
    case FastKernel::FloatStrip16:
        return "float32 strips of 16 columns";
    case FastKernel::Plain:
        return "plain kernel";
    }
    return {};
}

std::string_view nameOf(ColourWord word)
{
    switch (word) {
    case ColourWord::Flat:
        return "flat";
    case ColourWord::Steps32:
        return "32-bit steps";
    case ColourWord::Table32:
        return "32-bit table";
    case ColourWord::Steps64:
        return "64-bit steps";
    case ColourWord::Other:
        return "none";
    }
    return {};
}

std::string_view textOf(FastReason reason)
{
    switch (reason) {
    case FastReason::OutsideFrame:
        return "its bounding box holds no sample of the frame";
    case FastReason::ZeroAreaPaintsNothing:
        return "zero area paints nothing under this fill rule";
    case FastReason::NoFastArithmetic:
        return "only exact and float32 arithmetic have fast kernels";
    case FastReason::NoFastRule:
        return "in exact arithmetic only the rules closed and half-open-column have fast kernels";
    case FastReason::SmallFrame:
        return "the frame has fewer than 16 columns";
    case FastReason::FarAway:
        return "a corner is more than 2^15 px from the frame's first pixel";
    case FastReason::ZeroAreaSegment:
        return "zero area: a segment, coloured along its edge";
    case FastReason::BeyondExactWords:
        return "no 64-bit colour word is exact: 4 A' (n + 1) is 2^56 or more";
    case FastReason::SmallBox:
        return "its box is at most 32 columns wide and 63 px high: one or two vectors a row";
    case FastReason::NarrowBox:
        return "its box fits into one strip";
    case FastReason::WideBox:
        return "its box is at least four times as wide as high";
    case FastReason::TallBox:
        return "its box has many rows: a strip's start costs little";
    case FastReason::LargeFlat:
        return "one colour over a large box: long runs of stores";
    case FastReason::FloatIncrements:
        return "the assignment's own additions, a column in each lane";
    }
    return {};
}

} // namespace pixelplumb
