// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/lighttruth.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>

namespace pixelplumb::oracle {

namespace {

/// 168 bits.
using Real = boost::multiprecision::cpp_bin_float_50;

BigInteger dot(const Direction &a, const Direction &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Direction numeratorsOf(const std::array<WideFraction, 3> &vector)
{
    return {vector[0].numerator, vector[1].numerator, vector[2].numerator};
}

/// From a place in fractions to a target in whole numbers, multiplied by the denominator.
Direction towards(const std::array<Attribute, 3> &target, const std::array<WideFraction, 3> &place)
{
    Direction direction;
    for (std::size_t i = 0; i < 3; ++i)
        direction[i] = target[i] * place[i].denominator - place[i].numerator;
    return direction;
}

Direction towardsLight(const Light &light, const std::array<WideFraction, 3> &place)
{
    if (light.kind == Light::Kind::Positional)
        return towards(light.at, place);
    return {-BigInteger(light.at[0]), -BigInteger(light.at[1]), -BigInteger(light.at[2])};
}

Direction towardsViewer(const Appearance &appearance, const std::array<WideFraction, 3> &place)
{
    if (appearance.viewerKind == Light::Kind::Positional)
        return towards(appearance.viewer, place);
    return {appearance.viewer[0], appearance.viewer[1], appearance.viewer[2]};
}

/// max(0, N·H) for directions with N·L > 0 and H = unit(L/|L| + V/|V|). With h = |V|·L + |L|·V: N·h
/// = |V|·(N·L) + |L|·(N·V) and |h|² = 2·|L||V|·(|L||V| + L·V). Where a sum would cancel, it is
/// computed as (a² − b²)/(a − b), whose numerator is a whole number: every term is right to 160
/// bits.
Real highlightCosine(const Direction &normal, const Direction &light, const Direction &viewer)
{
    const BigInteger lightSquare = dot(light, light);
    const BigInteger viewerSquare = dot(viewer, viewer);
    const BigInteger normalLight = dot(normal, light);
    const BigInteger normalViewer = dot(normal, viewer);
    const BigInteger lightViewer = dot(light, viewer);

    const Real lightPart = sqrt(Real(viewerSquare)) * Real(normalLight);
    const Real viewerPart = sqrt(Real(lightSquare)) * Real(normalViewer);
    Real along = lightPart + viewerPart;
    if (normalViewer < 0) {
        const BigInteger squares
            = normalLight * normalLight * viewerSquare - normalViewer * normalViewer * lightSquare;
        if (squares <= 0)
            return 0;
        along = Real(squares) / (lightPart - viewerPart);
    }
    const Real lengths = sqrt(Real(BigInteger(lightSquare * viewerSquare)));
    Real sum = lengths + Real(lightViewer);
    if (lightViewer < 0) {
        const BigInteger squares = lightSquare * viewerSquare - lightViewer * lightViewer;
        sum = Real(squares) / (lengths - Real(lightViewer));
    }
    if (sum == 0) // no viewer, or exactly opposite the light
        return 0;
    return along / sqrt(Real(dot(normal, normal)) * 2 * lengths * sum);
}

struct Cosines {
    Real diffuse = 0;
    Real highlight = 0;
};

Cosines cosinesOf(const Direction &normal, const Direction &light, const Direction &viewer,
                  int shininess)
{
    const BigInteger normalLight = dot(normal, light);
    if (normalLight <= 0)
        return {};
    const BigInteger squares = dot(normal, normal) * dot(light, light);
    return {Real(normalLight) / sqrt(Real(squares)),
            pow(highlightCosine(normal, light, viewer), shininess)};
}

} // namespace

LitColour litColour(const Colour &colour, const std::array<WideFraction, 3> &normal,
                    const std::array<WideFraction, 3> &place, const Appearance &appearance,
                    const Material *material)
{
    static const Material plain;
    const Material &lit = material ? *material : plain;
    const Direction viewer = towardsViewer(appearance, place);
    std::vector<Cosines> cosines;
    LitColour result;
    for (const Light &light : appearance.lights) {
        cosines.push_back(cosinesOf(numeratorsOf(normal), towardsLight(light, place), viewer,
                                    std::max(lit.shininess, 1)));
        result.lights.push_back({cosines.back().diffuse.convert_to<double>(),
                                 cosines.back().highlight.convert_to<double>()});
    }
    // More than the errors of all roots, powers and sums for levels below 2^13.
    const Real smallest = ldexp(Real(1), -120);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        Real diffuse = appearance.ambient.channels[channel];
        Real highlight = 0;
        for (std::size_t i = 0; i < cosines.size(); ++i) {
            const Real intensity = appearance.lights[i].colour.channels[channel];
            diffuse += intensity * cosines[i].diffuse;
            highlight += intensity * cosines[i].highlight;
        }
        const Real level
            = (colour.channels[channel] * diffuse + lit.specular.channels[channel] * highlight)
            / 255;
        const Real raised = level + Real(0.5);
        const Real nearest = floor(raised + Real(0.5));
        const bool isTie = abs(raised - nearest) < smallest;
        const Real byte = isTie ? nearest : floor(raised);
        result.undecided = result.undecided || (isTie && nearest >= 1 && nearest <= 255);
        result.levels[channel] = level.convert_to<double>();
        result.colour.channels[channel] = byte > 255 ? 255 : std::uint8_t(byte.convert_to<int>());
    }
    return result;
}

} // namespace pixelplumb::oracle
