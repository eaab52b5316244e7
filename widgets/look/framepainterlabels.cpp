// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/framepainter.h"

#include <QtWidgets>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double tickHalfLength = 9;
constexpr double nearTicks = 24;
constexpr double nameParting = 12;
constexpr double noteGap = 8;
constexpr int noteFlags = int(Qt::AlignCenter) | Qt::TextWordWrap;
constexpr double platePadding = 3;
constexpr QSizeF pointerSize(6, 10); ///< beyond its hot spot

/// Places for a note in the view, in order of preference: the corners from the lower left, then
/// between them.
constexpr std::array notePlaces
    = {QPointF(0, 1),   QPointF(1, 1),   QPointF(0, 0),   QPointF(1, 0),
       QPointF(0.5, 1), QPointF(0.5, 0), QPointF(0, 0.5), QPointF(1, 0.5)};
constexpr std::array noteShares = {1.0, 0.5, 0.33}; ///< of the widest note, to try

/// Places for the pointer's note around it, in order of preference.
constexpr std::array pointerSides
    = {NoteSide::BelowRight, NoteSide::AboveRight, NoteSide::BelowLeft, NoteSide::AboveLeft};

/// Radians from the preferred side of a vertex's name, nearest first.
constexpr std::array nameTurns
    = {0.0, 0.4, -0.4, 0.8, -0.8, 1.2, -1.2, 1.6, -1.6, 2.0, -2.0, 2.4, -2.4, 2.8, -2.8};

constexpr double subscriptSize = 0.8; ///< of the symbol's
constexpr float plateOpacity = 0.95F; // texts keep 4.5:1 on black and white

QSizeF plateSize(const QSizeF &text) { return text + QSizeF(2 * platePadding, 2); }

std::ptrdiff_t coveredBy(const QRectF &plate, std::span<const QRectF> places)
{
    return std::ranges::count_if(places,
                                 [&plate](const QRectF &place) { return place.intersects(plate); });
}

/// The rectangle of a plate beside its anchor.
QRectF placed(const QSizeF &size, const QPointF &anchor, NoteSide side)
{
    const double right = anchor.x() + noteGap;
    const double left = anchor.x() - size.width() - noteGap;
    const double above = anchor.y() - size.height() - noteGap / 2;
    const double below = anchor.y() + noteGap / 2;
    const double middle = anchor.x() - size.width() / 2;
    switch (side) {
    case NoteSide::Right:
        return {QPointF(right, anchor.y() - size.height() / 2), size};
    case NoteSide::Above:
        return {QPointF(middle, above - noteGap / 2), size};
    case NoteSide::Below:
        return {QPointF(middle, below + noteGap / 2), size};
    case NoteSide::AboveRight:
        return {QPointF(right, above), size};
    case NoteSide::BelowRight:
        return {QPointF(right, below), size};
    case NoteSide::AboveLeft:
        return {QPointF(left, above), size};
    case NoteSide::BelowLeft:
        return {QPointF(left, below), size};
    }
    return {anchor, size};
}

} // namespace

void FramePainter::drawVertexName(const QString &name, const LatticePoint &point,
                                  const QPointF &inside)
{
    const QPointF centre = m_mapping.positionOf(point);
    if (!isNearView(centre))
        return;
    const QPointF away = centre - inside;
    const double distance = std::hypot(away.x(), away.y());
    const QPointF direction = distance > 0 ? away / distance : QPointF(0, -1);
    const QFontMetricsF metrics(m_painter.font());
    const QSizeF size(metrics.horizontalAdvance(name), metrics.height());
    // Far enough for a side of the plate to clear the handle.
    const QSizeF clear = plateSize(size) / 2 + QSizeF(handleRadius + 4, handleRadius + 4);
    const auto anchorAt = [&](double turn) {
        const QPointF turned(direction.x() * std::cos(turn) - direction.y() * std::sin(turn),
                             direction.x() * std::sin(turn) + direction.y() * std::cos(turn));
        const double reach
            = std::min(clear.width() / std::abs(turned.x()), clear.height() / std::abs(turned.y()));
        return centre + turned * reach + QPointF(0, size.height() / 2 + platePadding + noteGap);
    };
    const auto free = std::ranges::find_if(nameTurns, [&](double turn) {
        return isFree(plateAt(size, anchorAt(turn), NoteSide::Above));
    });
    const QRectF text = drawPlate(
        size, anchorAt(free != nameTurns.end() ? *free : nameTurns.front()), NoteSide::Above);
    m_painter.setPen(m_palette.color(QPalette::Text));
    m_painter.drawText(text, Qt::AlignCenter, name);
}

void FramePainter::drawEdgeTicks(const SpanRecord &span, EdgeNames names)
{
    if (span.lower.isNone() || span.upper.isNone() || span.place.axis == SpanAxis::Free)
        return;
    const double at = double(span.place.coordinate);
    const double lower = span.lower.toDouble();
    const double upper = span.upper.toDouble();
    if (span.place.axis == SpanAxis::Row) {
        const QPointF left = m_mapping.positionOf(lower, at);
        const QPointF right = m_mapping.positionOf(upper, at);
        drawEdgeTick(left, Sign::LowerEdge, Qt::Vertical);
        drawEdgeTick(right, Sign::UpperEdge, Qt::Vertical);
        if (names == EdgeNames::Hidden)
            return;
        const double parting = right.x() - left.x() < nearTicks ? nameParting : 0;
        drawEdgeName(left - QPointF(parting, 0), {"x", "L"}, Sign::LowerEdge, NoteSide::Below);
        drawEdgeName(right + QPointF(parting, 0), {"x", "R"}, Sign::UpperEdge, NoteSide::Above);
        return;
    }
    const QPointF bottom = m_mapping.positionOf(at, lower);
    const QPointF top = m_mapping.positionOf(at, upper);
    const bool upward = m_mapping.frame().origin == FrameOrigin::BottomLeft;
    // Where the edges meet, the names move apart so that the vertex's own name fits between them.
    const double parting = std::abs(top.y() - bottom.y()) < nearTicks ? nameParting : 0;
    const QPointF away(0, upward ? -parting : parting);
    drawEdgeTick(bottom, Sign::LowerEdge, Qt::Horizontal);
    drawEdgeTick(top, Sign::UpperEdge, Qt::Horizontal);
    if (names == EdgeNames::Hidden)
        return;
    drawEdgeName(bottom - away, {"y", "B"}, Sign::LowerEdge,
                 upward ? NoteSide::BelowRight : NoteSide::AboveRight);
    drawEdgeName(top + away, {"y", "T"}, Sign::UpperEdge,
                 upward ? NoteSide::AboveRight : NoteSide::BelowRight);
}

void FramePainter::drawEdgeTick(const QPointF &at, Sign sign, Qt::Orientation along)
{
    const QPointF arm
        = along == Qt::Horizontal ? QPointF(tickHalfLength, 0) : QPointF(0, tickHalfLength);
    drawCased({at - arm, at + arm}, signColour(sign, m_palette), 2);
}

void FramePainter::drawEdgeName(const QPointF &at, const EdgeName &name, Sign sign, NoteSide side)
{
    if (!isNearView(at))
        return;
    const QString symbol = QLatin1String(name.symbol);
    const QString subscript = QLatin1String(name.subscript);
    const QFont font = m_painter.font();
    QFont small = font;
    small.setPixelSize(qRound(QFontInfo(font).pixelSize() * subscriptSize));
    const QFontMetricsF metrics(font);
    const double symbolWidth = metrics.horizontalAdvance(symbol);
    const QSizeF size(symbolWidth + QFontMetricsF(small).horizontalAdvance(subscript) + 1,
                      metrics.height());
    const QRectF text = drawPlate(size, at, side);
    const QPointF baseline(text.left(), text.top() + metrics.ascent());
    m_painter.setPen(signColour(sign, m_palette));
    m_painter.drawText(baseline, symbol);
    m_painter.setFont(small);
    m_painter.drawText(baseline + QPointF(symbolWidth + 1, metrics.descent()), subscript);
    m_painter.setFont(font);
}

void FramePainter::drawNote(const QString &text, const QPointF &anchor, NoteSide side)
{
    drawNoteIn(plateAt(noteSize(text, widestNote()), anchor, side), text);
    m_notes.push_back(m_plates.back());
}

void FramePainter::drawPointerNote(const QString &text, const QPointF &pointer,
                                   std::span<const QRectF> places)
{
    const QSizeF size = noteSize(text, widestNote());
    std::vector<QRectF> plates; // by preference
    for (const NoteSide side : pointerSides) {
        const bool isRight = side == NoteSide::BelowRight || side == NoteSide::AboveRight;
        const bool isBelow = side == NoteSide::BelowRight || side == NoteSide::BelowLeft;
        const QPointF anchor = pointer
            + QPointF(isRight ? pointerSize.width() : 0, isBelow ? pointerSize.height() : 0);
        plates.push_back(plateAt(size, anchor, side));
    }
    for (const QRectF &note : m_notes) {
        const QPointF beside(std::clamp(pointer.x(), note.left(), note.right()),
                             std::clamp(pointer.y(), note.top(), note.bottom()));
        plates.push_back(plateAt(size, {beside.x(), note.top()}, NoteSide::Above));
        plates.push_back(plateAt(size, {beside.x(), note.bottom()}, NoteSide::Below));
        plates.push_back(plateAt(size, {note.right(), beside.y()}, NoteSide::Right));
    }
    const auto isClearOf = [](const QRectF &plate, std::span<const QRectF> taken) {
        return coveredBy(plate, taken) == 0;
    };
    auto found = std::ranges::find_if(plates, [&](const QRectF &plate) {
        return isClearOf(plate, m_notes) && isClearOf(plate, places);
    });
    if (found == plates.end())
        found = std::ranges::find_if(
            plates, [&](const QRectF &plate) { return isClearOf(plate, m_notes); });
    drawNoteIn(found != plates.end() ? *found : plates.front(), text);
}

void FramePainter::drawCornerNote(const QString &text, std::span<const QRectF> places)
{
    const QRectF within = m_view.adjusted(noteGap, noteGap / 2, -noteGap, -noteGap / 2);
    std::vector<QRectF> plates; // by preference
    for (const double share : noteShares) {
        const QSizeF size = plateSize(noteSize(text, widestNote() * share));
        const QSizeF room = within.size() - size;
        for (const QPointF &place : notePlaces)
            plates.emplace_back(within.topLeft()
                                    + QPointF(place.x() * room.width(), place.y() * room.height()),
                                size);
    }
    const QRect device = m_mapping.devicePicture();
    const QRectF picture(m_mapping.positionOfDevice(device.topLeft()),
                         QSizeF(device.size()) / m_mapping.devicePixelRatio());
    const auto covered = [&](const QRectF &plate) {
        const QRectF ofPicture = plate & picture;
        return std::tuple(coveredBy(plate, m_handles),
                          coveredBy(plate, m_plates) + coveredBy(plate, places),
                          std::round(ofPicture.width() * ofPicture.height()));
    };
    drawNoteIn(*std::ranges::min_element(plates, {}, covered), text);
    m_notes.push_back(m_plates.back());
}

double FramePainter::widestNote() const
{
    return std::max(m_view.width() - 2 * (noteGap + platePadding), 1.0);
}

/// The size of the text broken into lines.
QSizeF FramePainter::noteSize(const QString &text, double widest) const
{
    return QFontMetricsF(m_painter.font())
        .boundingRect(QRectF(0, 0, widest, m_view.height()), noteFlags, text)
        .size();
}

void FramePainter::drawNoteIn(const QRectF &plate, const QString &text)
{
    const QRectF rect = drawPlateIn(plate);
    m_painter.setPen(m_palette.color(QPalette::Text));
    m_painter.drawText(rect, noteFlags | Qt::TextDontClip, text);
}

QRectF FramePainter::plateAt(const QSizeF &text, const QPointF &anchor, NoteSide side) const
{
    const QSizeF size = plateSize(text);
    QRectF plate = placed(size, anchor, side);
    // Kept inside the view, so that a name near the border can be read.
    plate.moveLeft(std::max(std::min(plate.left(), m_view.right() - size.width()), m_view.left()));
    plate.moveTop(std::max(std::min(plate.top(), m_view.bottom() - size.height()), m_view.top()));
    return plate;
}

bool FramePainter::isFree(const QRectF &plate) const { return coveredBy(plate, m_plates) == 0; }

QRectF FramePainter::drawPlate(const QSizeF &text, const QPointF &anchor, NoteSide side)
{
    return drawPlateIn(plateAt(text, anchor, side));
}

QRectF FramePainter::drawPlateIn(const QRectF &plate)
{
    m_plates.push_back(plate);
    m_painter.setRenderHint(QPainter::Antialiasing);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(translucent(m_palette.color(QPalette::Base), plateOpacity));
    m_painter.drawRoundedRect(plate, 3, 3);
    return plate.adjusted(platePadding, 1, -platePadding, -1);
}

} // namespace pixelplumb
