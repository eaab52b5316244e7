// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/shadedfill.h"

#include <array>
#include <utility>

namespace pixelplumb {

/// Every set of effects by a number, 0 … effectSetCount − 1.
inline constexpr std::size_t effectSetCount = 32 * 3;

constexpr std::size_t numberOf(const EffectSet &effects)
{
    return std::size_t(effects.smooth) + 2 * std::size_t(effects.perspective)
        + 4 * std::size_t(effects.texture) + 8 * std::size_t(effects.light)
        + 16 * std::size_t(effects.blending) + 32 * std::size_t(effects.depth);
}
constexpr EffectSet effectSetOf(std::size_t number)
{
    return {number % 2 != 0,     number / 2 % 2 != 0,  number / 4 % 2 != 0,
            number / 8 % 2 != 0, number / 16 % 2 != 0, DepthTest(number / 32)};
}

/// Numbers whose kernels are compiled for each set of effects: float64 and integers of 256 bits are
/// not raced for time, nor is anything with sanitizers.
template <class N>
inline constexpr bool isSpecialised
#ifdef PIXELPLUMB_SANITIZED_BUILD
    = false;
#else
    = std::is_same_v<N, FloatShading<float>> || std::is_same_v<N, ExactShading<Int128>>;
#endif

/// The kernels of a form, one compiled for each set of effects: one look into this table a
/// triangle, none a pixel.
template <InterpolationForm Form, class N>
struct ShadeTable {
    using Kernel = void (*)(const ShadedSetUp<N> &setUp, const ShadedColumn<N> &column,
                            const RowRun &run, const Surface<N> &surface, FrameView frame);

    static Kernel kernelFor(const EffectSet &effects) { return table()[numberOf(effects)]; }

private:
    template <std::size_t number>
    static void shade(const ShadedSetUp<N> &setUp, const ShadedColumn<N> &column, const RowRun &run,
                      const Surface<N> &surface, FrameView frame)
    {
        shadeColumn<Form>(setUp, column, run, StaticEffects<effectSetOf(number)>{}, surface, frame,
                          NullObserver{});
    }

    static const std::array<Kernel, effectSetCount> &table()
    {
        static constexpr auto kernels = []<std::size_t... number>(std::index_sequence<number...>)
        {
            return std::array<Kernel, effectSetCount>{shade<number>...};
        }
        (std::make_index_sequence<effectSetCount>());
        return kernels;
    }
};

} // namespace pixelplumb
