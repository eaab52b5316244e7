// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/shadedfill.h"
#include "core/scan/exactarithmetic.h"

#include <array>
#include <utility>

namespace pixelplumb {

/// The effects that a kernel is compiled for, by a number, 0 … compiledSetCount − 1. Depth and
/// blending are asked at each sample, which costs next to nothing beside what they do.
inline constexpr std::size_t compiledSetCount = 16;

constexpr std::size_t compiledSetOf(const EffectSet &effects)
{
    return std::size_t(effects.smooth) + 2 * std::size_t(effects.perspective)
        + 4 * std::size_t(effects.texture) + 8 * std::size_t(effects.light);
}

/// Of a set's effects, what a kernel was compiled for; what is not in it is no code.
template <std::size_t number>
struct CompiledEffects {
    static constexpr bool smooth = number % 2 != 0;
    static constexpr bool perspective = number / 2 % 2 != 0;
    static constexpr bool texture = number / 4 % 2 != 0;
    static constexpr bool light = number / 8 % 2 != 0;
    bool blending;
    DepthTest depth;
};

/// Whether kernels in these numbers are compiled for sets of effects: float64 and wide integers are
/// not raced for time, nor is anything with sanitizers.
template <class N, class A>
constexpr bool isRaced()
{
#ifdef PIXELPLUMB_SANITIZED_BUILD
    return false;
#else
    return (
        std::is_same_v<N, FloatShading<float>> || std::is_same_v<N, ExactShading<Int128>>)&&!std::
        is_same_v<A, ExactArithmetic<Int128>>;
#endif
}

/// The kernels of a form, one for each set of compiled effects: one look into this table a
/// triangle, none a pixel.
template <InterpolationForm Form, class N>
struct ShadeTable {
    using Kernel
        = void (*)(const ShadedSetUp<N> &setUp, const ShadedColumn<N> &column, const RowRun &run,
                   const EffectSet &effects, const ShadedSurface<N> &surface, FrameView frame);

    static Kernel kernelFor(const EffectSet &effects) { return table()[compiledSetOf(effects)]; }

private:
    template <std::size_t number>
    static void shade(const ShadedSetUp<N> &setUp, const ShadedColumn<N> &column, const RowRun &run,
                      const EffectSet &effects, const ShadedSurface<N> &surface, FrameView frame)
    {
        shadeColumn<Form>(setUp, column, run,
                          CompiledEffects<number>{effects.blending, effects.depth}, surface, frame,
                          NullObserver{});
    }

    static const std::array<Kernel, compiledSetCount> &table()
    {
        static constexpr auto kernels = []<std::size_t... number>(std::index_sequence<number...>)
        {
            return std::array<Kernel, compiledSetCount>{shade<number>...};
        }
        (std::make_index_sequence<compiledSetCount>());
        return kernels;
    }
};

} // namespace pixelplumb
