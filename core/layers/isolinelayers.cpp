// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/clippedline.h"
#include "core/layers/layers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr int levelStep = 32;
constexpr std::array channelInks = {LayerInk::Second, LayerInk::Hand, LayerInk::First};

struct PlaneCorner {
    QPointF place;
    double level = 0;
};

/// The channel's plane at the vertices: that of the set-up if the method has one, else the one
/// through the vertices' own levels.
std::array<PlaneCorner, 3> planeOf(const LayerMoment &moment, std::size_t channel)
{
    const SetUpRecord setUp = moment.trace().setUp(moment.primitive);
    const NamedNumbers numbers(moment.trace().numbers().setUp, setUp.cells);
    const QChar letter = channelLetters[channel];
    const auto coefficient = [&](QChar name) { return numbers[u"%1_%2"_s.arg(name).arg(letter)]; };
    const Quantity a = coefficient(u'a'), b = coefficient(u'b'), c = coefficient(u'c');
    const bool hasPlane = !a.isNone() && !b.isNone() && !c.isNone();
    std::array<PlaneCorner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vertex &vertex = moment.triangle().vertices[i];
        const QPointF place = placeOf(vertex.position);
        corners[i] = {place,
                      hasPlane ? a.toDouble() * place.x() + b.toDouble() * place.y() + c.toDouble()
                               : double(vertex.colour.channels[channel])};
    }
    return corners;
}

/// Where the triangle's border has a level: two places, or none.
std::vector<QPointF> crossingsOf(const std::array<PlaneCorner, 3> &corners, double level)
{
    std::vector<QPointF> crossings;
    for (std::size_t i = 0; i < 3; ++i) {
        const PlaneCorner &from = corners[i];
        const PlaneCorner &to = corners[(i + 1) % 3];
        if ((from.level < level) != (to.level < level))
            crossings.push_back(from.place
                                + (to.place - from.place)
                                    * ((level - from.level) / (to.level - from.level)));
    }
    return crossings;
}

/// The note for a plane that has none of the levels within the triangle.
QString withoutLines(QChar letter, const std::array<PlaneCorner, 3> &corners)
{
    const auto [least, greatest] = std::ranges::minmax(corners, {}, &PlaneCorner::level);
    const auto shown = [](double level) { return cellNumber(Quantity::of(level)); };
    if (shown(least.level) == shown(greatest.level))
        return u"Contour lines of %1: none, %1 is %2 all over the triangle"_s.arg(letter).arg(
            shown(least.level));
    return u"Contour lines of %1: none, from %2 to %3 %1 meets no multiple of %4"_s.arg(letter)
        .arg(shown(least.level), shown(greatest.level))
        .arg(levelStep);
}

void drawIsolines(std::size_t channel, const LayerMoment &moment, LayerDrawing &drawing)
{
    if (doubledArea(moment.triangle()) == 0)
        return drawing.notes.append(
            u"Contour lines of %1: the triangle has no area, so that its levels lie on no plane"_s
                .arg(channelLetters[channel]));
    if (moment.hidesSteps())
        return drawing.notes.append(
            u"Contour lines of %1: levels are still ahead"_s.arg(channelLetters[channel]));
    const EffectPlan *plan = moment.view.traced->shading();
    if (plan && plan->runs(Effect::Perspective))
        drawing.notes.append(
            u"Contour lines: of levels that change evenly over the frame, while the "
            "picture takes perspective into account"_s);
    const std::array<PlaneCorner, 3> corners = planeOf(moment, channel);
    const std::size_t linesBefore = drawing.lines.size();
    for (int level = levelStep; level < 256; level += levelStep) {
        const std::vector<QPointF> ends = crossingsOf(corners, level);
        if (ends.size() != 2)
            continue;
        drawing.lines.push_back({ends[0], ends[1], channelInks[channel]});
        const std::optional<QLineF> seen = clipped({ends[0], ends[1]}, moment.seenArea());
        const QLineF named = seen.value_or(QLineF(ends[0], ends[1]));
        drawing.labels.push_back({u"%1 = %2"_s.arg(channelLetters[channel]).arg(level),
                                  named.p1(),
                                  channelInks[channel],
                                  {},
                                  {named.p2(), named.center()}});
    }
    if (drawing.lines.size() == linesBefore)
        drawing.notes.append(withoutLines(channelLetters[channel], corners));
}

} // namespace

Layer isolinesLayer(std::size_t channel)
{
    static constexpr std::array<std::pair<const char *, const char *>, 3> names
        = {{{"isolines-red", QT_TRANSLATE_NOOP("core", "Contour lines of R")},
            {"isolines-green", QT_TRANSLATE_NOOP("core", "Contour lines of G")},
            {"isolines-blue", QT_TRANSLATE_NOOP("core", "Contour lines of B")}}};
    return {
        .id = names[channel].first,
        .title = names[channel].second,
        .toolTip
        = u"Lines on which %1 is the same, every %2 levels: the plane %1 = a·x + b·y + c of the "
          "set-up, or where the method has none the exact one through the vertices' levels."_s
              .arg(channelLetters[channel])
              .arg(levelStep),
        .source = "Scan Conversion slides, “2. Plane Equation”",
        .kinds = {PrimitiveKind::Triangle},
        .draw = [channel](const LayerMoment &moment, LayerDrawing &drawing) {
            drawIsolines(channel, moment, drawing);
        }};
}

} // namespace pixelplumb
