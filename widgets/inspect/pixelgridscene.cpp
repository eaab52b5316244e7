// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/pixelgridscene.h"

#include "core/number/wholenumber.h"
#include "core/oracle/oracle.h"
#include "core/runs/explain/edgerefusal.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"

#include <algorithm>

namespace pixelplumb {

namespace {

bool isTie(const Triangle &triangle, FillRule rule, const QPoint &pixel)
{
    const oracle::SampleVerdict verdict = oracle::judge(triangle, rule, pixel.x(), pixel.y());
    if (verdict.zeroArea)
        return verdict.covered;
    const auto isInside = [](const oracle::EdgeVerdict &edge) { return edge.edgeFunction >= 0; };
    const auto isOn = [](const oracle::EdgeVerdict &edge) { return edge.edgeFunction == 0; };
    return std::ranges::all_of(verdict.edges, isInside) && std::ranges::any_of(verdict.edges, isOn);
}

/// The name of a span that crosses the cells; empty for other spans.
QString nameAmongCells(const SpanPlace &place, const ViewMapping &mapping)
{
    const FrameView cells = windowOf(mapping.frame());
    const std::int64_t at = place.coordinate;
    if (place.axis == SpanAxis::Column && at >= cells.firstColumn && at < cells.endColumn())
        return QCoreApplication::translate("pixelplumb::PixelGrid", "column %1").arg(at);
    if (place.axis == SpanAxis::Row && at >= cells.firstRow && at < cells.endRow())
        return QCoreApplication::translate("pixelplumb::PixelGrid", "row %1").arg(at);
    return {};
}

std::int64_t ceilingOf(const Quantity &quantity)
{
    return quantity.isRational()
        ? std::int64_t(-floorDivide<Int128>(-quantity.numerator(), quantity.denominator()))
        : ceilOf(quantity.toDouble());
}

/// The heading of the number that a method rounds to a bound's sample, if it shows one.
QString headingOf(const std::vector<NumberDescription> &numbers, const QString &idStart)
{
    for (const NumberDescription &number : numbers) {
        const bool rounds = number.title.contains(u'⌈') || number.title.contains(u'⌊');
        if (rounds && number.id.startsWith(idStart))
            return QString(number.title).remove(u' ');
    }
    return {};
}

std::array<QString, 2> roundingsOf(const TracedScene &traced, std::size_t index)
{
    const SpanRecord span = traced.trace->span(index);
    const bool isRow = span.place.axis == SpanAxis::Row;
    if (traced.antialiasing() == Antialiasing::Area)
        return isRow ? std::array{u"x_first"_s, u"x_last"_s}
                     : std::array{u"y_first"_s, u"y_last"_s};
    const std::vector<NumberDescription> numbers = traced.trace->spanWords(index).numbers;
    std::array<QString, 2> roundings
        = {headingOf(numbers, u"first_"_s), headingOf(numbers, u"last_"_s)};
    if (!roundings[0].isEmpty() && !roundings[1].isEmpty())
        return roundings;
    // An edge to which the rule gives its samples is rounded otherwise than one that loses them.
    const FillRule rule = traced.scene.settings.fillRule;
    const bool ownsFirst = rule != FillRule::Open && span.firstSample == ceilingOf(span.lower);
    const bool ownsLast = rule == FillRule::Closed || span.endSample != ceilingOf(span.upper);
    roundings = {ownsFirst ? u"⌈%1⌉"_s : u"⌊%1⌋+1"_s, ownsLast ? u"⌊%1⌋"_s : u"⌈%1⌉−1"_s};
    return {roundings[0].arg(isRow ? u"x_L"_s : u"y_B"_s),
            roundings[1].arg(isRow ? u"x_R"_s : u"y_T"_s)};
}

class CellMaker {
public:
    CellMaker(const Playhead &playhead, const DisplayOptions &options)
        : m_traced(*playhead.traced())
        , m_position(playhead.position())
        , m_samplesDone(m_traced.trace->samplesDoneAt(m_position))
        , m_triangle(currentTriangle(playhead))
        , m_isAheadHidden(playhead.isAheadHidden())
        , m_shown(options.isTruthShown() && !m_isAheadHidden ? m_traced.truth.view()
                                                             : playhead.frame()->view())
        , m_differences(options.areDifferencesShown())
    {
    }

    GridCell cellAt(const QPoint &pixel, bool columnHasTie) const
    {
        GridCell cell;
        cell.pixel = pixel;
        cell.isInFrame = m_shown.contains(pixel.x(), pixel.y());
        if (!cell.isInFrame)
            return cell;
        cell.colour = *m_shown.at(pixel.x(), pixel.y());
        cell.isBackground = (cell.colour | 0xff000000U) == packed(m_traced.scene.frame.background);
        const Difference difference = m_traced.differences.at(pixel.x(), pixel.y());
        const bool isDecided = m_traced.decidedAt(pixel.x(), pixel.y()) <= m_position;
        if (m_differences && difference != Difference::None && isDecided)
            cell.signs.push_back(signOf(difference));
        if (!m_triangle)
            return cell;
        if (columnHasTie && (isDecided || !m_isAheadHidden)
            && isTie(m_traced.primitives.triangles[*m_triangle], m_traced.scene.settings.fillRule,
                     pixel))
            cell.signs.push_back(Sign::Tie);
        if (isClamped(pixel))
            cell.signs.push_back(Sign::Clamp);
        return cell;
    }

    bool hasTie(int x) const
    {
        return m_triangle && oracle::hasTie(m_traced.primitives.triangles[*m_triangle], x);
    }

private:
    bool isClamped(const QPoint &pixel) const
    {
        const std::vector<std::size_t> &clamped = m_traced.trace->clampedSamples();
        if (clamped.empty() || *m_triangle >= m_traced.trace->primitiveCount())
            return false;
        const std::optional<std::size_t> visit
            = m_traced.trace->visitOf(*m_triangle, pixel.x(), pixel.y());
        return visit && *visit < m_samplesDone && std::ranges::binary_search(clamped, *visit);
    }

    const TracedScene &m_traced;
    std::size_t m_position;
    std::size_t m_samplesDone;
    std::optional<std::size_t> m_triangle;
    bool m_isAheadHidden;
    FrameView m_shown;
    bool m_differences;
};

} // namespace

ViewMapping pixelGridMapping(const QSize &area, const QMargins &margins, const QSize &cells,
                             const QPoint &centre, FrameOrigin origin, double devicePixelRatio)
{
    const QRect inside = QRect(QPoint(), area).marginsRemoved(margins);
    const int across = int(inside.width() * devicePixelRatio);
    const int up = int(inside.height() * devicePixelRatio);
    const int cell = std::max(1, std::min(across / cells.width(), up / cells.height()));
    const int above = std::max(0, (up - cell * cells.height()) / 2);
    FrameSpec frame;
    frame.width = cells.width();
    frame.height = cells.height();
    frame.firstColumn = centre.x() - cells.width() / 2;
    frame.firstRow = centre.y() - cells.height() / 2;
    frame.origin = origin;
    const QPoint corner = (QPointF(inside.topLeft()) * devicePixelRatio).toPoint();
    return {frame, {cell, 1}, corner + QPoint(0, above), devicePixelRatio};
}

std::optional<std::size_t> currentTriangle(const Playhead &playhead)
{
    if (const std::optional<TraceStep> step = playhead.currentStep())
        return playhead.traced()->primitives.isTriangle(step->primitive)
            ? std::optional(step->primitive)
            : std::nullopt;
    if (!playhead.traced() || playhead.traced()->primitives.triangles.empty())
        return std::nullopt;
    return 0;
}

PixelGridScene pixelGridScene(const Playhead &playhead, const DisplayOptions &options,
                              const ViewMapping &mapping)
{
    const TracedScene &traced = *playhead.traced();
    const ScanTrace &trace = *traced.trace;
    PixelGridScene scene;
    scene.origin = traced.scene.frame.origin;
    scene.arithmetic = traced.scene.settings.arithmetic;
    scene.picked = playhead.pickedPixel();
    scene.currentPixel = playhead.currentPixel();
    if (const std::optional<std::size_t> span = playhead.currentSpan()) {
        scene.span = trace.span(*span);
        if (!scene.span->lower.isNone()) {
            scene.boundsOf = nameAmongCells(scene.span->place, mapping);
            scene.roundings = roundingsOf(traced, *span);
            scene.areBoundsExact = hasExactBounds(*scene.span, scene.arithmetic);
        }
        const std::size_t decided
            = trace.samplesDoneAt(playhead.position()) - trace.firstSampleOf(*span);
        scene.firstCandidate = scene.span->firstDrawn + std::int64_t(decided);
        scene.endCandidate = scene.span->endDrawn;
    }
    const std::optional<std::size_t> triangle = currentTriangle(playhead);
    if (triangle && *triangle < trace.primitiveCount()) {
        const std::array<Vertex, 3> &vertices = traced.primitives.triangles[*triangle].vertices;
        scene.triangle = {vertices[0].position, vertices[1].position, vertices[2].position};
        scene.roles = rolesOf(trace.setUp(*triangle));
    }

    const CellMaker maker(playhead, options);
    const FrameView cells = windowOf(mapping.frame());
    for (int x = int(cells.firstColumn); x < cells.endColumn(); ++x) {
        const bool columnHasTie = maker.hasTie(x);
        for (int y = int(cells.firstRow); y < cells.endRow(); ++y)
            scene.cells.push_back(maker.cellAt(QPoint(x, y), columnHasTie));
    }
    return scene;
}

} // namespace pixelplumb
