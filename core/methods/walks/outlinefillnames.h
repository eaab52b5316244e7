// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgewalknames.h"

#include <algorithm>

/// The names of the edges of an outline by the midpoint algorithm, and of their two lengths.
namespace pixelplumb {

/// "P₀P₁".
inline QString outlineEdgeName(std::size_t edge)
{
    return u"P%1P%2"_s.arg(vertexDigits[edge]).arg(vertexDigits[(edge + 1) % 3]);
}

/// Its length in steps of the midpoint algorithm: "Δ₀₁".
inline QString lengthTitle(std::size_t edge)
{
    const auto [first, second] = std::minmax({edge, (edge + 1) % 3});
    return u"Δ%1%2"_s.arg(vertexDigits[first]).arg(vertexDigits[second]);
}

/// Its steps across: "δ₀₁".
inline QString acrossTitle(std::size_t edge) { return lengthTitle(edge).replace(u'Δ', u'δ'); }

} // namespace pixelplumb
