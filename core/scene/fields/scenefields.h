// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framenames.h"
#include "core/scan/variants.h"
#include "core/scene/appearancenames.h"
#include "core/scene/fields/jsonfields.h"
#include "core/scene/scene.h"

#include <QStringList>

#include <limits>

/// The names of a scene's fields in files: one list for each part, used to read and to write it,
/// and by forms, in this order. A field that is left out has its default.
namespace pixelplumb {

/// A field that may not be left out.
template <class Value>
struct Required {
    Value value;
};
template <class Value>
Required(Value &&) -> Required<Value>; // a reference to a value that has a name

/// A whole number in [first, last].
template <class Number>
struct NumberWithin {
    Number &number;
    std::int64_t first;
    std::int64_t last;
};
template <class Number>
NumberWithin(Number &, std::int64_t, std::int64_t) -> NumberWithin<Number>;

/// A number between two bounds, both excluded.
template <class Number>
struct NumberBetween {
    Number &number;
    double above = 0;
    double below = std::numeric_limits<double>::infinity();
};
template <class Number, class... Bounds>
NumberBetween(Number &, Bounds...) -> NumberBetween<Number>;

/// One of several choices.
template <class Choice, class Choices>
struct ChoiceOf {
    Choice &choice;
    const Choices &all;
};
template <class Choice, class Choices>
ChoiceOf(Choice &, const Choices &) -> ChoiceOf<Choice, Choices>;

/// The frame's first pixel; written where it is not (0, 0).
template <class Frame>
struct FirstPixelOf {
    Frame &frame;
};
template <class Frame>
FirstPixelOf(Frame &) -> FirstPixelOf<Frame>;

template <PartOf<FrameSpec> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("width", Required{NumberWithin{self.width, 1, largestFrameSide}});
    visit("height", Required{NumberWithin{self.height, 1, largestFrameSide}});
    visit("background", self.background);
    visit("origin", ChoiceOf{self.origin, allFrameOrigins});
    visit("pixelCentre", ChoiceOf{self.pixelCentre, allPixelCentres});
    visit("firstPixel", FirstPixelOf{self});
}

template <PartOf<Motion> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("by", Required{self.by});
    visit("frames", Required{NumberWithin{self.frames, 2, largestFrameCount}});
}

template <PartOf<Material> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("texture", self.texture);
    visit("filter", ChoiceOf{self.filter, allTextureFilters});
    visit("wrap", ChoiceOf{self.wrap, allTextureWraps});
    visit("diffuse", self.diffuse);
    visit("specular", self.specular);
    visit("shininess", NumberWithin{self.shininess, 1, mostShininess});
}

/// Of a light that shines along a direction or stands at a position.
template <PartOf<Light> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit(self.kind == Light::Kind::Directional ? "direction" : "position", self.at);
    visit("color", self.colour);
}

template <PartOf<Appearance> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("materials", self.materials);
    visit("lights", self.lights);
    visit("ambient", self.ambient);
    visit("shading", ChoiceOf{self.shading, allShadings});
    visit("depth", ChoiceOf{self.depth, allDepthUses});
    visit("depthBits", ChoiceOf{self.depthFormat, allDepthFormats});
    visit("antialiasing", ChoiceOf{self.antialiasing, allAntialiasings});
}

/// Without the field of the other projection.
template <PartOf<Camera> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("projection", ChoiceOf{self.projection, allProjections});
    visit("eye", self.eye);
    visit("target", self.target);
    visit("up", self.up);
    if (self.projection == Projection::Perspective)
        visit("fieldOfView", NumberBetween{self.fieldOfView, 0.0, 180.0});
    else
        visit("height", NumberBetween{self.height});
    visit("near", NumberBetween{self.near});
    visit("far", NumberBetween{self.far});
}

/// What a scene says before its primitives, without its appearance.
template <PartOf<Scene> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("frame", Required{self.frame});
    visit("method", self.method);
    visit("arithmetic", ChoiceOf{self.settings.arithmetic, allArithmetics});
    visit("fillRule", ChoiceOf{self.settings.fillRule, allFillRules});
    visit("offScreenPoint", self.frame.offScreenPoint);
    visit("rounding", ChoiceOf{self.settings.rounding, allByteRoundings});
    visit("variants", self.settings.variants);
    visit("camera", self.camera);
    visit("motion", self.motion);
}

template <class Part>
QStringList fieldNames(const Part &part = {})
{
    QStringList names;
    eachField(part, [&](const char *name, const auto &) { names.append(QLatin1String(name)); });
    return names;
}

} // namespace pixelplumb
