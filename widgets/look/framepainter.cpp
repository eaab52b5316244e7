// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/framepainter.h"

#include "widgets/look/signs.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double edgeWidth = 1.5;
constexpr double candidateRadius = 4;
constexpr double gridAppears = 4; ///< cell size
constexpr double gridIsFull = 16;
constexpr double gridOpacity = 0.4;
constexpr double leastPickedBox = 7;

} // namespace

LayerSurface layerSurface(const ViewMapping &mapping, const QRectF &view, const QPalette &palette)
{
    return {pictureTransform(mapping.frame(), mapping.positionOfDevice(mapping.origin()),
                             cellSideOf(mapping)),
            view, isDark(palette) ? LayerTone::Dark : LayerTone::Light};
}

double cellSideOf(const ViewMapping &mapping)
{
    return mapping.zoom().factor() / mapping.devicePixelRatio();
}

QColor gridColour(const ViewMapping &mapping)
{
    const double length = mapping.zoom().devicePixels / mapping.devicePixelRatio();
    const double grown = (length - gridAppears) / (gridIsFull - gridAppears);
    return translucent(Qt::gray, gridOpacity * std::clamp(grown, 0.0, 1.0));
}

EdgeRoles rolesOf(const SetUpRecord &setUp)
{
    if (setUp.zeroArea || setUp.rejection || !setUp.longEdge)
        return {};
    EdgeRoles roles;
    for (int from = 0; from < 3; ++from) {
        const int opposite = (from + 2) % 3;
        const bool isLong = opposite == setUp.order[1];
        const bool isUpper = isLong == (setUp.longEdge == LongEdge::Above);
        roles[std::size_t(from)] = isUpper ? EdgeRole::Upper : EdgeRole::Lower;
    }
    return roles;
}

FramePainter::FramePainter(QPainter &painter, const ViewMapping &mapping, const QPalette &palette,
                           const QRectF &view)
    : m_painter(painter)
    , m_mapping(mapping)
    , m_palette(palette)
    , m_view(view)
{
}

void FramePainter::drawFrameEdge()
{
    const QRect picture = m_mapping.devicePicture();
    const QColor colour = translucent(m_palette.color(QPalette::WindowText), 0.5);
    const QRect around = picture.adjusted(-1, -1, 1, 1);
    fillDevice({around.left(), around.top(), around.width(), 1}, colour);
    fillDevice({around.left(), around.bottom(), around.width(), 1}, colour);
    fillDevice({around.left(), picture.top(), 1, picture.height()}, colour);
    fillDevice({around.right(), picture.top(), 1, picture.height()}, colour);
}

void FramePainter::drawGrid()
{
    const int cell = m_mapping.zoom().devicePixels;
    const QColor colour = gridColour(m_mapping);
    if (colour.alpha() == 0)
        return;
    const QRect shown = m_mapping.deviceRect(m_view) & m_mapping.devicePicture();
    const QPoint origin = m_mapping.origin();
    const auto firstLine
        = [cell](int from, int at) { return at + (from - at + cell - 1) / cell * cell; };
    for (int x = firstLine(shown.left(), origin.x()); x <= shown.right(); x += cell)
        fillDevice({x, shown.top(), 1, shown.height()}, colour);
    for (int y = firstLine(shown.top(), origin.y()); y <= shown.bottom(); y += cell)
        fillDevice({shown.left(), y, shown.width(), 1}, colour);
}

void FramePainter::drawOutline(const std::array<LatticePoint, 3> &corners, const EdgeRoles &roles)
{
    const auto colourOf = [this](EdgeRole role) {
        switch (role) {
        case EdgeRole::Lower:
            return signColour(Sign::LowerEdge, m_palette);
        case EdgeRole::Upper:
            return signColour(Sign::UpperEdge, m_palette);
        case EdgeRole::Plain:
            break;
        }
        return signColour(Sign::VertexMark, m_palette);
    };
    for (std::size_t from = 0; from < 3; ++from) {
        const QLineF edge(m_mapping.positionOf(corners[from]),
                          m_mapping.positionOf(corners[(from + 1) % 3]));
        drawCased(edge, colourOf(roles[from]), edgeWidth);
    }
}

void FramePainter::drawRubberLine(const LatticePoint &from, const LatticePoint &to)
{
    drawCased({m_mapping.positionOf(from), m_mapping.positionOf(to)},
              signColour(Sign::VertexMark, m_palette), edgeWidth, Qt::DashLine);
}

void FramePainter::drawHandle(const LatticePoint &point, const Colour &colour, HandleState state)
{
    const QPointF centre = m_mapping.positionOf(point);
    if (!isNearView(centre))
        return;
    m_painter.setRenderHint(QPainter::Antialiasing);
    if (state != HandleState::Idle) {
        const double halo = handleRadius + 4;
        const QColor highlight = m_palette.color(QPalette::Highlight);
        m_painter.setPen(QPen(casing(), 1));
        m_painter.setBrush(state == HandleState::Selected ? highlight
                                                          : translucent(highlight, 0.5));
        m_painter.drawEllipse(centre, halo, halo);
    }
    m_painter.setPen(QPen(casing(), 3.5));
    m_painter.setBrush(QColor::fromRgb(packed(colour)));
    m_painter.drawEllipse(centre, handleRadius, handleRadius);
    m_painter.setPen(QPen(signColour(Sign::VertexMark, m_palette), 1.5));
    m_painter.drawEllipse(centre, handleRadius, handleRadius);
    const QPointF corner(handleRadius, handleRadius);
    m_handles.emplace_back(centre - corner, centre + corner);
    m_plates.push_back(m_handles.back());
}

void FramePainter::drawCandidate(const LatticePoint &point, const Colour &colour)
{
    const QPointF centre = m_mapping.positionOf(point);
    m_painter.setRenderHint(QPainter::Antialiasing);
    m_painter.setBrush(translucent(QColor::fromRgb(packed(colour)), 0.6));
    m_painter.setPen(QPen(casing(), 3));
    m_painter.drawEllipse(centre, candidateRadius, candidateRadius);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(signColour(Sign::VertexMark, m_palette), 1));
    m_painter.drawEllipse(centre, candidateRadius, candidateRadius);
}

void FramePainter::drawPlumbLine(const SpanPlace &place)
{
    const FrameSpec &frame = m_mapping.frame();
    const bool isColumn = place.axis == SpanAxis::Column;
    const std::int64_t first = isColumn ? frame.firstColumn : frame.firstRow;
    const std::int64_t count = isColumn ? frame.width : frame.height;
    if (place.axis == SpanAxis::Free || place.coordinate < first
        || place.coordinate - first >= count)
        return;
    const int at = int(place.coordinate);
    const QRect cell = m_mapping.deviceCellOf(isColumn ? QPoint(at, frame.firstRow)
                                                       : QPoint(frame.firstColumn, at));
    const QRect view = m_mapping.deviceRect(m_view);
    // An even cell has no middle device pixel, so its line is two pixels wide and centred on the
    // samples.
    const int extent = isColumn ? cell.width() : cell.height();
    const int width = extent % 2 == 0 ? 2 : 1;
    const int start = (isColumn ? cell.left() : cell.top()) + (extent - width) / 2;
    const int side = std::max(1, int(m_mapping.devicePixelRatio()));
    const auto line = [&](int from, int thickness) {
        return isColumn ? QRect(from, view.top(), thickness, view.height())
                        : QRect(view.left(), from, view.width(), thickness);
    };
    fillDevice(line(start - side, width + 2 * side), translucent(casing(), 0.55));
    fillDevice(line(start, width), signColour(Sign::CurrentColumn, m_palette));
}

void FramePainter::drawPickedPixel(const QPoint &pixel)
{
    QRectF cell = m_mapping.cellOf(pixel);
    const double missing = std::max(0.0, (leastPickedBox - cell.width()) / 2);
    cell.adjust(-missing, -missing, missing, missing);
    if (!isNearView(cell.center()))
        return;
    m_painter.setRenderHint(QPainter::Antialiasing, false);
    m_painter.setBrush(Qt::NoBrush);
    QPen pen(casing(), 4);
    pen.setJoinStyle(Qt::MiterJoin);
    m_painter.setPen(pen);
    m_painter.drawRect(cell);
    pen.setWidth(2);
    pen.setColor(signColour(Sign::PickedPixel, m_palette));
    m_painter.setPen(pen);
    m_painter.drawRect(cell);
}

void FramePainter::drawPixelBreakpoint(const QPoint &pixel)
{
    const QRectF cell = m_mapping.cellOf(pixel);
    if (!isNearView(cell.center()))
        return;
    const double radius = std::clamp(cell.width() / 3, 3.0, 6.0);
    m_painter.setRenderHint(QPainter::Antialiasing);
    m_painter.setPen(QPen(casing(), 1.5));
    m_painter.setBrush(signColour(Sign::Breakpoint, m_palette));
    m_painter.drawEllipse(cell.center(), radius, radius);
}

QColor FramePainter::casing() const { return isDark(m_palette) ? Qt::black : Qt::white; }

void FramePainter::drawCased(const QLineF &line, const QColor &colour, double width,
                             Qt::PenStyle style)
{
    const std::optional<QLineF> visible = clipped(line, m_view.adjusted(-9, -9, 9, 9));
    if (!visible)
        return;
    m_painter.setRenderHint(QPainter::Antialiasing);
    m_painter.setPen(QPen(translucent(casing(), 0.8), width + 2, Qt::SolidLine, Qt::RoundCap));
    m_painter.drawLine(*visible);
    m_painter.setPen(QPen(colour, width, style, Qt::FlatCap));
    m_painter.drawLine(*visible);
}

void FramePainter::fillDevice(const QRect &device, const QColor &colour)
{
    m_painter.setRenderHint(QPainter::Antialiasing, false);
    m_painter.fillRect(QRectF(m_mapping.positionOfDevice(device.topLeft()),
                              QSizeF(device.size()) / m_mapping.devicePixelRatio()),
                       colour);
}

bool FramePainter::isNearView(const QPointF &position) const
{
    return m_view.adjusted(-20, -20, 20, 20).contains(position);
}

} // namespace pixelplumb
