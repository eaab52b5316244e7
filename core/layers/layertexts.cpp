// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layertexts.h"

#include "core/layers/layermarks.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

// Logical pixels.
constexpr double largestEm = 14;
constexpr double leastEm = 6;
constexpr double sampleGap = 1; ///< between a sample and a number

constexpr double usedCell = 0.92; ///< of a cell's side
constexpr float paperOpacity = 0.95F; // texts keep 4.5:1 on black and white

using Pixel = std::pair<std::int64_t, std::int64_t>;
using TextsByPixel = std::map<Pixel, std::vector<const LayerDrawing::CellText *>>;

TextsByPixel byPixel(std::span<const LayerDrawing::CellText> texts)
{
    TextsByPixel sorted;
    for (const LayerDrawing::CellText &text : texts)
        sorted[{text.y, text.x}].push_back(&text);
    return sorted;
}

/// The part of every cell that has room for text, across its whole width.
struct FreeBand {
    double top = -usedCell / 2; ///< below the cell's middle, as a share of its side
    double bottom = usedCell / 2;
    double takenAbove = 0; ///< by a sample at its top, logical px
    double takenBelow = 0;

    double height(double cell) const { return (bottom - top) * cell - takenAbove - takenBelow; }
    /// The smallest cell in which it is this high.
    double cellFor(double height) const
    {
        return (height + takenAbove + takenBelow) / (bottom - top);
    }
    /// Its middle below the cell's middle, logical px.
    double middle(double cell) const
    {
        return ((top + bottom) * cell + takenAbove - takenBelow) / 2;
    }
};

/// The highest of the bands between the samples, which have the same places in every cell; of equal
/// ones the lowest.
FreeBand freeBand(std::span<const LayerDrawing::Point> samples, const LayerSurface &surface)
{
    const double cell = surface.fromSamples.m11();
    std::vector<double> heights;
    for (const LayerDrawing::Point &sample : samples) {
        const double row = std::floor(sample.place.y() + 0.5);
        heights.push_back((sample.place.y() - row) * surface.fromSamples.m22() / cell);
    }
    std::ranges::sort(heights);
    constexpr double taken = largestPointRadius + sampleGap;
    FreeBand highest;
    for (std::size_t i = 0; i <= heights.size() && !heights.empty(); ++i) {
        FreeBand band;
        if (i > 0) {
            band.top = heights[i - 1];
            band.takenAbove = taken;
        }
        if (i < heights.size()) {
            band.bottom = heights[i];
            band.takenBelow = taken;
        }
        if (i == 0 || band.height(cell) >= highest.height(cell))
            highest = band;
    }
    return highest;
}

/// The note for numbers that do not fit in cells.
QString cellsTooSmall(const QStringList &names, double side)
{
    const QString what = names.isEmpty() ? QString() : u" (%1)"_s.arg(names.join(u", "));
    return u"No room for the numbers in the cells%1: they need cells of %2 pixels; "
           "enlarge the picture, or show fewer layers"_s.arg(what)
               .arg(std::ceil(side));
}

QString inCells(const QStringList &names)
{
    if (names.isEmpty())
        return {};
    const QString listed = names.join(u", ");
    return listed.contains(u',') ? u"In the cells, from the top: %1"_s.arg(listed)
                                 : u"In the cells: %1"_s.arg(listed);
}

} // namespace

QString LayerTexts::paintCells(const LayerDrawing &drawing)
{
    if (drawing.cells.empty())
        return {};
    double widest = 0;
    for (const LayerDrawing::CellText &text : drawing.cells)
        widest = std::max(widest, m_glyphs.widthOf(text.text));
    std::size_t most = 1;
    const TextsByPixel sorted = byPixel(drawing.cells);
    for (const auto &[pixel, lines] : sorted)
        most = std::max(most, lines.size());
    if (widest == 0)
        return {}; // there is no font
    const double cell = m_surface.fromSamples.m11();
    const FreeBand band = freeBand(drawing.samples, m_surface);
    const double highest = lineHeight * double(most);
    const double em = std::min({largestEm, usedCell * cell / widest, band.height(cell) / highest});
    if (em < leastEm)
        return cellsTooSmall(
            drawing.cellNames,
            std::max(leastEm * widest / usedCell, band.cellFor(leastEm * highest)));
    for (const auto &[pixel, lines] : sorted) {
        const QPointF centre
            = m_surface.fromSamples.map(QPointF(double(pixel.second), double(pixel.first)));
        if (!m_surface.view.adjusted(-cell, -cell, cell, cell).contains(centre))
            continue;
        const double height = lineHeight * em * double(lines.size());
        double top = centre.y() + band.middle(cell) - height / 2;
        paintPaper({centre.x() - widest * em / 2, top, widest * em, height});
        for (const LayerDrawing::CellText *line : lines) {
            const double width = m_glyphs.widthOf(line->text) * em;
            paintText(line->text, {centre.x() - width / 2, top + ascent * em}, em, line->ink);
            top += lineHeight * em;
        }
    }
    return inCells(drawing.cellNames);
}

void LayerTexts::paintText(const QString &text, const QPointF &baseline, double em, LayerInk ink)
{
    QTransform place;
    place.translate(baseline.x(), baseline.y());
    place.scale(em, em);
    m_painter.fillPath(place.map(m_glyphs.outlineOf(text)), colourOf(ink, m_surface.tone));
}

void LayerTexts::paintPaper(const QRectF &rect)
{
    QColor paper = paperOf(m_surface.tone);
    paper.setAlphaF(paperOpacity);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(paper);
    m_painter.drawRoundedRect(rect, 2, 2);
}

} // namespace pixelplumb
