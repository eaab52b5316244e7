// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/pointerreadout.h"

#include "core/oracle/oracle.h"
#include "core/runs/explain/edgename.h"
#include "core/scene/text/colourtext.h"
#include "widgets/canvas/canvas.h"
#include "widgets/canvas/canvasoutlines.h"
#include "widgets/canvas/canvasscene.h"
#include "widgets/canvas/imagehandles.h"
#include "widgets/look/corewords.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenetracer.h"
#include "widgets/model/steptext.h"

#include <QtWidgets>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

/// With more triangles than this, the one beside a pixel is not searched for: the pointer must not
/// wait.
constexpr std::size_t mostJudged = 256;

struct NearestEdge {
    std::size_t triangle = 0;
    oracle::EdgeVerdict edge;

    bool isOnEdge() const { return edge.edgeFunction == 0; }
};

/// "0.25 px"; a pixel that is not on the edge never reads "0.00 px".
QString distanceText(double pixels)
{
    constexpr double leastShown = 0.005;
    return std::abs(pixels) < leastShown
        ? PointerReadout::tr("less than 0.01 px")
        : PointerReadout::tr("%1 px").arg(QString::number(std::abs(pixels), 'f', 2));
}

/// The primitive that last wrote the pixel in the steps done so far.
std::optional<std::size_t> painterOf(const QPoint &pixel, const Playhead &playhead)
{
    const ScanTrace &trace = *playhead.traced()->trace;
    const std::optional<std::size_t> written
        = TraceNavigation(trace).writeOf(pixel, playhead.position() + 1, StepDirection::Backward);
    return written ? std::optional(trace.stepAt(*written - 1).primitive) : std::nullopt;
}

/// The triangle's edge nearest to the pixel; none for a triangle without area.
std::optional<NearestEdge> edgeNearest(const QPoint &pixel, const TracedScene &traced,
                                       std::size_t triangle)
{
    const oracle::SampleVerdict verdict = oracle::judge(
        traced.primitives.triangles[triangle], boundaryRuleOf(traced.scene), pixel.x(), pixel.y());
    if (verdict.zeroArea)
        return std::nullopt;
    // Distances are positive inside: outside, the minimum is the edge that most excludes the pixel.
    // Of two edges through a sample, it is the one that rejects it.
    return NearestEdge{
        triangle, *std::ranges::min_element(verdict.edges, {}, [](const oracle::EdgeVerdict &edge) {
            return std::pair(edge.accepts, edge.distance);
        })};
}

QString nameOfEdge(const NearestEdge &nearest, const ScanTrace &trace)
{
    const SetUpRecord setUp
        = nearest.triangle < trace.primitiveCount() ? trace.setUp(nearest.triangle) : SetUpRecord();
    return edgeName(setUp, nearest.edge.from, nearest.edge.to);
}

QString paintedText(const QPoint &pixel, const TracedScene &traced, std::size_t primitive)
{
    const QString name = u"%1 %2"_s.arg(coreWord(nameOf(traced.primitives.kindOf(primitive))),
                                        QString::number(primitive));
    if (!traced.primitives.isTriangle(primitive))
        return name;
    const std::optional<NearestEdge> nearest = edgeNearest(pixel, traced, primitive);
    if (!nearest)
        return name;
    if (nearest->isOnEdge())
        return PointerReadout::tr("%1 · on %2").arg(name, nameOfEdge(*nearest, *traced.trace));
    return PointerReadout::tr("%1 · %2 from %3")
        .arg(name, distanceText(nearest->edge.distance), nameOfEdge(*nearest, *traced.trace));
}

/// Whether a step that is still to come paints the pixel.
bool isPaintedLater(const QPoint &pixel, const Playhead &playhead)
{
    return TraceNavigation(*playhead.traced()->trace)
        .writeOf(pixel, playhead.position(), StepDirection::Forward)
        .has_value();
}

QString unpaintedText(const QPoint &pixel, const Playhead &playhead)
{
    const TracedScene &traced = *playhead.traced();
    std::optional<NearestEdge> nearest;
    const std::size_t count = traced.primitives.triangles.size();
    for (std::size_t i = 0; i < count && count <= mostJudged; ++i) {
        const std::optional<NearestEdge> edge = edgeNearest(pixel, traced, i);
        if (edge && (!nearest || edge->edge.distance > nearest->edge.distance))
            nearest = edge;
    }
    const QString painted = isPaintedLater(pixel, playhead) ? PointerReadout::tr("not painted yet")
                                                            : PointerReadout::tr("not painted");
    if (!nearest || !traced.method->draws(PrimitiveKind::Triangle))
        return painted;
    const QString edge = nameOfEdge(*nearest, *traced.trace);
    const QString triangle = u"%1 %2"_s.arg(coreWord(nameOf(PrimitiveKind::Triangle)),
                                            QString::number(nearest->triangle));
    const QString between = u" · "_s;
    if (nearest->isOnEdge())
        return painted + between + PointerReadout::tr("on %1 of %2").arg(edge, triangle);
    const QString side = nearest->edge.distance >= 0 ? PointerReadout::tr("%1 inside %2 of %3")
                                                     : PointerReadout::tr("%1 outside %2 of %3");
    return painted + between + side.arg(distanceText(nearest->edge.distance), edge, triangle);
}

/// "student: #000000, missing", or, where that is the pixel shown, "missing; expected: #a06f30";
/// empty where the student's pixel is the same.
QString studentText(const QPoint &pixel, const CanvasSources &sources, const CanvasHand &hand)
{
    const auto judgement = markedJudgement(sources);
    const auto place = judgement ? judgement->placeOf(pixel) : std::nullopt;
    if (!place || judgement->diff.verdicts[*place] == Difference::None)
        return {};
    const QString verdict = coreWord(nameOf(judgement->diff.verdicts[*place]));
    if (judgedFrame(sources, hand) && !hand.isPeeking)
        return PointerReadout::tr("%1; expected: %2")
            .arg(verdict, colourText(judgement->expected.colours[*place]));
    return PointerReadout::tr("student: %1")
        .arg(judgement->found.hasColours
                 ? colourText(judgement->found.colours[*place]) + u", "_s + verdict
                 : verdict);
}

class CanvasAccessible final : public QAccessibleWidget {
public:
    explicit CanvasAccessible(Canvas *canvas)
        : QAccessibleWidget(canvas, QAccessible::Canvas)
    {
    }

    QString text(QAccessible::Text kind) const override
    {
        if (kind != QAccessible::Value)
            return QAccessibleWidget::text(kind);
        return static_cast<Canvas *>(object())->spokenState();
    }
};

QAccessibleInterface *makeInterface(const QString &, QObject *object)
{
    auto *canvas = qobject_cast<Canvas *>(object);
    return canvas ? new CanvasAccessible(canvas) : nullptr;
}

/// "vertex 1 of triangle 0 at (58, 12)"
QString vertexText(const VertexRef &ref, const SceneDocument &document)
{
    const QString place = coordinateNote(document.atCurrentFrame(document.vertexAt(ref)->position));
    if (ref.primitive == VertexRef::pending)
        return Canvas::tr("waiting vertex %1 at %2").arg(QString::number(ref.vertex), place);
    return Canvas::tr("vertex %1 of %2 %3 at %4")
        .arg(QString::number(ref.vertex), coreWord(nameOf(document.kindOf(ref.primitive))),
             QString::number(ref.primitive), place);
}

/// The place of the vertex, corner or pixel that the keys move.
QString spokenPlace(const CanvasSources &sources, const CanvasHand &hand)
{
    const SceneDocument &document = *sources.document;
    if (const std::optional<VertexRef> ref = document.selectedVertex())
        return vertexText(*ref, document);
    if (const auto image = hand.chosenCorner ? imageInView(sources) : std::nullopt)
        return Canvas::tr("image of vertex %1 at %2")
            .arg(QString::number(*hand.chosenCorner),
                 coordinateNote(image->corners[*hand.chosenCorner]));
    if (const std::optional<QPoint> pixel = sources.playhead->pickedPixel())
        return Canvas::tr("pixel (%1, %2)").arg(pixel->x()).arg(pixel->y());
    return Canvas::tr("no pixel is picked");
}

} // namespace

QString PointerReadout::text(const QPoint &pixel, const CanvasSources &sources,
                             const CanvasHand &hand)
{
    const Playhead &playhead = *sources.playhead;
    const TracedScene *traced = tracedOfFrame(*sources.document, playhead);
    // Pictures in place of a run, or beyond the end of its recording, do not tell what painted the
    // pixel.
    const bool isPreview = sources.previewer && sources.previewer->isAheadOfTrace();
    const bool isBeyond = traced && traced->trace->isCut() && playhead.position() == playhead.end();

    const QString place = u"(%1, %2)"_s.arg(pixel.x()).arg(pixel.y());
    QStringList lines;
    if (hand.hovered)
        lines += vertexText(*hand.hovered, *sources.document);
    else if (hand.candidate && coordinateNote(*hand.candidate) != place)
        lines += PointerReadout::tr("vertex %1").arg(coordinateNote(*hand.candidate));
    if (!traced || isPreview || isBeyond)
        return (lines << place).join(u'\n');
    const bool isTruth = isTruthVisible(sources, hand);
    const FrameBuffer *judged = judgedFrame(sources, hand);
    const FrameBuffer &shown = judged ? *judged : isTruth ? traced->truth : *playhead.frame();
    lines += place + u' ' + colourText(unpacked(*shown.view().at(pixel.x(), pixel.y())));
    if (const QString text = studentText(pixel, sources, hand); !text.isEmpty())
        lines += text;
    if (!isTruth && !judged && !playhead.isAheadHidden()) // the side of an edge is asked for there
        lines += owner(pixel, playhead);
    return lines.join(u'\n');
}

QString PointerReadout::owner(const QPoint &pixel, const Playhead &playhead)
{
    const TracedScene *traced = playhead.traced();
    if (m_traced.lock().get() == traced && m_pixel == pixel && m_position == playhead.position())
        return m_text;
    m_traced = playhead.sharedTraced();
    m_pixel = pixel;
    m_position = playhead.position();
    const std::optional<std::size_t> painter = painterOf(pixel, playhead);
    m_text = painter ? paintedText(pixel, *traced, *painter) : unpaintedText(pixel, playhead);
    return m_text;
}

QString spokenState(const CanvasSources &sources, const CanvasHand &hand)
{
    const QString frame = frameText(*sources.document);
    const QString place = spokenPlace(sources, hand);
    return frame.isEmpty() ? place : place + u", "_s + frame;
}

void installCanvasAccessible()
{
    [[maybe_unused]] static const bool installed
        = (QAccessible::installFactory(makeInterface), true);
}

} // namespace pixelplumb
