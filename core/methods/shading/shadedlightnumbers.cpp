// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/shading/shadednumbers.h"
#include "core/methods/words/placenumbers.h"
#include "core/space/materialcolour.h"

#include <QStringList>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::array<QChar, 3> lightAxes = {u'x', u'y', u'z'};

bool isPlace(Light::Kind kind) { return kind == Light::Kind::Positional; }
bool isZero(const OfAxes &vector)
{
    return std::ranges::all_of(vector, [](const Quantity &each) { return each.toDouble() == 0; });
}

/// "S_0" for a light's position, "d_0" for the direction in which it shines.
QString sourceName(const Light &light, std::size_t index)
{
    return (isPlace(light.kind) ? u"S_%1"_s : u"d_%1"_s).arg(index);
}

/// "E_" for the viewer's position, "e_" for the direction towards it.
QString viewerName(Light::Kind kind) { return isPlace(kind) ? u"E_"_s : u"e_"_s; }

/// A component of a vector normalised to length 1; % stands for the axis.
QString unitFormula(const QString &title, QChar axis, const QString &component)
{
    const auto of
        = [&](QChar each) { return u'(' + QString(component).replace(u'%', each) + u')'; };
    return title + u" = "_s + of(axis) + u"/√("_s + of(u'x') + u"² + "_s + of(u'y') + u"² + "_s
        + of(u'z') + u"²)"_s;
}

/// The vector from the sample to something: to its position, or along a given direction.
QString wayFormula(Light::Kind kind, const QString &given, QStringView sign)
{
    return isPlace(kind) ? given + u"% − p_%"_s : sign.toString() + given + u'%';
}

/// "n_x·L_0x + n_y·L_0y + n_z·L_0z"
QString dotFormula(const QString &vector)
{
    return u"n_x·%x + n_y·%y + n_z·%z"_s.replace(u'%', vector);
}

/// Appends a number of a lit sample that was written singly.
void appendLit(NumberTable<ShadedSampleState> &table, const QString &title, const QString &toolTip,
               const QString &formula, const ReadOfSample &read,
               const NumberRow<ShadedSampleState>::Specify &specify = {})
{
    const QString id = QString(title).replace(u"|N|"_s, u"N_length"_s);
    table.push_back({comparedNumber(id, title, {}, toolTip, formula, NumberGroup::FirstColour),
                     ofWritten([read](const ShadedSampleState &state) {
                         return state.effects.light ? read(state) : Quantity();
                     }),
                     specify});
}

/// The components of a vector of length 1, each with its formula if the vector has a length.
void appendUnit(NumberTable<ShadedSampleState> &table, const QString &name, const QString &what,
                const QString &component,
                const std::function<const OfAxes &(const ShadedSampleState &)> &read)
{
    for (std::size_t i = 0; i < lightAxes.size(); ++i) {
        const QString title = name + lightAxes[i];
        appendLit(
            table, title, u"%1, made of length 1: its %2."_s.arg(what, lightAxes[i]),
            unitFormula(title, lightAxes[i], component),
            [=](const ShadedSampleState &state) { return read(state)[i]; },
            [=](NumberDescription &number, const ShadedSampleState &state) {
                if (isZero(read(state)))
                    number.formula = title + u" = 0"_s;
            });
    }
}

void appendNormal(NumberTable<ShadedSampleState> &table)
{
    appendLit(table, "|N|", "The length of the normal N as it was interpolated.",
              "|N| = √(N_x² + N_y² + N_z²)",
              [](const ShadedSampleState &state) { return state.normalLength; });
    for (std::size_t i = 0; i < lightAxes.size(); ++i) {
        const QString title = u"n_"_s + lightAxes[i];
        appendLit(
            table, title, u"The normal, made of length 1: its %1."_s.arg(lightAxes[i]),
            u"n_% = N_%/|N|"_s.replace(u'%', lightAxes[i]),
            [i](const ShadedSampleState &state) { return state.normal[i]; },
            [title](NumberDescription &number, const ShadedSampleState &state) {
                if (state.normalLength.toDouble() == 0)
                    number.formula = title + u" = 0"_s;
            });
    }
}

/// What one light adds: L, N·L, H, N·H and its power.
void appendTerm(NumberTable<ShadedSampleState> &table, const Light &light, std::size_t index)
{
    const auto term = [index](const ShadedSampleState &state) -> const ShadedLightState & {
        return state.lights[index];
    };
    const auto named
        = [index](const char *pattern) { return QString::fromUtf8(pattern).arg(index); };
    appendUnit(
        table, named("L_%1"), named("The way to light %1"),
        wayFormula(light.kind, sourceName(light, index), u"−"),
        [=](const ShadedSampleState &state) -> const OfAxes & { return term(state).toLight; });
    const QString diffuse = named("NL_%1");
    appendLit(table, diffuse, named("max(0, N·L) of light %1: what of it meets the surface."),
              diffuse + u" = max(0, "_s + dotFormula(named("L_%1")) + u')',
              [=](const ShadedSampleState &state) { return term(state).diffuse; });
    appendUnit(
        table, named("H_%1"), named("Halfway between the ways to light %1 and to the viewer"),
        named("L_%1") + u"% + V_%"_s,
        [=](const ShadedSampleState &state) -> const OfAxes & { return term(state).halfway; });
    const QString facing = named("NH_%1");
    appendLit(table, facing, named("max(0, N·H) of light %1: how far its highlight is in sight."),
              facing + u" = max(0, "_s + dotFormula(named("H_%1")) + u')',
              [=](const ShadedSampleState &state) { return term(state).facing; });
    const QString highlight = named("highlight_%1");
    appendLit(
        table, highlight,
        named("max(0, N·H) to the power of the shininess, of light %1; 0 where N·L is."),
        highlight + u" = "_s + facing + u"^shininess"_s,
        [=](const ShadedSampleState &state) { return term(state).highlight; },
        [=](NumberDescription &number, const ShadedSampleState &state) {
            if (term(state).diffuse.toDouble() == 0)
                number.formula = highlight + u" = 0"_s;
        });
}

/// The light that leaves the surface; `surface` is the letter of its colour.
void appendLevels(NumberTable<ShadedSampleState> &table, const QString &surface, std::size_t lights)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const QChar channel = channelLetters[i];
        QString arriving = u"ambient_"_s + channel;
        QStringList reflected;
        for (std::size_t light = 0; light < lights; ++light) {
            const QString level = u"light_%1%2"_s.arg(light).arg(channel);
            arriving += u" + %1·NL_%2"_s.arg(level).arg(light);
            reflected.append(u"%1·highlight_%2"_s.arg(level).arg(light));
        }
        const QString title = u"I_"_s + channel;
        appendLit(table, title,
                  u"Light that leaves the surface, level of %1, before rounding."_s.arg(channel),
                  u"%1 = %2·(%3)/255 + specular_%4·(%5)/255"_s.arg(
                      title, surface + u'_' + channel, arriving, channel, reflected.join(u" + "_s)),
                  [i](const ShadedSampleState &state) { return state.lit[i]; });
    }
}

/// A number that the scene gives for computing its lights.
void appendGiven(NumberTable<ShadedSetUpState> &table, const QString &title, const QString &unit,
                 const QString &toolTip,
                 const std::function<Quantity(const ShadedSetUpState &)> &read)
{
    table.push_back({plainNumber(title, title, unit, toolTip, {}, NumberGroup::ColourRates),
                     [read](const ShadedSetUpState &state) {
                         return state.effects.light ? read(state) : Quantity();
                     }});
}

void appendVector(NumberTable<ShadedSetUpState> &table, const QString &name, const QString &what,
                  const std::array<Attribute, 3> &vector)
{
    for (std::size_t i = 0; i < lightAxes.size(); ++i)
        appendGiven(table, name + lightAxes[i], {}, u"%1: its %2."_s.arg(what, lightAxes[i]),
                    [value = Quantity::rational(vector[i], attributeOne)](
                        const ShadedSetUpState &) { return value; });
}

void appendColour(NumberTable<ShadedSetUpState> &table, const QString &name, const QString &what,
                  const std::function<Colour(const ShadedSetUpState &)> &read)
{
    for (std::size_t i = 0; i < 3; ++i)
        appendGiven(table, name + QChar(channelLetters[i]), "levels",
                    u"%1: its %2."_s.arg(what, QChar(channelLetters[i])),
                    [=](const ShadedSetUpState &state) {
                        return Quantity::integer(read(state).channels[i]);
                    });
}

} // namespace

void appendLightSources(NumberTable<ShadedSetUpState> &table,
                        const std::shared_ptr<const Appearance> &appearance)
{
    const auto always = [](const Colour &colour) {
        return [colour](const ShadedSetUpState &) { return colour; };
    };
    appendVector(table, viewerName(appearance->viewerKind),
                 isPlace(appearance->viewerKind) ? u"Where the viewer stands"_s
                                                 : u"The direction to the viewer"_s,
                 appearance->viewer);
    for (std::size_t i = 0; i < appearance->lights.size(); ++i) {
        const Light &light = appearance->lights[i];
        appendVector(table, sourceName(light, i),
                     (isPlace(light.kind) ? u"Where light %1 stands"_s
                                          : u"The direction in which light %1 shines"_s)
                         .arg(i),
                     light.at);
        appendColour(table, u"light_%1"_s.arg(i), u"The colour of light %1"_s.arg(i),
                     always(light.colour));
    }
    appendColour(table, "ambient_", "Light from everywhere", always(appearance->ambient));
    appendColour(table, "specular_", "What the material reflects as a highlight",
                 [appearance](const ShadedSetUpState &state) {
                     return materialOf(*appearance, state.material).specular;
                 });
    appendGiven(table, "shininess", {}, "The exponent of the material's highlight.",
                [appearance](const ShadedSetUpState &state) {
                    return Quantity::integer(materialOf(*appearance, state.material).shininess);
                });
}

void appendLight(NumberTable<ShadedSampleState> &table, const ShadedScope &scope)
{
    const Appearance &appearance = *scope.appearance;
    appendNormal(table);
    appendUnit(table, "V_", "The way to the viewer",
               wayFormula(appearance.viewerKind, viewerName(appearance.viewerKind), {}),
               [](const ShadedSampleState &state) -> const OfAxes & { return state.toViewer; });
    const std::size_t lights = std::min(appearance.lights.size(), mostLights);
    for (std::size_t i = 0; i < lights; ++i)
        appendTerm(table, appearance.lights[i], i);
    appendLevels(table, scope.effects.texture ? u"mod"_s : u"base"_s, lights);
}

} // namespace pixelplumb
