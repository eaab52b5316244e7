// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layerpainter.h"

#include "core/layers/clippedline.h"
#include "core/layers/layerlabels.h"
#include "core/layers/layermarks.h"
#include "core/layers/layertexts.h"

#include <QPainter>

#include <array>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

struct InkColours {
    QRgb light; ///< on light paper
    QRgb dark; ///< on dark paper
};
/// By LayerInk.
constexpr std::array<InkColours, 7> inkColours = {{{0x202020, 0xf0f0f0},
                                                   {0x0072b2, 0x56b4e9},
                                                   {0xb34700, 0xff9e4a},
                                                   {0x8a3f6e, 0xe39ac4},
                                                   {0x0072b2, 0x56b4e9},
                                                   {0xb34700, 0xff9e4a},
                                                   {0x00775a, 0x2fd0a0}}};

/// Clips painting to the view.
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

/// Small squares along the visible part of a line.
void appendPieces(const LayerDrawing::Line &line, const LayerSurface &surface,
                  std::vector<QRectF> &places)
{
    constexpr double piece = 8; // logical px
    const std::optional<QLineF> visible = clipped(
        QLineF(surface.fromSamples.map(line.from), surface.fromSamples.map(line.to)), surface.view);
    const double length = visible ? visible->length() : 0;
    for (double at = 0; at < length; at += piece)
        places.emplace_back(visible->pointAt(at / length) - QPointF(piece, piece) / 2,
                            QSizeF(piece, piece));
}

/// The points, bands and arrows of a drawing, which a name on top would hide.
std::vector<QRectF> namedPlaces(const LayerDrawing &drawing, const LayerSurface &surface)
{
    const QPointF radius(largestPointRadius, largestPointRadius);
    std::vector<QRectF> places;
    for (const LayerDrawing::Point &point : drawing.points) {
        const QPointF place = surface.fromSamples.map(point.place);
        places.emplace_back(place - radius, place + radius);
    }
    for (const LayerDrawing::Line &line : drawing.lines) {
        if (line.stroke == LayerDrawing::Stroke::Band)
            places.push_back(
                QRectF(surface.fromSamples.map(line.from), surface.fromSamples.map(line.to))
                    .normalized()
                    .adjusted(0, -bandWidth / 2, 0, bandWidth / 2));
        if (line.stroke == LayerDrawing::Stroke::Arrow)
            appendPieces(line, surface, places);
    }
    return places;
}

} // namespace

QColor colourOf(LayerInk ink, LayerTone tone)
{
    const InkColours &colours = inkColours[std::size_t(ink)];
    return QColor::fromRgb(tone == LayerTone::Light ? colours.light : colours.dark);
}

QColor paperOf(LayerTone tone)
{
    return QColor::fromRgb(tone == LayerTone::Light ? 0xffffff : 0x202020);
}

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
    paintGround(painter, drawing, surface);
    QStringList said = paintNumbers(painter, drawing, surface);
    paintMarks(painter, drawing, surface);
    said += paintLabels(painter, drawing, surface, {});
    return said;
}

void LayerPainter::paintGround(QPainter &painter, const LayerDrawing &drawing,
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
}

QStringList LayerPainter::paintNumbers(QPainter &painter, const LayerDrawing &drawing,
                                       const LayerSurface &surface)
{
    const PaintingInView inView(painter, surface);
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

std::vector<QRectF> LayerPainter::figurePlaces(const LayerDrawing &drawing,
                                               const LayerSurface &surface)
{
    std::vector<QRectF> places = measurePlaces(drawing, surface);
    for (const LayerDrawing::Line &line : drawing.lines)
        appendPieces(line, surface, places);
    return places;
}

QStringList LayerPainter::paintLabels(QPainter &painter, const LayerDrawing &drawing,
                                      const LayerSurface &surface, std::span<const QRectF> taken)
{
    const PaintingInView inView(painter, surface);
    const std::vector<QRectF> bars = measurePlaces(drawing, surface);
    std::vector<QRectF> kept = bars;
    kept.insert(kept.end(), taken.begin(), taken.end());
    LayerLabels labels(painter, surface, m_glyphs, kept);
    // Texts of measures first: other names may go farther from their places.
    for (std::size_t i = 0; i < bars.size(); ++i) {
        std::vector<QRectF> others = bars;
        others.erase(others.begin() + std::ptrdiff_t(i));
        const LayerDrawing::Measure &measure = drawing.measures[i];
        labels.placeBeside(measure.text, bars[i], besideMeasure(measure, surface, 1), others,
                           measure.ink);
    }
    const std::vector<QRectF> shown = namedPlaces(drawing, surface);
    kept.insert(kept.end(), shown.begin(), shown.end());
    labels.keepClearOf(kept);
    for (const LayerDrawing::Label &label : drawing.labels)
        labels.place(label);
    labels.paint();
    m_labels = labels.places();
    if (labels.omitted() == 0)
        return {};
    return {u"No room for %1 of %2 names: enlarge the picture, or show fewer layers"_s
                .arg(labels.omitted())
                .arg(drawing.labels.size() + drawing.measures.size())};
}

} // namespace pixelplumb
