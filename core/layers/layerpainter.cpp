// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layerpainter.h"

#include "core/layers/layerlabels.h"
#include "core/layers/layermarks.h"
#include "core/layers/layertexts.h"

#include <QPainter>

namespace pixelplumb {

namespace {

/// Painting that is clipped to the view.
class PaintingInView {
public:
    PaintingInView(QPainter &painter, const LayerSurface &surface)
        : m_painter(painter)
    {
        m_painter.save();
        m_painter.setClipRect(surface.view, Qt::IntersectClip);
        m_painter.setRenderHint(QPainter::Antialiasing);
    }
    ~PaintingInView() { m_painter.restore(); }
    Q_DISABLE_COPY_MOVE(PaintingInView)

private:
    QPainter &m_painter;
};

/// A line in the ink of edges.
bool isPlain(const LayerDrawing::Line &line) { return line.ink == LayerInk::Mark; }

} // namespace

QTransform pictureTransform(const FrameSpec &frame, const QPointF &corner, double cell)
{
    const bool upward = frame.origin == FrameOrigin::BottomLeft;
    const double down = upward ? frame.height - 0.5 + frame.firstRow : 0.5 - frame.firstRow;
    return {cell,
            0,
            0,
            upward ? -cell : cell,
            corner.x() + (0.5 - frame.firstColumn) * cell,
            corner.y() + down * cell};
}

QStringList LayerPainter::paint(QPainter &painter, const LayerDrawing &drawing,
                                const LayerSurface &surface)
{
    QStringList said = paintGround(painter, drawing, surface);
    paintMarks(painter, drawing, surface);
    said += paintLabels(painter, drawing, surface, {});
    return said;
}

QStringList LayerPainter::paintGround(QPainter &painter, const LayerDrawing &drawing,
                                      const LayerSurface &surface)
{
    const PaintingInView inView(painter, surface);
    LayerMarks marks(painter, surface);
    for (const LayerDrawing::Area &area : drawing.areas)
        marks.paint(area);
    for (const LayerDrawing::Line &line : drawing.lines) {
        if (isPlain(line))
            marks.paint(line);
    }
    for (const LayerDrawing::Point &sample : drawing.samples)
        marks.paint(sample);
    const QString said = LayerTexts(painter, surface, m_glyphs).paintCells(drawing);
    return said.isEmpty() ? QStringList() : QStringList(said);
}

void LayerPainter::paintMarks(QPainter &painter, const LayerDrawing &drawing,
                              const LayerSurface &surface)
{
    const PaintingInView inView(painter, surface);
    LayerMarks marks(painter, surface);
    for (const LayerDrawing::Line &line : drawing.lines) {
        if (!isPlain(line))
            marks.paint(line);
    }
    for (const LayerDrawing::Circle &circle : drawing.circles)
        marks.paint(circle);
    for (const LayerDrawing::Measure &measure : drawing.measures)
        marks.paint(measure);
    for (const LayerDrawing::Point &point : drawing.points)
        marks.paint(point);
}

std::vector<QRectF> LayerPainter::measurePlaces(const LayerDrawing &drawing,
                                                const LayerSurface &surface)
{
    std::vector<QRectF> places;
    for (const LayerDrawing::Measure &measure : drawing.measures)
        places.push_back(measureRect(measure, surface));
    return places;
}

QStringList LayerPainter::paintLabels(QPainter &painter, const LayerDrawing &drawing,
                                      const LayerSurface &surface, std::span<const QRectF> taken)
{
    const PaintingInView inView(painter, surface);
    std::vector<QRectF> kept = measurePlaces(drawing, surface);
    kept.insert(kept.end(), taken.begin(), taken.end());
    LayerLabels labels(painter, surface, m_glyphs, kept);
    // The texts of measures before others, which may go farther from their places.
    for (const LayerDrawing::Measure &measure : drawing.measures)
        labels.place(measure.text, measureLine(measure, surface).center(), measure.ink);
    for (const LayerDrawing::Label &label : drawing.labels)
        labels.place(label.text, surface.fromSamples.map(label.place), label.ink);
    labels.paint();
    m_labels = labels.places();
    if (labels.omitted() == 0)
        return {};
    return {QStringLiteral("No room for %1 of %2 names: enlarge the picture, or show fewer layers")
                .arg(labels.omitted())
                .arg(drawing.labels.size() + drawing.measures.size())};
}

} // namespace pixelplumb
