// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/scenedefect.h"

#include "core/runs/scenerun.h"

#include <algorithm>
#include <array>

namespace pixelplumb {

namespace {

using MoveVertex = void (*)(LatticePoint &point);

Lattice truncated(Lattice coordinate) { return floorPixel(coordinate) * unitsPerPixel; }

Lattice nearest(Lattice coordinate) { return truncated(coordinate + unitsPerPixel / 2); }

void appendPlaces(std::vector<Defect> &defects, const Scene &scene)
{
    QString choice;
    const auto add
        = [&](const char *id, const char *forStudent, const char *forAssistant, MoveVertex move) {
              appendWhereItApplies(defects, scene, choice,
                                   {QString::fromLatin1(id), QString::fromUtf8(forStudent),
                                    QString::fromUtf8(forAssistant), [move](Scene &changed) {
                                        for (Triangle &triangle : changed.triangles) {
                                            for (Vertex &vertex : triangle.vertices)
                                                move(vertex.position);
                                        }
                                        return true;
                                    }});
          };
    choice = u"places"_s;
    constexpr const char *places = "Do vertices between pixels keep their places?";
    add("vertices-truncated", places, "Vertices are cast to whole pixels.",
        [](LatticePoint &point) {
            point = {truncated(point.x), truncated(point.y)};
        });
    add("vertices-rounded", places, "Vertices are rounded to whole pixels.",
        [](LatticePoint &point) {
            point = {nearest(point.x), nearest(point.y)};
        });
    add("x-truncated", places, "x of the vertices is cast to whole pixels, y is not.",
        [](LatticePoint &point) { point.x = truncated(point.x); });
    add("y-truncated", places, "y of the vertices is cast to whole pixels, x is not.",
        [](LatticePoint &point) { point.y = truncated(point.y); });
    add("coordinates-in-16-bits", "How large do your numbers get, and what holds them?",
        "x and y of the vertices are kept in 16 bits, 8 of them behind the point: from 128 px on "
        "they wrap to −128.",
        [](LatticePoint &point) {
            static_assert(unitsPerPixel == 256);
            point = {std::int16_t(point.x), std::int16_t(point.y)};
        });
    choice = u"centre"_s;
    constexpr const char *centre = "Where in a pixel is its sample?";
    constexpr Lattice half = unitsPerPixel / 2;
    add("half-pixel-down", centre, "Samples stand half a pixel towards larger x and y.",
        [](LatticePoint &point) {
            point = {point.x - half, point.y - half};
        });
    add("half-pixel-up", centre, "Samples stand half a pixel towards smaller x and y.",
        [](LatticePoint &point) {
            point = {point.x + half, point.y + half};
        });
    add("half-pixel-down-in-x", centre,
        "Samples stand half a pixel towards larger x; in y they are in their places.",
        [](LatticePoint &point) { point.x -= half; });
    add("half-pixel-up-in-x", centre,
        "Samples stand half a pixel towards smaller x; in y they are in their places.",
        [](LatticePoint &point) { point.x += half; });
    add("half-pixel-down-in-y", centre,
        "Samples stand half a pixel towards larger y; in x they are in their places.",
        [](LatticePoint &point) { point.y -= half; });
    add("half-pixel-up-in-y", centre,
        "Samples stand half a pixel towards smaller y; in x they are in their places.",
        [](LatticePoint &point) { point.y += half; });
}

/// Gives all vertices the mean of their colours.
void takeMean(Triangle &triangle, ByteRounding rounding)
{
    Colour mean;
    for (std::size_t i = 0; i < 3; ++i) {
        int sum = rounding == ByteRounding::Nearest ? 1 : 0; // halves do not occur in thirds
        for (const Vertex &vertex : triangle.vertices)
            sum += vertex.colour.channels[i];
        mean.channels[i] = std::uint8_t(sum / 3);
    }
    for (Vertex &vertex : triangle.vertices)
        vertex.colour = mean;
}

void appendColours(std::vector<Defect> &defects, const Scene &scene)
{
    constexpr std::array<std::array<std::size_t, 3>, 5> orders
        = {{{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
    using Change = std::function<void(Triangle & triangle, ByteRounding rounding)>;
    QString question = u"Which vertex has which colour?"_s;
    const auto add = [&](const QString &id, const QString &forAssistant, const Change &change) {
        appendWhereItApplies(defects, scene, u"colours"_s,
                             {id, question, forAssistant, [change](Scene &changed) {
                                  for (Triangle &triangle : changed.triangles)
                                      change(triangle, changed.settings.rounding);
                                  return true;
                              }});
    };
    const auto takenFrom = [](const std::array<std::size_t, 3> &from) {
        return [from](Triangle &triangle, ByteRounding) {
            const Triangle right = triangle;
            for (std::size_t i = 0; i < 3; ++i)
                triangle.vertices[i].colour = right.vertices[from[i]].colour;
        };
    };
    for (const auto &order : orders) {
        QString digits;
        for (const std::size_t index : order)
            digits += QString::number(index);
        add(u"colours-"_s + digits,
            u"The vertices 0, 1, 2 have the colours of %1, %2, %3."_s.arg(order[0])
                .arg(order[1])
                .arg(order[2]),
            takenFrom(order));
    }
    question = u"Does the colour change across a triangle?"_s;
    add(u"flat-first"_s, u"Every triangle has its first vertex' colour alone."_s,
        takenFrom({0, 0, 0}));
    add(u"flat-second"_s, u"Every triangle has its second vertex' colour alone."_s,
        takenFrom({1, 1, 1}));
    add(u"flat-last"_s, u"Every triangle has its last vertex' colour alone."_s,
        takenFrom({2, 2, 2}));
    add(u"flat-mean"_s, u"Every triangle has one colour, the mean of its vertices'."_s, takeMean);
}

/// The mistake of setting the vertices' colours only once.
void appendColoursOfFirst(std::vector<Defect> &defects, const Scene &scene)
{
    appendWhereItApplies(
        defects, scene, u"colours"_s,
        {u"colours-of-first-triangle"_s, u"Which colours has the second triangle?"_s,
         u"The vertices of all triangles have the colours of the "
         "first one's, in the order in which they are given."_s,
         [](Scene &changed) {
             for (Triangle &triangle : changed.triangles) {
                 for (std::size_t i = 0; i < 3; ++i)
                     triangle.vertices[i].colour = changed.triangles.front().vertices[i].colour;
             }
             return true;
         }});
}

enum class PrimitiveEnd { First, Last };

/// Keeps the first or last primitive, where shapes are drawn after triangles; false where there is
/// no other.
bool keepOnly(PrimitiveEnd end, Scene &scene)
{
    if (scene.triangles.size() + scene.shapes.size() < 2)
        return false;
    const bool isShape
        = end == PrimitiveEnd::Last ? !scene.shapes.empty() : scene.triangles.empty();
    const auto keep = [end](auto &primitives) {
        const auto kept = end == PrimitiveEnd::First ? primitives.front() : primitives.back();
        primitives = {kept};
    };
    if (isShape) {
        keep(scene.shapes);
        scene.triangles.clear();
    } else {
        keep(scene.triangles);
        scene.shapes.clear();
    }
    return true;
}

/// Mistakes in the vertices' channels before anything is computed: one is another's, or 0.
void appendChannels(std::vector<Defect> &defects, const Scene &scene)
{
    constexpr std::array<const char *, 3> names = {"red", "green", "blue"};
    const auto add = [&](const QString &id, const QString &forAssistant,
                         const std::function<void(Colour & colour)> &change) {
        appendWhereItApplies(defects, scene, u"vertex channels"_s,
                             {id, u"Are all three channels treated alike?"_s, forAssistant,
                              [change](Scene &changed) {
                                  for (Triangle &triangle : changed.triangles) {
                                      for (Vertex &vertex : triangle.vertices)
                                          change(vertex.colour);
                                  }
                                  return true;
                              }});
    };
    for (std::size_t to = 0; to < 3; ++to) {
        const QString name = QString::fromLatin1(names[to]);
        const QString title = name.left(1).toUpper() + name.mid(1);
        for (std::size_t from = 0; from < 3; ++from) {
            if (from == to)
                continue;
            const QString other = QString::fromLatin1(names[from]);
            add(name + u"-from-"_s + other,
                u"%1 is computed from the %2 of the vertices."_s.arg(title, other),
                [to, from](Colour &colour) { colour.channels[to] = colour.channels[from]; });
        }
        add(name + u"-not-set"_s, u"%1 is not set: it is 0 in all that is drawn."_s.arg(title),
            [to](Colour &colour) { colour.channels[to] = 0; });
    }
    // In a program that was written for red and never extended.
    add(u"red-alone"_s, u"Only red is computed: green and blue are 0 in all that is drawn."_s,
        [](Colour &colour) { colour.channels[1] = colour.channels[2] = 0; });
    add(u"all-from-red"_s,
        u"Green and blue are computed from the red of the vertices: all is gray."_s,
        [](Colour &colour) { colour.channels[1] = colour.channels[2] = colour.channels[0]; });
}

void appendPrimitives(std::vector<Defect> &defects, const Scene &scene)
{
    const auto addLess = [&](Defect defect) {
        defect.leavesOut = true;
        appendWhereItApplies(defects, scene, u"triangles"_s, std::move(defect));
    };
    const auto cull = [&](const char *id, const char *turn, int sign) {
        addLess({QString::fromLatin1(id),
                 u"Are all triangles there, whichever way "
                 "their vertices turn?"_s,
                 u"Triangles whose vertices turn %1, taking y upward, are not drawn."_s.arg(
                     QString::fromLatin1(turn)),
                 [sign](Scene &changed) {
                     const auto isCulled = [sign](const Triangle &triangle) {
                         const auto &[a, b, c] = triangle.vertices;
                         const Int128 area = doubledArea(a.position, b.position, c.position);
                         return sign < 0 ? area < 0 : area > 0;
                     };
                     return changed.attributes.empty()
                         && std::erase_if(changed.triangles, isCulled) > 0;
                 }});
    };
    cull("culls-clockwise", "clockwise", -1);
    cull("culls-counter-clockwise", "counter-clockwise", 1);
    appendWhereItApplies(defects, scene, u"triangles"_s,
                         {u"reverse-order"_s, u"In which order are they painted?"_s,
                          u"The triangles are painted from the last to the first."_s,
                          [](Scene &changed) {
                              std::ranges::reverse(changed.triangles);
                              return changed.attributes.empty();
                          }});
    const auto keepOne = [&](const char *id, const char *which, PrimitiveEnd end) {
        addLess(
            {QString::fromLatin1(id), u"Is all of the scene there?"_s,
             u"Only the %1 of the scene's primitives is drawn."_s.arg(QString::fromLatin1(which)),
             [end](Scene &changed) {
                 const bool isPlain = changed.attributes.empty() && changed.solids.empty();
                 return isPlain && keepOnly(end, changed);
             }});
    };
    keepOne("only-first-drawn", "first", PrimitiveEnd::First);
    keepOne("only-last-drawn", "last", PrimitiveEnd::Last);
}

} // namespace

void appendWhereItApplies(std::vector<Defect> &defects, const Scene &scene, const QString &choice,
                          Defect defect)
{
    defect.choice = choice;
    Scene changed = scene;
    const bool applies
        = defect.changeScene(changed) && changed != scene && objectionTo(changed).isEmpty();
    if (applies)
        defects.push_back(std::move(defect));
}

std::vector<Defect> sceneDefectsFor(const Scene &scene)
{
    std::vector<Defect> defects;
    appendPlaces(defects, scene);
    appendColours(defects, scene);
    appendColoursOfFirst(defects, scene);
    appendChannels(defects, scene);
    appendPrimitives(defects, scene);
    return defects;
}

} // namespace pixelplumb
