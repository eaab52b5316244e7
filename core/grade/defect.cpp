// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/defect.h"

#include "core/grade/picturecause.h"
#include "core/grade/spandefect.h"
#include "core/grade/walkdefect.h"
#include "core/runs/sceneplan.h"
#include "core/scan/choicenames.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Adds the defect, one of a choice, where the scene can have it.
void append(std::vector<Defect> &defects, const Scene &scene, const QString &choice, Defect defect)
{
    defect.choice = choice;
    Scene changed = scene;
    const bool applies
        = defect.changeScene(changed) && changed != scene && objectionTo(changed).isEmpty();
    if (applies)
        defects.push_back(std::move(defect));
}

void appendVariants(std::vector<Defect> &defects, const Scene &scene)
{
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    for (const Variant variant : allVariants) {
        append(defects, scene, {},
               {nameText(nameOf(variant)), nameText(wordsOf(variant, method.spanAxis).fault),
                sentenceOf(variant, method.spanAxis), [variant](Scene &changed) {
                    changed.settings.variants = changed.settings.variants.with(variant);
                    return true;
                }});
    }
}

void appendSettings(std::vector<Defect> &defects, const Scene &scene)
{
    for (const FillRule rule : allFillRules)
        append(defects, scene, QStringLiteral("rule"),
               {QStringLiteral("rule-") + nameText(nameOf(rule)),
                QStringLiteral("Look at pixels exactly on an edge, and at neighbours' shared "
                               "edges."),
                QStringLiteral("The fill rule is %1 in place of %2.")
                    .arg(nameText(nameOf(rule)), nameText(nameOf(scene.settings.fillRule))),
                [rule](Scene &changed) {
                    changed.settings.fillRule = rule;
                    return true;
                }});
    for (const ByteRounding rounding : allByteRoundings)
        append(defects, scene, QStringLiteral("rounding"),
               {QStringLiteral("rounding-") + nameText(nameOf(rounding)),
                QStringLiteral("Look at how a colour becomes a byte."),
                QStringLiteral("Levels become bytes by %1.").arg(nameText(nameOf(rounding))),
                [rounding](Scene &changed) {
                    changed.settings.rounding = rounding;
                    return true;
                }});
    for (const Arithmetic arithmetic : allArithmetics)
        append(defects, scene, QLatin1String(arithmeticChoice),
               {QStringLiteral("arithmetic-") + nameText(nameOf(arithmetic)),
                QStringLiteral("What your numbers are kept in decides pixels: how large is the "
                               "error after many additions?"),
                QStringLiteral("It is computed in %1.").arg(nameText(nameOf(arithmetic))),
                [arithmetic](Scene &changed) {
                    changed.settings.arithmetic = arithmetic;
                    return true;
                }});
}

using MoveVertex = void (*)(LatticePoint &point);

Lattice truncated(Lattice coordinate) { return floorPixel(coordinate) * unitsPerPixel; }

Lattice nearest(Lattice coordinate) { return truncated(coordinate + unitsPerPixel / 2); }

void appendPlaces(std::vector<Defect> &defects, const Scene &scene)
{
    QString choice;
    const auto add
        = [&](const char *id, const char *forStudent, const char *forAssistant, MoveVertex move) {
              append(defects, scene, choice,
                     {QString::fromLatin1(id), QString::fromUtf8(forStudent),
                      QString::fromUtf8(forAssistant), [move](Scene &changed) {
                          for (Triangle &triangle : changed.triangles) {
                              for (Vertex &vertex : triangle.vertices)
                                  move(vertex.position);
                          }
                          return true;
                      }});
          };
    choice = QStringLiteral("places");
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
    choice = QStringLiteral("centre");
    constexpr const char *centre = "Where in a pixel is its sample?";
    add("half-pixel-down", centre, "Samples stand half a pixel towards larger x and y.",
        [](LatticePoint &point) {
            point.x -= unitsPerPixel / 2;
            point.y -= unitsPerPixel / 2;
        });
    add("half-pixel-up", centre, "Samples stand half a pixel towards smaller x and y.",
        [](LatticePoint &point) {
            point.x += unitsPerPixel / 2;
            point.y += unitsPerPixel / 2;
        });
}

void appendColours(std::vector<Defect> &defects, const Scene &scene)
{
    constexpr std::array<std::array<std::size_t, 3>, 5> orders
        = {{{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
    const auto add = [&](const QString &id, const QString &forAssistant,
                         const std::array<std::size_t, 3> &from) {
        append(defects, scene, QStringLiteral("colours"),
               {id, QStringLiteral("Which vertex has which colour?"), forAssistant,
                [from](Scene &changed) {
                    for (Triangle &triangle : changed.triangles) {
                        const Triangle right = triangle;
                        for (std::size_t i = 0; i < 3; ++i)
                            triangle.vertices[i].colour = right.vertices[from[i]].colour;
                    }
                    return true;
                }});
    };
    for (const auto &order : orders) {
        QString digits;
        for (const std::size_t index : order)
            digits += QString::number(index);
        add(QStringLiteral("colours-") + digits,
            QStringLiteral("The vertices 0, 1, 2 have the colours of %1, %2, %3.")
                .arg(order[0])
                .arg(order[1])
                .arg(order[2]),
            order);
    }
    add(QStringLiteral("flat-first"),
        QStringLiteral("The triangle has its first vertex' colour alone."), {0, 0, 0});
    add(QStringLiteral("flat-last"),
        QStringLiteral("The triangle has its last vertex' colour alone."), {2, 2, 2});
}

void appendTriangles(std::vector<Defect> &defects, const Scene &scene)
{
    const auto cull = [&](const char *id, const char *turn, int sign) {
        append(defects, scene, QStringLiteral("triangles"),
               {QString::fromLatin1(id),
                QStringLiteral("Are all triangles there, whichever way "
                               "their vertices turn?"),
                QStringLiteral("Triangles whose vertices turn %1, taking y upward, are not drawn.")
                    .arg(QString::fromLatin1(turn)),
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
    append(defects, scene, QStringLiteral("triangles"),
           {QStringLiteral("reverse-order"), QStringLiteral("In which order are they painted?"),
            QStringLiteral("The triangles are painted from the last to the first."),
            [](Scene &changed) {
                std::ranges::reverse(changed.triangles);
                return changed.attributes.empty();
            }});
}

/// The change of a picture with any background, which fills what a shift leaves empty.
auto changeNamed(const QString &name)
{
    return [name](const Picture &right, const Colour &background) {
        const auto changes = pictureChangesFor(right, background);
        const auto found = std::ranges::find(changes, name, &PictureChange::name);
        return found != changes.end() ? found->apply(right) : right;
    };
}

void appendPictures(std::vector<Defect> &defects, const Scene &scene)
{
    // First of all: what it is drawn on can still be another background.
    defects.push_back(
        {QStringLiteral("nothing-drawn"),
         QStringLiteral("Is the picture that is written the one that was drawn into?"),
         QStringLiteral("Nothing is drawn: all of the picture is the background."),
         {},
         {},
         [](const Picture &right, const Colour &background) {
             Picture picture = right;
             std::ranges::fill(picture.colours, background);
             std::ranges::fill(picture.covered, std::uint8_t(0));
             return picture;
         }});
    const Picture ofItsSize{scene.frame.width, scene.frame.height, {}, {}};
    for (const PictureChange &change : pictureChangesFor(ofItsSize, scene.frame.background)) {
        const QString id = QString(change.name).toLower().replace(u' ', u'-');
        defects.push_back({id,
                           QStringLiteral("Look at the whole picture: how are rows, columns "
                                          "and channels stored?"),
                           QStringLiteral("Done to the whole picture: %1.").arg(change.name),
                           {},
                           {},
                           changeNamed(change.name),
                           change.isFar,
                           change.kind});
    }
}

} // namespace

std::vector<Defect> defectsFor(const Scene &scene)
{
    std::vector<Defect> defects;
    appendVariants(defects, scene);
    appendSettings(defects, scene);
    appendPlaces(defects, scene);
    appendColours(defects, scene);
    appendTriangles(defects, scene);
    std::ranges::move(lineDefectsFor(scene), std::back_inserter(defects));
    std::ranges::move(spanDefectsFor(scene), std::back_inserter(defects));
    appendPictures(defects, scene);
    return defects;
}

} // namespace pixelplumb
