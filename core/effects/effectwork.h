// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace pixelplumb {

/// What is done at a sample that costs something: what observers may count.
enum class EffectWork : std::uint8_t {
    DepthRead,
    DepthWrite,
    Division, ///< by 1/w
    TexelFetch,
    Normal, ///< made unit length
    Blend,
    Sample, ///< that gives a pixel: one, or one of 4 or 16
};
inline constexpr std::size_t effectWorkCount = 7;

/// An observer that also wants to know of that work. Every other one pays nothing for it.
template <class Observer>
concept HearsEffectWork = requires(Observer observer, EffectWork work)
{
    observer.worked(work);
};

} // namespace pixelplumb
