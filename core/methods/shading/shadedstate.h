// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgewalkstate.h"
#include "core/number/widequantity.h"
#include "core/scan/scansettings.h"
#include "core/shade/edgepixels.h"
#include "core/shade/shadedscan.h"
#include "core/trace/currentstep.h"

#include <array>
#include <memory>

/// What the tables of shaded triangles read: the kernel's numbers as quantities, so that one table
/// serves every arithmetic.
namespace pixelplumb {

/// A channel that a run carries, and its place in the states' arrays.
struct ScopedChannel {
    std::size_t at = 0;
    Channel which = Channel::Red;
};

/// What a run of shaded triangles carries, over all its batches, since a table has one heading.
struct ShadedScope {
    InterpolationForm form = InterpolationForm::Bilinear;
    EffectSet effects;
    std::vector<ScopedChannel> channels;
    bool isPlanned = true; ///< false: an interpolation by itself, for which no effect is planned
    Antialiasing antialiasing = Antialiasing::None;
    ByteRounding rounding = ByteRounding::Nearest;
    std::uint32_t greatestDepth = 0; ///< level of the depth format; 0: it keeps numbers
    bool isFiltered = false; ///< some material reads four texels
    /// Its lights, its viewer and its materials; null if no sample is lit.
    std::shared_ptr<const Appearance> appearance = nullptr;
};

template <class Value>
using OfVertices = std::array<Value, 3>;
using OfAxes = std::array<Quantity, 3>; ///< x, y, z

struct ShadedSetUpState {
    std::array<int, 3> order = {0, 1, 2};
    /// Decides what the digits in names stand for.
    InterpolationForm form = InterpolationForm::Bilinear;
    OfVertices<LatticePoint> position;
    EffectSet effects; ///< of the triangle
    PerChannel<bool> isDivided = {}; ///< by w
    bool zeroArea = false; ///< its segment is drawn
    PerChannel<OfVertices<Quantity>> given; ///< as the vertices give them
    OfVertices<Quantity> w;
    PerChannel<OfVertices<Quantity>> linear; ///< as interpolated: divided by w
    /// What each column adds along an edge, by SortedEdge; none where the edge is vertical.
    std::array<Quantity, 3> slope;
    std::array<PerChannel<Quantity>, 3> rate; ///< of the bilinear form
    PerChannel<OfVertices<Quantity>> plane; ///< a, b, c
    std::array<OfVertices<Quantity>, 3> weight; ///< a, b, c of each vertex
    int material = noMaterial;
    // Of an interpolation by itself; none without area.
    PerChannel<std::array<Quantity, 4>> normal; ///< A, B, C, D of the plane
    std::array<std::array<Quantity, 4>, 3> line; ///< A, B, C, k of each vertex's weight

    /// The vertex that a digit names: in the bilinear forms vertices are sorted.
    std::size_t vertexOf(std::size_t digit) const
    {
        return isBilinear(form) ? std::size_t(order[digit]) : digit;
    }
    /// Whether a vertex has anything in the channel at a place.
    bool carries(std::size_t at) const
    {
        return at < 3 || std::ranges::any_of(given[at], [](const Quantity &each) {
                   return each.toDouble() != 0;
               });
    }
};

struct ShadedSpanState {
    EdgeWalkSpanState walk; ///< which edges bound the column, and whether the walk goes on
    bool isBounded = false; ///< the triangle's edges meet it
    std::int64_t firstRow = 0, endRow = 0, firstDrawn = 0, endDrawn = 0;
    Quantity lower, upper; ///< px, as the channels use them
    PerChannel<Quantity> bottom, top, rate;

    std::int64_t drawnSamples() const { return std::max<std::int64_t>(0, endDrawn - firstDrawn); }
    /// Equal bounds have no change between them.
    bool hasRate() const { return walk.start.hasPlane && lower != upper; }
};

/// How the edges bound a column, described as the edge walks describe it; `previous` is the column
/// from which the walk goes on.
template <class Step>
EdgeWalkSpanState boundsOf(const Step &step, LongEdge longEdge,
                           const std::remove_cvref_t<decltype(step.span)> *previous)
{
    const auto &setUp = step.setUp;
    EdgeWalkSpanState walk;
    walk.primitive = step.primitive;
    for (std::size_t i = 0; i < 3; ++i)
        walk.corners[i].position = setUp.vertices[std::size_t(setUp.order[i])].position;
    const LatticePoint &p0 = walk.corners[0].position;
    const LatticePoint &p2 = walk.corners[2].position;
    walk.start.hasPlane = !setUp.zeroArea;
    walk.start.isVertical = setUp.zeroArea && p0.x == p2.x && p0.y != p2.y;
    walk.start.isOnePoint = p0 == p2;
    walk.column.x = step.span.x;
    walk.column.half = step.span.half;
    const SortedEdge shortEdge
        = step.span.half == ColumnHalf::First ? SortedEdge::L01 : SortedEdge::L12;
    if (!setUp.zeroArea)
        (longEdge == LongEdge::Above ? walk.lower : walk.upper) = shortEdge;
    walk.isFirst = !previous;
    walk.beginsHalf = !previous || previous->half != step.span.half;
    return walk;
}

struct ShadedLightState {
    OfAxes toLight, halfway; ///< L, H
    Quantity diffuse, facing, highlight;
};

template <class Real>
ShadedLightState lightStateOf(const SampleLightTerm<Real> &term)
{
    return {quantitiesOf(term.toLight), quantitiesOf(term.halfway), Quantity::of(term.diffuse),
            Quantity::of(term.facing), Quantity::of(term.highlight)};
}

struct ShadedSampleState {
    std::array<int, 3> order = {0, 1, 2};
    EdgeWalkStart start; ///< of an interpolation by itself
    std::int64_t x = 0, y = 0;
    bool startsRun = false; ///< the additions begin here
    bool isWritten = false;
    bool isBlended = false; ///< and has an alpha
    EffectSet effects; ///< of the triangle
    PerChannel<bool> isCommon = {}; ///< in which the vertices agree
    PerChannel<bool> isDivided = {}; ///< by w
    std::size_t commonVertex = 0; ///< has the common values
    PixelSamples pixelSamples; ///< 4 or 16: then none of the rest is set
    std::uint16_t samplesWritten = 0;
    bool isBeyondHorizon = false; ///< 1/w is not positive there
    PerChannel<Quantity> linear; ///< divided by w where perspective is corrected
    OfVertices<Quantity> weight;
    PerChannel<Quantity> value; ///< the quotient by 1/w
    std::array<Quantity, 2> affine; ///< u, v as if w were equal
    Quantity depth, nearest; ///< z or its level, and what was stored before; none: nothing was
    Colour interpolated; ///< as a byte
    std::array<std::int32_t, 2> textureSize = {};
    TextureWrap wrap = TextureWrap::Repeat;
    std::array<std::int32_t, 2> firstTexel = {};
    bool isFiltered = false; ///< four texels are read
    std::array<Colour, 4> texels
        = {}; ///< of four: lower left, lower right, upper left, upper right
    std::array<Quantity, 2> fraction;
    Colour texel, textured;
    Quantity normalLength; ///< of the interpolated normal
    OfAxes normal; ///< of length 1
    OfAxes toViewer; ///< V
    std::array<ShadedLightState, mostLights> lights;
    std::array<Quantity, 3> lit;
    Colour source;
    std::uint8_t alpha = 255, blendedAlpha = 255;
    Quantity area;
    Colour before, after;

    /// 4 or 16 where the pixel is the mean of that many, else 0.
    int samples() const { return int(pixelSamples.colours().size()); }
    /// A channel as the effects read it: the quotient where there is one.
    const Quantity &interpolatedIn(std::size_t channel) const
    {
        return value[channel].isNone() ? linear[channel] : value[channel];
    }
};

template <class N>
PerChannel<bool> dividedChannelsOf(const ShadedSetUp<N> &setUp)
{
    PerChannel<bool> isDivided = {};
    for (const std::size_t channel : setUp.carried)
        isDivided[channel] = setUp.divides(channel);
    return isDivided;
}

/// How the numbers of one kernel become quantities.
template <class N>
struct ShadedQuantities;

template <std::floating_point Float>
struct ShadedQuantities<FloatShading<Float>> {
    using N = FloatShading<Float>;

    explicit ShadedQuantities(const ShadedSetUpRead<N> &setUp)
        : isDivided(dividedChannelsOf(setUp))
    {
    }
    Quantity linear(std::size_t, Float value) const { return Quantity::of(value); }
    Quantity vertex(std::size_t, Float value) const { return Quantity::of(value); }
    Quantity weight(Float value) const { return Quantity::of(value); }
    Quantity value(const ShadedSample<N> &sample, std::size_t channel) const
    {
        const Float value = sample.value[channel];
        return Quantity::of(isDivided[channel] ? value / sample.value[indexOf(Channel::Reciprocal)]
                                               : value);
    }
    Quantity depth(Float value) const
    {
        return std::isfinite(value) ? Quantity::of(value) : Quantity();
    }

    PerChannel<bool> isDivided;
};

template <class Integer>
struct ShadedQuantities<ExactShading<Integer>> {
    using N = ExactShading<Integer>;

    explicit ShadedQuantities(const ShadedSetUpRead<N> &setUp)
        : isDivided(dividedChannelsOf(setUp))
        , area(setUp.area)
    {
        if (!isDivided[indexOf(Channel::Reciprocal)])
            return;
        // The kernel has a·w_j·w_k for a/w_i: too much by the product of all three w, and without
        // the powers of two that they have in common.
        std::int64_t bits = 0;
        std::array<std::int64_t, 3> w = {};
        for (std::size_t i = 0; i < 3; ++i) {
            w[i] = std::max<std::int64_t>(1, setUp.attributes[i].w);
            bits |= w[i];
        }
        const int zeros = std::countr_zero(std::uint64_t(bits));
        product = BigInteger(w[0] >> zeros) * (w[1] >> zeros) * (w[2] >> zeros);
        product <<= unsigned(zeros);
        scale = attributeOne;
    }
    BigInteger unitOf(std::size_t channel) const
    {
        const Channel which = channelAt(channel);
        return isLevel(which) || which == Channel::Reciprocal ? BigInteger(1)
                                                              : BigInteger(attributeOne);
    }
    Quantity linear(std::size_t channel, const Integer &numerator) const
    {
        const BigInteger below = BigInteger(area) * unitOf(channel);
        return isDivided[channel] ? quotientOf(BigInteger(numerator) * scale, below * product)
                                  : quotientOf(BigInteger(numerator), below);
    }
    Quantity vertex(std::size_t channel, const Integer &value) const
    {
        return isDivided[channel] ? quotientOf(BigInteger(value) * scale, unitOf(channel) * product)
                                  : quotientOf(BigInteger(value), unitOf(channel));
    }
    /// A rise over `run` > 0 lattice units, per column.
    Quantity rate(std::size_t channel, const Integer &rise, Lattice run) const
    {
        const BigInteger above = BigInteger(rise) * unitsPerPixel;
        const BigInteger below = unitOf(channel) * run;
        return isDivided[channel] ? quotientOf(above * scale, below * product)
                                  : quotientOf(above, below);
    }
    Quantity weight(const Integer &numerator) const
    {
        return quotientOf(BigInteger(numerator), BigInteger(area));
    }
    Quantity value(const ShadedSample<N> &sample, std::size_t channel) const
    {
        const Integer &below
            = isDivided[channel] ? sample.value[indexOf(Channel::Reciprocal)] : area;
        if (below <= 0)
            return {};
        return quotientOf(BigInteger(sample.value[channel]), BigInteger(below) * unitOf(channel));
    }
    Quantity depth(const typename N::Depth &depth) const
    {
        if (depth.whole == std::numeric_limits<std::int64_t>::max())
            return {};
        return quotientOf(BigInteger(depth.whole) * BigInteger(depth.denominator)
                              + BigInteger(depth.rest),
                          BigInteger(depth.denominator) * attributeOne);
    }

    PerChannel<bool> isDivided;
    Integer area;
    BigInteger product = 1;
    BigInteger scale = 1;
};

} // namespace pixelplumb
