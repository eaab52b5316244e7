// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/effectreason.h"

#include "core/plan/requirements.h"
#include "core/space/vertexlight.h"

#include <QStringList>

#include <algorithm>

namespace pixelplumb {

namespace {

QString triangleWord() { return QStringLiteral("triangle"); }

/// "triangle", "line", … where all that is drawn is of one kind, else "primitive".
QString primitiveWord(const Primitives &primitives)
{
    if (primitives.shapes.empty())
        return triangleWord();
    const PrimitiveKind kind = primitives.shapes.front().kind;
    const bool isOfOneKind = primitives.triangles.empty()
        && std::ranges::all_of(primitives.shapes, [&](auto &shape) { return shape.kind == kind; });
    if (!isOfOneKind)
        return QStringLiteral("primitive");
    return kind == PrimitiveKind::Bezier ? QStringLiteral("Bézier curve") : nameOf(kind);
}

/// Why an effect of triangles alone is not called for where none is drawn; `what` they alone have.
QString withoutTriangles(const Primitives &primitives, const NeedsTally &tally, const QString &what)
{
    return (primitives.triangles.empty() && !primitives.isPart && tally.cutAtNear == 0
                ? QStringLiteral("there is no triangle, and nothing else has %1")
                : QStringLiteral("no triangle is drawn in the frame, and nothing else has %1"))
        .arg(what);
}

/// What only triangles have that an effect works on; empty if other primitives have it, too.
QString onlyOfTriangles(Effect effect)
{
    switch (effect) {
    case Effect::Depth:
        return QStringLiteral("a depth");
    case Effect::Perspective:
        return QStringLiteral("w");
    case Effect::Texture:
        return QStringLiteral("a texture");
    case Effect::Light:
        return QStringLiteral("normals");
    case Effect::Blending:
        return QStringLiteral("an alpha");
    case Effect::SmoothColour:
    case Effect::Clipping:
    case Effect::Antialiasing:
        break;
    }
    return {};
}

QString has(std::size_t count, std::size_t all, const QString &noun)
{
    return countedWords(count, all, noun, "has", "have");
}

QString smoothColourReason(const NeedsTally &tally, const Appearance &appearance,
                           const QString &noun)
{
    const std::size_t smooth = tally.of[Effect::SmoothColour].primitives;
    const bool isFlatLit = appearance.shading == Shading::Flat && lightsVertices(appearance)
        && tally.of[Effect::Light].primitives > 0;
    // Light and materials are applied to the vertices before they are asked.
    const QString colours = lightsVertices(appearance) && tally.of[Effect::Light].primitives > 0
        ? QStringLiteral("vertex colours, as lit,")
        : QStringLiteral("vertex colours");
    if (smooth > 0)
        return QStringLiteral("%1 %2 that differ")
                   .arg(has(smooth, tally.drawn, noun), QString(colours).remove(u','))
            + (isFlatLit
                   ? QStringLiteral("; flat light gives each triangle that it falls on one colour")
                   : QString());
    if (tally.drawnTriangles == 0 && tally.ownColours == 0)
        return (tally.drawn == 1 ? QStringLiteral("the %1 has one colour")
                                 : QStringLiteral("each %1 has one colour"))
            .arg(noun);
    if (isFlatLit) {
        const bool isEachLit = tally.of[Effect::Light].primitives == tally.drawnTriangles;
        return isEachLit ? QStringLiteral("flat light gives each triangle one colour")
                         : QStringLiteral("flat light gives each triangle that it falls on one "
                                          "colour; in the others the vertex colours are equal")
                + ofEnds(tally);
    }
    if (tally.ownColours > 0)
        return QStringLiteral("no %1 goes from one vertex colour to another where it is drawn")
            .arg(noun);
    if (!tally.isOfAll())
        return QStringLiteral("the %1 are equal in each %2%3").arg(colours, noun, amongDrawn(tally))
            + ofEnds(tally);
    const QString equal = QStringLiteral("the %1 are equal").arg(colours);
    return (tally.drawn == 1
                ? equal
                : equal + QStringLiteral(" in each of %1 %2s").arg(tally.drawn).arg(noun))
        + ofEnds(tally);
}

QString clippingReason(const NeedsTally &tally, const QString &noun, Antialiasing antialiasing)
{
    QStringList reasons;
    if (tally.cutAtNear > 0)
        reasons.append(countedWords(tally.cutAtNear, tally.drawn, noun, "is", "are")
                       + QStringLiteral(" of a face that the near plane cuts"));
    if (tally.crossing > 0)
        reasons.append((antialiasing == Antialiasing::Area
                            ? QStringLiteral("%1 a part beyond the frame")
                            : QStringLiteral("%1 samples beyond the frame"))
                           .arg(has(tally.crossing, tally.drawn, noun)));
    if (tally.crossing > 0 && tally.mayCross > 0)
        reasons.append(QStringLiteral("%1 more may go on beyond it, as far as bounding boxes tell")
                           .arg(tally.mayCross));
    if (!reasons.empty())
        return reasons.join(QStringLiteral("; "));
    if (tally.mayCross > 0)
        return QStringLiteral("%1 beyond the frame, as far as bounding boxes tell")
            .arg(countedWords(tally.mayCross, tally.drawn, noun, "may go on", "may go on"));
    const QString within = "what is drawn lies within the frame";
    if (tally.outside == 0)
        return within;
    const QString covered = antialiasing == Antialiasing::Area ? "part" : "sample";
    return within
        + (tally.outside == 1
               ? QStringLiteral("; 1 other %1 covers no %2 of the frame").arg(noun, covered)
               : QStringLiteral("; %1 other %2s cover no %3 of the frame")
                     .arg(QString::number(tally.outside), noun, covered));
}

/// The values that are divided by w.
QString carriedWords(const TriangleNeeds &carried)
{
    QStringList words;
    if (carried.carriesColour)
        words.append(QStringLiteral("colours"));
    if (carried.carriesAlpha)
        words.append(QStringLiteral("alpha"));
    if (carried.carriesTexture)
        words.append(QStringLiteral("u and v"));
    if (carried.carriesLight)
        words.append(QStringLiteral("what lighting needs"));
    return words.join(QStringLiteral(", "));
}

QString ofTriangles(std::size_t count, std::size_t all)
{
    if (all == 1)
        return QStringLiteral("the triangle");
    return count == all ? QStringLiteral("all %1 triangles").arg(all)
                        : QStringLiteral("%1 of %2 triangles").arg(count).arg(all);
}

QString perspectiveReason(const NeedsTally &tally)
{
    const std::size_t divided = tally.of[Effect::Perspective].primitives;
    if (divided > 0)
        return QStringLiteral("w differs between the vertices of %1, so these are divided by w "
                              "before they are interpolated: %2")
            .arg(ofTriangles(divided, tally.drawnTriangles), carriedWords(tally.carried));
    if (tally.dividingNothing > 0)
        return QStringLiteral(
                   "w differs between the vertices of %1, but nothing that is divided by it does")
                   .arg(ofTriangles(tally.dividingNothing, tally.drawnTriangles))
            + ofEnds(tally);
    return QStringLiteral("w is the same at the vertices of every triangle") + amongDrawn(tally)
        + ofEnds(tally);
}

QString textureReason(const NeedsTally &tally)
{
    const std::size_t textured = tally.of[Effect::Texture].primitives;
    if (textured == 0)
        return QStringLiteral("no triangle%1 has a material with a texture").arg(amongDrawn(tally));
    QStringList names;
    for (const Texture *texture : tally.textures)
        names.append(u'“' + QString::fromStdString(texture->name) + u'”');
    return QStringLiteral("%1 a material with a texture: %2")
        .arg(has(textured, tally.drawnTriangles, triangleWord()), names.join(QStringLiteral(", ")));
}

/// Where light is computed.
QString shadingWords(Shading shading)
{
    switch (shading) {
    case Shading::Flat:
        return QStringLiteral("flat shading: once a triangle, in set-up");
    case Shading::Gouraud:
        return QStringLiteral("Gouraud shading: at the vertices, in set-up");
    case Shading::Phong:
        break;
    }
    return QStringLiteral("Phong shading: at every sample");
}

QString lightReason(const NeedsTally &tally, const Appearance &appearance)
{
    const std::size_t lit = tally.of[Effect::Light].primitives;
    if (lit > 0) {
        const std::size_t lights = appearance.lights.size();
        return QStringLiteral("%1 normals, and %2 (%3)")
            .arg(has(lit, tally.drawnTriangles, triangleWord()),
                 lights == 1 ? QStringLiteral("a light is on")
                             : QStringLiteral("%1 lights are on").arg(lights),
                 shadingWords(appearance.shading));
    }
    return appearance.lights.empty()
        ? QStringLiteral("no light is on")
        : QStringLiteral("no triangle%1 has normals").arg(amongDrawn(tally));
}

} // namespace

QString amongDrawn(const NeedsTally &tally)
{
    return tally.isOfAll() ? QString() : QStringLiteral(" that is drawn in the frame");
}

QString ofEnds(const NeedsTally &tally)
{
    QString said;
    if (tally.drawnSegments > 0)
        said += QStringLiteral("; for a triangle that is a segment, only the two ends count");
    if (tally.drawnPoints > 0)
        said += QStringLiteral("; for a triangle that is a point, only the first vertex counts");
    return said;
}

QString countedWords(std::size_t count, std::size_t all, const QString &noun,
                     const QString &singularVerb, const QString &pluralVerb)
{
    if (all == 1)
        return QStringLiteral("the %1 %2").arg(noun, singularVerb);
    if (count == all && all == 2)
        return QStringLiteral("both %1s %2").arg(noun, pluralVerb);
    if (count == all)
        return QStringLiteral("all %1 %2s %3").arg(QString::number(all), noun, pluralVerb);
    return QStringLiteral("%1 of %2 %3s %4")
        .arg(QString::number(count), QString::number(all), noun,
             count == 1 ? singularVerb : pluralVerb);
}

QString effectReason(Effect effect, const NeedsTally &tally, const Primitives &primitives,
                     const SampledFrame &where)
{
    if (tally.drawn == 0 && tally.of[effect].primitives == 0)
        return QStringLiteral("nothing is drawn in the frame");
    const QString owned = onlyOfTriangles(effect);
    if (tally.drawnTriangles == 0 && !owned.isEmpty() && tally.of[effect].primitives == 0)
        return withoutTriangles(primitives, tally, owned);
    switch (effect) {
    case Effect::SmoothColour:
        return smoothColourReason(tally, primitives.appearance, primitiveWord(primitives));
    case Effect::Clipping:
        return clippingReason(tally, primitiveWord(primitives),
                              antialiasingOf(primitives.appearance));
    case Effect::Perspective:
        return perspectiveReason(tally);
    case Effect::Texture:
        return textureReason(tally);
    case Effect::Light:
        return lightReason(tally, primitives.appearance);
    case Effect::Blending:
        return blendingReason(primitives, tally, where);
    case Effect::Antialiasing:
        return antialiasingReason(primitives, tally);
    case Effect::Depth:
        break;
    }
    return {};
}

} // namespace pixelplumb
