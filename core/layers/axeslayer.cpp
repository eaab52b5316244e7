// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/clippedline.h"
#include "core/layers/layers.h"

#include <algorithm>
#include <array>

namespace pixelplumb {

namespace {

/// a, b, c, px.
struct WeightedCorners {
    std::array<QPointF, 3> places;

    explicit WeightedCorners(const LayerMoment &moment)
    {
        std::ranges::transform(moment.weightedCorners(), places.begin(), placeOf);
    }

    /// p = a + β·(b − a) + γ·(c − a).
    QPointF at(double beta, double gamma) const
    {
        return places[0] + beta * (places[1] - places[0]) + gamma * (places[2] - places[0]);
    }
};

constexpr double firstAxisValue = -1;
constexpr double lastAxisValue = 2;

class AxesDrawer {
public:
    AxesDrawer(const LayerMoment &moment, LayerDrawing &drawing)
        : m_moment(moment)
        , m_corners(moment)
        , m_seen(double(moment.view.seen.firstX) - 0.5, double(moment.view.seen.firstY) - 0.5,
                 double(moment.view.seen.endX - moment.view.seen.firstX),
                 double(moment.view.seen.endY - moment.view.seen.firstY))
        , m_drawing(drawing)
    {
    }

    /// The lines on which one coordinate is constant, and the axis of the other.
    void appendLines()
    {
        using Stroke = LayerDrawing::Stroke;
        for (double value = firstAxisValue; value <= lastAxisValue; ++value) {
            // Where one coordinate is 0, the other's axis runs.
            const bool isAxis = value == 0;
            const Stroke stroke = isAxis ? Stroke::Arrow : Stroke::Dashed;
            const QLineF sameBeta(m_corners.at(value, firstAxisValue),
                                  m_corners.at(value, lastAxisValue));
            const QLineF sameGamma(m_corners.at(firstAxisValue, value),
                                   m_corners.at(lastAxisValue, value));
            const LayerInk ofBeta = isAxis ? LayerInk::Second : LayerInk::First;
            const LayerInk ofGamma = isAxis ? LayerInk::First : LayerInk::Second;
            m_drawing.lines.push_back({sameBeta.p1(), sameBeta.p2(), ofBeta, stroke});
            m_drawing.lines.push_back({sameGamma.p1(), sameGamma.p2(), ofGamma, stroke});
            appendName(u"β = %1"_s.arg(value), sameBeta, ofBeta);
            appendName(u"γ = %1"_s.arg(value), sameGamma, ofGamma);
        }
    }

    void appendSpecialPoints()
    {
        appendPoint(m_moment.weightedCornerName(0) + u" (1, 0, 0)"_s, 0, 0);
        appendPoint(m_moment.weightedCornerName(1) + u" (0, 1, 0)"_s, 1, 0);
        appendPoint(m_moment.weightedCornerName(2) + u" (0, 0, 1)"_s, 0, 1);
        appendPoint("(½, ½, 0)", 0.5, 0);
        appendPoint("(½, 0, ½)", 0, 0.5);
        appendPoint("(0, ½, ½)", 0.5, 0.5);
        appendPoint("(⅓, ⅓, ⅓)", 1.0 / 3, 1.0 / 3);
    }

private:
    /// Names a line where it is in view, away from crossings, where two names would collide.
    void appendName(QString text, const QLineF &line, LayerInk ink)
    {
        constexpr double beforeFirstCrossing = 0.25;
        const QPointF place = line.pointAt(beforeFirstCrossing);
        const std::optional<QLineF> visible = clipped(line, m_seen);
        if (visible)
            m_drawing.labels.push_back(
                {withMinus(text),
                 m_seen.contains(place) ? place : visible->pointAt(beforeFirstCrossing), ink});
    }
    void appendPoint(const QString &name, double beta, double gamma)
    {
        const QPointF place = m_corners.at(beta, gamma);
        m_drawing.points.push_back({place, LayerInk::Third});
        m_drawing.labels.push_back({name, place, LayerInk::Third});
    }

    const LayerMoment &m_moment;
    WeightedCorners m_corners;
    QRectF m_seen; ///< the pixels in view, px
    LayerDrawing &m_drawing;
};

void drawAxes(const LayerMoment &moment, LayerDrawing &drawing)
{
    if (doubledArea(moment.triangle()) == 0)
        return drawing.notes.append(
            u"Barycentric axes: the triangle has no area, so that they fall into one"_s);
    AxesDrawer axes(moment, drawing);
    axes.appendLines();
    axes.appendSpecialPoints();
}

} // namespace

Layer barycentricAxesLayer()
{
    return {.id = "barycentric-axes",
            .title = QT_TRANSLATE_NOOP("core", "Barycentric axes and points"),
            .toolTip
            = "The oblique axes from a: β towards b, γ towards c, the lines of their whole values, "
              "and (α, β, γ) of the vertices, the middles of the edges and the centroid; exact. a, "
              "b, c are the vertices 0, 1, 2 of the scene, whatever the method sorts.",
            .source = "Triangles slides, “p = a + β(b − a) + γ(c − a)”; Rasterization slides, “BC "
                      "– Special Points”",
            .kinds = {PrimitiveKind::Triangle},
            .draw = drawAxes};
}

} // namespace pixelplumb
