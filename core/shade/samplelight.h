// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/levelpixel.h"
#include "core/geometry/appearance.h"
#include "core/number/naturalpower.h"
#include "core/number/wholenumber.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

/// Light at one point by Blinn's formula (Blinn 1977; resources/sources.md). Every term is kept for
/// display.
namespace pixelplumb {

template <class Real>
using Vector = std::array<Real, 3>;

template <class Real>
Real dot(const Vector<Real> &a, const Vector<Real> &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
Real largestMagnitude(const Vector<Real> &vector)
{
    return std::max({std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2])});
}

/// Scaled to length 1; 0 stays 0. Divided by its largest part first, so that no square leaves the
/// range of the number.
template <class Real>
Vector<Real> unitVector(Vector<Real> vector)
{
    const Real largest = largestMagnitude(vector);
    if (!(largest > 0) || !std::isfinite(largest))
        return {};
    for (Real &each : vector)
        each /= largest;
    const Real length = std::sqrt(dot(vector, vector));
    for (Real &each : vector)
        each /= length;
    return vector;
}

/// The length by which unitVector() divides, in two steps; 0 where that gives 0.
template <class Real>
Real lengthOf(Vector<Real> vector)
{
    const Real largest = largestMagnitude(vector);
    if (!(largest > 0) || !std::isfinite(largest))
        return 0;
    for (Real &each : vector)
        each /= largest;
    return largest * std::sqrt(dot(vector, vector));
}

/// The unit vector halfway between two directions; 0 where one of them is 0.
template <class Real>
Vector<Real> halfwayOf(const Vector<Real> &a, const Vector<Real> &b)
{
    if (a == Vector<Real>{} || b == Vector<Real>{})
        return {};
    return unitVector<Real>({a[0] + b[0], a[1] + b[1], a[2] + b[2]});
}

template <class Real>
Vector<Real> realVector(const std::array<Attribute, 3> &units)
{
    Vector<Real> vector;
    for (std::size_t i = 0; i < 3; ++i)
        vector[i] = Real(double(units[i]) / double(attributeOne));
    return vector;
}

/// The contribution of one light.
template <class Real>
struct SampleLightTerm {
    Vector<Real> toLight; ///< L, of length 1
    Vector<Real> halfway; ///< H, of length 1
    Real diffuse; ///< max(0, N·L)
    Real facing; ///< max(0, N·H)
    Real highlight; ///< facing to the power of the shininess, 0 where N·L is not positive
};

/// Light at a sample.
template <class Real>
struct LitSample {
    Vector<Real> place; ///< p
    Vector<Real> carried; ///< N as interpolated, of any length
    Vector<Real> normal; ///< n, of length 1
    Vector<Real> toViewer; ///< V, of length 1
    std::array<SampleLightTerm<Real>, mostLights> terms; ///< one for each light
    std::array<Real, 3> level; ///< before rounding
    Colour colour; ///< rounded, clamped
    bool clamped = false;
};

/// The lights of a scene in the kernel's numbers, made once per run.
template <class Real>
struct Lighting {
    /// The direction from a point to a light or viewer: the same everywhere, or towards a place.
    struct Way {
        Light::Kind kind = Light::Kind::Directional;
        Vector<Real> at = {}; ///< the direction, of length 1, or the place

        Vector<Real> from(const Vector<Real> &point) const
        {
            if (kind == Light::Kind::Directional)
                return at;
            return unitVector<Real>({at[0] - point[0], at[1] - point[1], at[2] - point[2]});
        }
    };
    struct Source {
        Way way;
        std::array<Real, 3> colour = {}; ///< levels
        Vector<Real> halfway = {}; ///< to the viewer, where it is the same from every point
    };

    std::array<Source, mostLights> sources;
    std::size_t count = 0;
    Way viewer;
    std::array<Real, 3> ambient = {}; ///< levels

    explicit Lighting(const Appearance &appearance)
        : count(std::min(appearance.lights.size(), mostLights))
        , viewer(wayTo(appearance.viewerKind, appearance.viewer, Real(1)))
    {
        for (std::size_t i = 0; i < 3; ++i)
            ambient[i] = Real(appearance.ambient.channels[i]);
        for (std::size_t light = 0; light < count; ++light) {
            const Light &from = appearance.lights[light];
            sources[light].way = wayTo(from.kind, from.at, Real(-1)); // against its direction
            for (std::size_t i = 0; i < 3; ++i)
                sources[light].colour[i] = Real(from.colour.channels[i]);
            if (isHalfwaySame(sources[light]))
                sources[light].halfway = halfwayOf(sources[light].way.at, viewer.at);
        }
    }

    /// True if light and viewer are both far away.
    bool isHalfwaySame(const Source &source) const
    {
        return source.way.kind == Light::Kind::Directional
            && viewer.kind == Light::Kind::Directional;
    }

private:
    static Way wayTo(Light::Kind kind, const std::array<Attribute, 3> &at, Real sign)
    {
        Vector<Real> vector = realVector<Real>(at);
        if (kind == Light::Kind::Positional)
            return {kind, vector};
        for (Real &each : vector)
            each *= sign;
        return {kind, unitVector(vector)};
    }
};

/// The light that a point of a surface sends to the viewer:
/// c·(ambient + Σ light·max(0, N·L))/255 + Σ light·specular/255·max(0, N·H)^shininess.
template <class Real>
void lightSample(const Lighting<Real> &lighting, const Material &material, const Colour &surface,
                 const Vector<Real> &normal, LitSample<Real> &lit)
{
    lit.carried = normal;
    lit.normal = unitVector(normal);
    lit.toViewer = lighting.viewer.from(lit.place);
    std::array<Real, 3> arriving = lighting.ambient;
    std::array<Real, 3> reflected = {};
    for (std::size_t index = 0; index < lighting.count; ++index) {
        const auto &source = lighting.sources[index];
        SampleLightTerm<Real> &term = lit.terms[index];
        term.toLight = source.way.from(lit.place);
        term.halfway = lighting.isHalfwaySame(source) ? source.halfway
                                                      : halfwayOf(term.toLight, lit.toViewer);
        term.diffuse = std::max(Real(0), dot(lit.normal, term.toLight));
        term.facing = std::max(Real(0), dot(lit.normal, term.halfway));
        term.highlight = term.diffuse > 0 ? naturalPower(term.facing, material.shininess) : Real(0);
        for (std::size_t i = 0; i < 3; ++i) {
            arriving[i] += source.colour[i] * term.diffuse;
            reflected[i] += source.colour[i] * term.highlight;
        }
    }
    lit.clamped = false;
    for (std::size_t i = 0; i < 3; ++i) {
        lit.level[i] = Real(surface.channels[i]) * arriving[i] / 255
            + Real(material.specular.channels[i]) * reflected[i] / 255;
        const std::int64_t byte = floorOf(lit.level[i] + Real(0.5));
        lit.clamped |= byte > 255;
        lit.colour.channels[i] = std::uint8_t(clampedByte(byte));
    }
}

} // namespace pixelplumb
