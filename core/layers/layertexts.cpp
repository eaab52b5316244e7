// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layertexts.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double labelEm = 12;
constexpr double largestEm = 14;
constexpr double leastEm = 6;
constexpr std::array labelGaps = {6.0, 20.0, 36.0, 54.0, 76.0}; ///< from the anchor, to each side
constexpr double leaderGap = 8; ///< a label that is farther from its anchor has a line to it
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

/// Where a label may stand beside its anchor, the nearest first: right above it, in the other
/// quarters, then farther and farther aside.
std::vector<QPointF> placesAround(const QPointF &anchor, const QSizeF &size)
{
    std::vector<QPointF> places;
    const double middle = anchor.x() - size.width() / 2;
    const double level = anchor.y() - size.height() / 2;
    for (const double gap : labelGaps) {
        const double right = anchor.x() + gap;
        const double left = anchor.x() - gap - size.width();
        const double above = anchor.y() - gap - size.height();
        const double below = anchor.y() + gap;
        places.insert(places.end(), {{right, above}, {right, below}, {left, above}, {left, below}});
        if (gap > leaderGap)
            places.insert(places.end(),
                          {{middle, above}, {middle, below}, {right, level}, {left, level}});
    }
    return places;
}

QPointF nearestIn(const QRectF &rect, const QPointF &point)
{
    return {std::clamp(point.x(), rect.left(), rect.right()),
            std::clamp(point.y(), rect.top(), rect.bottom())};
}

/// What is to be said of numbers that cells have no room for.
QString cellsTooSmall(double side)
{
    return QStringLiteral("The numbers need cells of %1 pixels: enlarge the picture")
        .arg(std::ceil(side));
}

/// Kept in view, so that a name near the border can be read.
QRectF movedInto(QRectF rect, const QRectF &view)
{
    rect.moveLeft(std::max(std::min(rect.left(), view.right() - rect.width()), view.left()));
    rect.moveTop(std::max(std::min(rect.top(), view.bottom() - rect.height()), view.top()));
    return rect;
}

} // namespace

QString LayerTexts::paintCells(std::span<const LayerDrawing::CellText> texts)
{
    if (texts.empty())
        return {};
    double widest = 0;
    for (const LayerDrawing::CellText &text : texts)
        widest = std::max(widest, m_glyphs.widthOf(text.text));
    std::size_t most = 1;
    const TextsByPixel sorted = byPixel(texts);
    for (const auto &[pixel, lines] : sorted)
        most = std::max(most, lines.size());
    if (widest == 0)
        return {}; // there is no font
    const double side = m_surface.fromSamples.m11() * usedCell;
    const double ems = std::max(widest, lineHeight * double(most)); // that a cell has to hold
    const double em = std::min(largestEm, side / ems);
    if (em < leastEm)
        return cellsTooSmall(leastEm * ems / usedCell);
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
    return {};
}

LayerTexts::Room LayerTexts::paint(const LayerDrawing::Label &label)
{
    const QPointF anchor = m_surface.fromSamples.map(label.place);
    if (!m_surface.view.adjusted(-nearView, -nearView, nearView, nearView).contains(anchor))
        return Room::Found;
    const QSizeF size(m_glyphs.widthOf(label.text) * labelEm + 2 * paperPadding,
                      lineHeight * labelEm + 2);
    for (const QPointF &place : placesAround(anchor, size)) {
        const QRectF rect = movedInto({place, size}, m_surface.view);
        if (std::ranges::any_of(m_taken,
                                [&rect](const QRectF &other) { return other.intersects(rect); }))
            continue;
        m_taken.push_back(rect);
        paintLeader({anchor, nearestIn(rect, anchor)}, label.ink);
        paintPaper(rect);
        paintText(label.text, rect.topLeft() + QPointF(paperPadding, 1 + ascent * labelEm), labelEm,
                  label.ink);
        return Room::Found;
    }
    return Room::None;
}

void LayerTexts::paintLeader(const QLineF &leader, LayerInk ink)
{
    if (leader.length() <= leaderGap * std::sqrt(2.0))
        return;
    m_painter.setPen(QPen(paperOf(m_surface.tone), 3, Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(leader);
    m_painter.setPen(QPen(colourOf(ink, m_surface.tone), 1, Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(leader);
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
