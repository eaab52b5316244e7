// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/scene/appearancenames.h"
#include "core/scene/fields/jsonfields.h"
#include "core/space/camera.h"

#include <QStringList>

/// The names of an appearance's and a camera's fields in files: one list for each part, used to
/// read and to write it, and by forms, in this order. A field that is left out has its default, and
/// defaults are left out.
namespace pixelplumb {

/// A number in [first, last].
template <class Number>
struct NumberWithin {
    Number &number;
    int first;
    int last;
};
template <class Number>
NumberWithin(Number &, int, int) -> NumberWithin<Number>;

/// One of several choices.
template <class Choice, class Choices>
struct ChoiceOf {
    Choice &choice;
    const Choices &all;
};
template <class Choice, class Choices>
ChoiceOf(Choice &, const Choices &) -> ChoiceOf<Choice, Choices>;

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
        visit("fieldOfView", self.fieldOfView);
    else
        visit("height", self.height);
    visit("near", self.near);
    visit("far", self.far);
}

template <class Part>
QStringList fieldNames()
{
    QStringList names;
    const Part part;
    eachField(part, [&](const char *name, const auto &) { names.append(QLatin1String(name)); });
    return names;
}

} // namespace pixelplumb
