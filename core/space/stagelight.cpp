// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/stagelight.h"

#include "core/space/attributenumber.h"
#include "core/space/stagenumbers.h"

#include <QStringList>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

QString normalName(QChar axis) { return axis + u"_N"_s; }

void addUnit(StageNumberWriter &numbers, const QString &subscript, const SpaceVector<double> &used,
             const SpaceVector<ExactReal> &exact, const Component &component)
{
    numbers.add(subscript, used, &exact, unitOf(used, component));
}

/// "S_0" for the position of a light, "d_0" for the direction in which it shines.
QString sourceName(const Light &light, std::size_t index)
{
    return (light.kind == Light::Kind::Positional ? u"S_%1"_s : u"d_%1"_s).arg(index);
}

/// The vector from the point to a position, or the direction itself.
Component wayTo(Light::Kind kind, const QString &name)
{
    return [=](QChar axis) {
        return kind == Light::Kind::Positional ? u"(%1%2 − %2)"_s.arg(name, QString(axis))
                                               : name + axis;
    };
}

Component against(const QString &direction)
{
    return [=](QChar axis) { return u"(−%1%2)"_s.arg(direction, QString(axis)); };
}

/// "light_0R·NL_0 + light_1R·NL_1".
QString sumOverLights(std::size_t count, QChar channel, const QString &term)
{
    QStringList products;
    for (std::size_t i = 0; i < count; ++i)
        products.append(u"light_%1%2·%3_%1"_s.arg(i).arg(channel).arg(term));
    return products.join(u" + "_s);
}

void writeLights(StagePoint &point, const Appearance &appearance, const Material &material)
{
    StageNumberWriter numbers(point.numbers);
    const auto given
        = [&](const QString &name, double value) { numbers.add(name, value, ExactReal(value)); };
    const auto vector = [&](const QString &name, const std::array<Attribute, 3> &at) {
        const auto exact = spaceVectorOf<ExactReal>(at);
        numbers.add([&](QChar axis) { return name + axis; }, spaceVectorOf<double>(at), &exact);
    };
    const auto colour = [&](const QString &name, const Colour &levels) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            given(name + channelLetters[channel], levels.channels[channel]);
    };
    vector("viewer_", appearance.viewer);
    colour("ambient_", appearance.ambient);
    colour("specular_", material.specular);
    for (std::size_t i = 0; i < appearance.lights.size(); ++i) {
        vector(sourceName(appearance.lights[i], i), appearance.lights[i].at);
        colour(u"light_%1"_s.arg(i), appearance.lights[i].colour);
    }
}

/// The formula of a lit colour, by its name.
using BaseFormula = std::function<QString(const QString &base)>;

void writeLightAt(StagePoint &point, const Appearance &appearance, const Material &material,
                  const LitColour<double> &used, const LitColour<ExactReal> &exact,
                  const BaseFormula &baseFormula)
{
    StageNumberWriter numbers(point.numbers);
    for (std::size_t i = 0; i < appearance.lights.size(); ++i) {
        const Light &light = appearance.lights[i];
        const auto usedTerm = lightTerm(appearance, light, material.shininess, used.point);
        const auto exactTerm = lightTerm(appearance, light, material.shininess, exact.point);
        const auto usedVectors = lightVectors(appearance, light, used.point);
        const auto exactVectors = lightVectors(appearance, light, exact.point);
        if (i == 0) {
            addUnit(numbers, "_n", usedVectors.normal, exactVectors.normal, normalName);
            addUnit(numbers, "_V", usedVectors.toViewer, exactVectors.toViewer,
                    wayTo(appearance.viewerKind, "viewer_"));
        }
        const QString source = sourceName(light, i);
        addUnit(numbers, u"_L%1"_s.arg(i), usedVectors.toLight, exactVectors.toLight,
                light.kind == Light::Kind::Positional ? wayTo(light.kind, source)
                                                      : against(source));
        addUnit(numbers, u"_H%1"_s.arg(i), usedVectors.halfway, exactVectors.halfway,
                [i](QChar axis) { return u"(%1_L%2 + %1_V)"_s.arg(axis).arg(i); });
        numbers.add(u"NL_%1"_s.arg(i), usedTerm.diffuse, exactTerm.diffuse,
                    u"max(0, x_n·x_L%1 + y_n·y_L%1 + z_n·z_L%1)"_s.arg(i));
        numbers.add(
            u"highlight_%1"_s.arg(i), usedTerm.specular, exactTerm.specular,
            usedTerm.diffuse > 0
                ? u"max(0, x_n·x_H%1 + y_n·y_H%1 + z_n·z_H%1)^%2"_s.arg(i).arg(material.shininess)
                : u"0"_s);
    }
    const auto usedLevels = litLevels(appearance, material, used.colour, used.point);
    const auto exactLevels = litLevels(appearance, material, exact.colour, exact.point);
    const std::size_t lights = appearance.lights.size();
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const QChar letter = channelLetters[channel];
        const QString base = u"base_"_s + letter;
        const QString level = u"I_"_s + letter;
        numbers.add(base, used.colour.channels[channel], ExactReal(exact.colour.channels[channel]),
                    baseFormula(base));
        numbers.add(
            level, usedLevels[channel], exactLevels[channel],
            u"(%1·(ambient_%2 + %3) + specular_%2·(%4))/255"_s.arg(base).arg(letter).arg(
                sumOverLights(lights, letter, "NL"), sumOverLights(lights, letter, "highlight")));
        numbers.add(u"s_"_s + letter, levelByte(usedLevels[channel]),
                    ExactReal(levelByte(exactLevels[channel])), u"min(255, ⌊%1 + ½⌋)"_s.arg(level));
    }
}

} // namespace

void writeTint(StagePoint &point, const Colour &given, const Colour &diffuse)
{
    StageNumberWriter numbers(point.numbers);
    const Colour base = tinted(given, diffuse);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const QChar letter = channelLetters[channel];
        const auto add = [&](const QString &name, const Colour &colour, const QString &formula) {
            numbers.add(name + letter, colour.channels[channel],
                        ExactReal(colour.channels[channel]), formula);
        };
        add("c_", given, {});
        add("diffuse_", diffuse, {});
        add("base_", base, u"⌊c_%·diffuse_%/255 + ½⌋"_s.replace(u'%', letter));
    }
}

ProjectionStage lightStageOf(const LitPart &part, const std::vector<LitColour<double>> &used,
                             const std::vector<LitColour<ExactReal>> &exact)
{
    const bool isFlat = part.appearance.shading == Shading::Flat;
    ProjectionStage stage{isFlat ? u"Light at the face's centre"_s : u"Light at the vertices"_s,
                          "c·(ambient + Σ light·max(0, N·L))/255 + Σ light·specular/255·(N·H)ˢ",
                          {}};
    writeLights(stage.points.emplace_back(StagePoint{lightsPointName(), {}, {}}), part.appearance,
                part.material);
    const BaseFormula baseFormula = [&](const QString &base) {
        if (!isFlat)
            return base + u'′';
        const QString sum = sumOverVertices(part.vertices, base);
        return sum.isEmpty() ? sum : u"⌊(%1)/%2 + ½⌋"_s.arg(sum).arg(part.vertices);
    };
    for (std::size_t i = 0; i < used.size(); ++i) {
        StagePoint &point = stage.points.emplace_back(
            StagePoint{isFlat ? u"centre"_s : faceVertexName(i), {}, {}});
        if (isFlat) { // a vertex has them in the previous stage
            StageNumberWriter numbers(point.numbers);
            numbers.add(QString(), used[i].point.place, &exact[i].point.place, part.centrePlace);
            numbers.add("_N", used[i].point.normal, &exact[i].point.normal, part.centreNormal);
        }
        writeLightAt(point, part.appearance, part.material, used[i], exact[i], baseFormula);
    }
    return stage;
}

std::vector<ProjectionStage> lightStagesOf(const Triangle &given,
                                           const TriangleAttributes &attributes,
                                           const Appearance &appearance)
{
    const Material &material = materialOf(appearance, attributes.material);
    ProjectionStage corners{
        "Vertex",
        "The triangle's vertices, in px, their normals and their colours, times the material's",
        {}};
    for (std::size_t i = 0; i < 3; ++i) {
        StagePoint &point = corners.points.emplace_back(StagePoint{faceVertexName(i), {}, {}});
        StageNumberWriter numbers(point.numbers);
        const VertexAttributes &vertex = attributes.vertices[i];
        const auto place = spaceVectorOf<ExactReal>(vertex.place);
        const auto normal = spaceVectorOf<ExactReal>(vertex.normal);
        const auto usedNormal = spaceVectorOf<double>(vertex.normal);
        numbers.add(QString(), spaceVectorOf<double>(vertex.place), &place);
        numbers.add("_N", usedNormal, &normal);
        if (appearance.shading == Shading::Flat)
            addUnit(numbers, "_n", unit(usedNormal), unit(normal), normalName);
        writeTint(point, given.vertices[i].colour, material.diffuse);
    }
    Triangle tintedTriangle = given;
    tint(tintedTriangle, material);
    const Component third = [](QChar axis) {
        return u"1/3·%1 + 1/3·%2 + 1/3·%3"_s.arg(ofVertex(0, axis), ofVertex(1, axis),
                                                 ofVertex(2, axis));
    };
    const Component sumOfNormals = [](QChar axis) { return sumOverVertices(3, axis + u"_n"_s); };
    const LitPart part{appearance, material, 3, third, sumOfNormals};
    return {corners,
            lightStageOf(part, litColoursOf<double>(tintedTriangle, attributes, appearance.shading),
                         litColoursOf<ExactReal>(tintedTriangle, attributes, appearance.shading))};
}

} // namespace pixelplumb
