// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/scan/walks/columnscan.h"

#include <cstdlib>
#include <cstring>

using namespace pixelplumb;

/// The column scan's pixel loop without any observer: what fillColumn should cost if nothing
/// listens. The test counts the instructions of both.
namespace {

template <class A>
[[gnu::noinline]] void fillColumnWithoutHooks(const ColumnState<A> &column, ByteRounding rounding,
                                              FrameView frame)
{
    if (column.firstDrawn >= column.endDrawn)
        return;
    Fragment<A> fragment;
    fragment.colour = column.firstColour;
    QRgb *pixel = frame.at(column.x, column.firstDrawn);
    for (std::int64_t row = column.firstDrawn; row < column.endDrawn; ++row) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            fragment.level[channel] = A::level(fragment.colour[channel], rounding);
        *pixel = pixelOfLevels(fragment.level);
        pixel += frame.stride;
        for (std::size_t channel = 0; channel < 3; ++channel)
            A::advance(fragment.colour[channel], column.colourRate[channel]);
    }
}

template <class A>
[[gnu::noinline]] void fillColumnUnobserved(const ColumnState<A> &column, ByteRounding rounding,
                                            FrameView frame)
{
    fillColumn(column, rounding, frame, NullObserver{});
}

/// A column of 1021 rows whose levels fall from 250 to 5.
template <class A, class FromInteger>
ColumnState<A> fallingColumn(FromInteger number)
{
    ColumnState<A> column;
    column.endRow = column.endDrawn = 1021;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        column.firstColour[channel] = number(250 - int(channel), 1);
        column.colourRate[channel] = number(-int(channel) - 1, 13);
    }
    return column;
}

template <class A>
void run(const ColumnState<A> &column, const char *which)
{
    FrameSpec spec;
    spec.width = 1;
    spec.height = 1021;
    const FrameBuffer frame(spec);
    for (int repeat = 0; repeat < 1000; ++repeat) {
        if (std::strcmp(which, "hooked") == 0)
            fillColumnUnobserved(column, ByteRounding::Nearest, frame.view());
        else
            fillColumnWithoutHooks(column, ByteRounding::Nearest, frame.view());
    }
}

} // namespace

/// kernels exact|float32 hooked|twin
int main(int argc, char **argv)
{
    if (argc != 3)
        return EXIT_FAILURE;
    if (std::strcmp(argv[1], "exact") == 0) {
        using Exact = ExactArithmetic<std::int64_t>;
        run(fallingColumn<Exact>([](int numerator, int denominator) {
                return MixedNumber<std::int64_t>{
                    floorDivide(numerator, denominator),
                    numerator - floorDivide(numerator, denominator) * denominator, 13};
            }),
            argv[2]);
    } else {
        run(fallingColumn<RoundedArithmetic<float>>([](int numerator, int denominator) {
                return float(numerator) / float(denominator);
            }),
            argv[2]);
    }
    return EXIT_SUCCESS;
}
