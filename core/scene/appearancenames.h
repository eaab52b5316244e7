// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/space/solid.h"

#include <QtGlobal>

#include <array>
#include <string_view>

/// The names in files of what a scene says apart from its triangles.
namespace pixelplumb {

inline constexpr std::array allTextureFilters = {TextureFilter::Nearest, TextureFilter::Bilinear};
inline constexpr std::array allTextureWraps = {TextureWrap::Repeat, TextureWrap::Clamp};
inline constexpr std::array allShadings = {Shading::Flat, Shading::Gouraud, Shading::Phong};
inline constexpr std::array allDepthUses = {DepthUse::Auto, DepthUse::Off, DepthUse::On};
inline constexpr std::array allDepthFormats
    = {DepthFormat::Exact, DepthFormat::Bits16, DepthFormat::Bits24, DepthFormat::Bits32};
inline constexpr std::array allAntialiasings
    = {Antialiasing::None, Antialiasing::Samples4, Antialiasing::Samples16, Antialiasing::Area};
inline constexpr std::array allProjections = {Projection::Perspective, Projection::Orthographic};
inline constexpr std::array allSolidKinds
    = {SolidKind::Triangle3, SolidKind::Polygon3, SolidKind::Plane,
       SolidKind::Sphere,    SolidKind::Patch,    SolidKind::Mesh};

constexpr std::string_view nameOf(TextureFilter filter)
{
    return filter == TextureFilter::Nearest ? "nearest" : "bilinear";
}

constexpr std::string_view nameOf(TextureWrap wrap)
{
    return wrap == TextureWrap::Repeat ? "repeat" : "clamp";
}

constexpr std::string_view nameOf(Shading shading)
{
    constexpr std::array<std::string_view, 3> names = {"flat", "gouraud", "phong"};
    return names[std::size_t(shading)];
}

constexpr std::string_view nameOf(DepthUse use)
{
    constexpr std::array<std::string_view, 3> names = {"auto", "off", "on"};
    return names[std::size_t(use)];
}

/// Names that are numbers, such as "16", are written as numbers in files.
constexpr std::string_view nameOf(DepthFormat format)
{
    switch (format) {
    case DepthFormat::Bits16:
        return "16";
    case DepthFormat::Bits24:
        return "24";
    case DepthFormat::Bits32:
        return "32";
    case DepthFormat::Exact:
        break;
    }
    return "exact";
}

constexpr std::string_view nameOf(Antialiasing antialiasing)
{
    constexpr std::array<std::string_view, 4> names = {"1", "4", "16", "area"};
    return names[std::size_t(antialiasing)];
}

constexpr std::string_view nameOf(Projection projection)
{
    return projection == Projection::Perspective ? "perspective" : "orthographic";
}

/// The keys that name solids in files.
constexpr std::string_view nameOf(SolidKind kind)
{
    constexpr std::array<std::string_view, 6> names
        = {QT_TRANSLATE_NOOP("core", "triangle3"), QT_TRANSLATE_NOOP("core", "polygon3"),
           QT_TRANSLATE_NOOP("core", "plane"),     QT_TRANSLATE_NOOP("core", "sphere"),
           QT_TRANSLATE_NOOP("core", "patch"),     QT_TRANSLATE_NOOP("core", "mesh")};
    return names[std::size_t(kind)];
}

} // namespace pixelplumb
