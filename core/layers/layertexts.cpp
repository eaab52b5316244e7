// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layertexts.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double labelEm = 12;
constexpr double largestEm = 14;
constexpr double leastEm = 6;
constexpr double labelGap = 6;
constexpr double paperPadding = 3;
constexpr double nearView = 20; ///< names of what is farther would crowd the border

// In ems.
constexpr double lineHeight = 1.2;
constexpr double ascent = 0.9;

constexpr double usedCell = 0.92; ///< of a cell's side
constexpr float paperOpacity = 0.85F;

using Pixel = std::pair<std::int64_t, std::int64_t>;
using TextsByPixel = std::map<Pixel, std::vector<const LayerDrawing::CellText *>>;

TextsByPixel byPixel(std::span<const LayerDrawing::CellText> texts)
{
    TextsByPixel sorted;
    for (const LayerDrawing::CellText &text : texts)
        sorted[{text.y, text.x}].push_back(&text);
    return sorted;
}

/// Right above the anchor first, then the other quarters.
std::array<QPointF, 4> placesAround(const QPointF &anchor, const QSizeF &size)
{
    const double right = anchor.x() + labelGap;
    const double left = anchor.x() - labelGap - size.width();
    const double above = anchor.y() - labelGap - size.height();
    const double below = anchor.y() + labelGap;
    return {QPointF(right, above), QPointF(right, below), QPointF(left, above),
            QPointF(left, below)};
}

/// Kept in view, so that a name near the border can be read.
QRectF movedInto(QRectF rect, const QRectF &view)
{
    rect.moveLeft(std::max(std::min(rect.left(), view.right() - rect.width()), view.left()));
    rect.moveTop(std::max(std::min(rect.top(), view.bottom() - rect.height()), view.top()));
    return rect;
}

} // namespace

void LayerTexts::paintCells(std::span<const LayerDrawing::CellText> texts)
{
    if (texts.empty())
        return;
    double widest = 0;
    for (const LayerDrawing::CellText &text : texts)
        widest = std::max(widest, m_glyphs.widthOf(text.text));
    std::size_t most = 1;
    const TextsByPixel sorted = byPixel(texts);
    for (const auto &[pixel, lines] : sorted)
        most = std::max(most, lines.size());
    const double side = m_surface.fromSamples.m11() * usedCell;
    const double em = std::min({largestEm, side / widest, side / (lineHeight * double(most))});
    if (em < leastEm || widest == 0) // without a font there is no width
        return;
    for (const auto &[pixel, lines] : sorted) {
        const QPointF centre
            = m_surface.fromSamples.map(QPointF(double(pixel.second), double(pixel.first)));
        if (!m_surface.view.adjusted(-side, -side, side, side).contains(centre))
            continue;
        const double height = lineHeight * em * double(lines.size());
        double top = centre.y() - height / 2;
        paintPaper({centre.x() - widest * em / 2, top, widest * em, height});
        for (const LayerDrawing::CellText *line : lines) {
            const double width = m_glyphs.widthOf(line->text) * em;
            paintText(line->text, {centre.x() - width / 2, top + ascent * em}, em, line->ink);
            top += lineHeight * em;
        }
    }
}

void LayerTexts::paint(const LayerDrawing::Label &label)
{
    const QPointF anchor = m_surface.fromSamples.map(label.place);
    if (!m_surface.view.adjusted(-nearView, -nearView, nearView, nearView).contains(anchor))
        return;
    const QSizeF size(m_glyphs.widthOf(label.text) * labelEm + 2 * paperPadding,
                      lineHeight * labelEm + 2);
    const auto places = placesAround(anchor, size);
    const auto rectAt = [&](const QPointF &place) {
        return movedInto({place, size}, m_surface.view);
    };
    const auto free = std::ranges::find_if(places, [&](const QPointF &place) {
        const QRectF rect = rectAt(place);
        return std::ranges::none_of(
            m_labels, [&rect](const QRectF &other) { return other.intersects(rect); });
    });
    const QRectF rect = rectAt(free != places.end() ? *free : places.front());
    m_labels.push_back(rect);
    paintPaper(rect);
    paintText(label.text, rect.topLeft() + QPointF(paperPadding, 1 + ascent * labelEm), labelEm,
              label.ink);
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
