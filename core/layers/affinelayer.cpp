// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/affinemap.h"
#include "core/layers/layers.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

// About as many lines along one axis as fit at this spacing in the image, logical pixels.
constexpr double gridSpacing = 24;
constexpr double leastGridLines = 4;
constexpr double mostGridLines = 64;

QPointF placeInFrame(const RationalPoint &inScene, const FrameSpec &frame)
{
    const double offset = double(sampleOffset(frame)) / unitsPerPixel;
    return {inScene.x.convert_to<double>() - offset, inScene.y.convert_to<double>() - offset};
}

bool isVisited(const QPoint &pixel, const LayerMoment &moment)
{
    const ScanTrace &trace = moment.trace();
    const auto visit = trace.visitOf(moment.primitive, pixel.x(), pixel.y());
    return visit && moment.hasDone(trace.indexOfSample(*visit));
}

/// The picked pixel, else the last finished sample of the primitive; before its first one, and in a
/// finished run, the pixel nearest to the triangle's middle. None if the pixel's turn is still
/// hidden.
std::optional<LatticePoint> currentSample(const LayerMoment &moment)
{
    const std::optional<QPoint> &picked = moment.view.picked;
    if (picked && moment.hidesSteps() && !isVisited(*picked, moment))
        return std::nullopt;
    if (picked)
        return latticePixel(picked->x(), picked->y());
    const ScanTrace &trace = moment.trace();
    const std::size_t done = trace.samplesDoneAt(moment.view.position);
    const bool isFinished = moment.view.position == trace.stepCount();
    if (done > 0 && !isFinished && trace.primitiveOf(trace.spanOf(done - 1)) == moment.primitive) {
        const PixelChange change = trace.changes()[done - 1];
        return latticePixel(change.x, change.y);
    }
    if (moment.hidesSteps())
        return std::nullopt;
    LatticePoint sum;
    for (const LatticePoint &corner : moment.corners())
        sum = {sum.x + corner.x, sum.y + corner.y};
    const auto nearest = [](Lattice tripled) {
        return floorDivide(2 * tripled + 3 * unitsPerPixel, 6 * unitsPerPixel);
    };
    return latticePixel(nearest(sum.x), nearest(sum.y));
}

class AffineDrawer {
public:
    AffineDrawer(const LayerMoment &moment, LayerDrawing &drawing)
        : m_moment(moment)
        , m_drawing(drawing)
    {
        const Corners images = imagesOf(moment.view, moment.primitive);
        const Lattice offset = sampleOffset(moment.frame());
        for (std::size_t i = 0; i < 3; ++i) {
            m_onSamples[i] = moment.weightedCorners()[i];
            m_corners[i] = {m_onSamples[i].x + offset, m_onSamples[i].y + offset};
            m_images[i] = images[i];
            m_imagePlaces[i] = placeInFrame(rationalPoint(m_images[i]), moment.frame());
        }
        m_map = affineMapOf(m_corners, m_images);
        const QPointF a = m_imagePlaces[1] - m_imagePlaces[0];
        const QPointF b = m_imagePlaces[2] - m_imagePlaces[0];
        const double extent = std::sqrt(std::abs(a.x() * b.y() - a.y() * b.x()));
        m_gridLines
            = std::clamp(extent * moment.view.cell / gridSpacing, leastGridLines, mostGridLines);
        if (const std::optional<LatticePoint> sample = currentSample(moment))
            m_point = rationalPoint({sample->x + offset, sample->y + offset});
    }

    void appendTriangles()
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            m_drawing.lines.push_back(
                {placeOf(m_onSamples[i]), placeOf(m_onSamples[next]), LayerInk::Mark});
            m_drawing.lines.push_back({m_imagePlaces[i], m_imagePlaces[next], LayerInk::Second,
                                       LayerDrawing::Stroke::Dashed});
            m_drawing.points.push_back({m_imagePlaces[i], LayerInk::Second});
            m_drawing.labels.push_back(
                {m_moment.weightedCornerName(i, "′") + u' ' + pointText(rationalPoint(m_images[i])),
                 m_imagePlaces[i], LayerInk::Second});
        }
    }

    /// The images of the borders between cells.
    void appendGrid()
    {
        appendGridLines(&QPointF::x);
        appendGridLines(&QPointF::y);
    }

    /// The sample and its image, each with the weights of its own areas.
    void appendSample()
    {
        m_drawing.notes.append(rowsText(m_map));
        if (!m_point) {
            m_drawing.notes.append(u"Affine map: weights are still ahead"_s);
            return;
        }
        const RationalPoint image = m_map.of(*m_point);
        appendPoint("p", *m_point, pointAreas(m_corners, *m_point));
        for (std::size_t i = 0; i < 3; ++i)
            appendSpoke(placeOf(m_onSamples[i]), *m_point);
        if (m_map.determinant() == 0) {
            m_drawing.points.push_back({placeInFrame(image, m_moment.frame()), LayerInk::Hand});
            m_drawing.notes.append(
                u"p′ %1 has no weights: the map flattens the triangle to no area"_s.arg(
                    pointText(image)));
            return;
        }
        appendPoint("p′", image, pointAreas(m_images, image));
        for (const QPointF &corner : m_imagePlaces)
            appendSpoke(corner, image);
        m_drawing.notes.append(areasChangeText(m_map));
    }

private:
    /// Appends the lines on which one coordinate is constant: all, or every second, fourth …
    void appendGridLines(double (QPointF::*coordinate)() const)
    {
        std::array<double, 3> values;
        std::ranges::transform(m_onSamples, values.begin(), [&](const LatticePoint &corner) {
            return (placeOf(corner).*coordinate)();
        });
        const auto [least, largest] = std::ranges::minmax(values);
        double every = 1;
        while ((largest - least) / every > m_gridLines)
            every *= 2;
        for (double line = std::ceil((least - 0.5) / every) * every + 0.5; line < largest;
             line += every) {
            // An affine map keeps the ratio in which a line cuts an edge.
            std::vector<QPointF> cuts;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t next = (i + 1) % 3;
                if ((values[i] < line) != (values[next] < line))
                    cuts.push_back(m_imagePlaces[i]
                                   + (line - values[i]) / (values[next] - values[i])
                                       * (m_imagePlaces[next] - m_imagePlaces[i]));
            }
            if (cuts.size() == 2)
                m_drawing.lines.push_back(
                    {cuts[0], cuts[1], LayerInk::Second, LayerDrawing::Stroke::Dotted});
        }
    }

    void appendPoint(const QString &name, const RationalPoint &point, const PointAreas &areas)
    {
        const QPointF place = placeInFrame(point, m_moment.frame());
        m_drawing.points.push_back({place, LayerInk::Hand});
        m_drawing.labels.push_back(
            {u"%1: %2"_s.arg(name, weightsText(areas)), place, LayerInk::Hand});
        m_drawing.notes.append(u"%1 %2. %3"_s.arg(name, pointText(point), areasText(areas)));
    }

    /// Appends the border between two of the compared areas.
    void appendSpoke(const QPointF &corner, const RationalPoint &point)
    {
        m_drawing.lines.push_back({placeInFrame(point, m_moment.frame()), corner, LayerInk::Hand,
                                   LayerDrawing::Stroke::Dotted});
    }

    const LayerMoment &m_moment;
    LayerDrawing &m_drawing;
    Corners m_onSamples; ///< a, b, c in sample coordinates
    Corners m_corners; ///< the same in scene coordinates
    Corners m_images;
    std::array<QPointF, 3> m_imagePlaces; ///< in sample coordinates, px
    double m_gridLines = leastGridLines; ///< at most, along one axis
    AffineMap m_map;
    std::optional<RationalPoint> m_point; ///< the sample
};

void drawAffineMap(const LayerMoment &moment, LayerDrawing &drawing)
{
    if (doubledArea(moment.triangle()) == 0)
        return drawing.notes.append(
            u"Affine map: the triangle has no area, so that its corners tell of no "
            "map and no point has weights"_s);
    AffineDrawer drawer(moment, drawing);
    drawer.appendTriangles();
    drawer.appendSample();
    drawer.appendGrid();
}

} // namespace

Layer affineMapLayer()
{
    return {.id = "affine-map",
            .title = QT_TRANSLATE_NOOP("core", "Affine map: weights stay"),
            .toolTip
            = "The triangle's image under an affine map, with the images of the lines between "
              "cells, of every second, fourth … where they are many, and the weights of the "
              "current sample before and after, each from its own triangle's areas: α, β, γ of a, "
              "b, c, the vertices 0, 1, 2 of the scene. The image's corners can be dragged; a "
              "double click on one brings the first map back.",
            .source = "Rasterization slides, “Barycentric Coordinates – Invariance”",
            .kinds = {PrimitiveKind::Triangle},
            .draw = drawAffineMap};
}

} // namespace pixelplumb
