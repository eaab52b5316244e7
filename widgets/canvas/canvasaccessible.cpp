// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvasaccessible.h"

#include "widgets/canvas/canvas.h"
#include "widgets/canvas/imagehandles.h"
#include "widgets/look/corewords.h"
#include "widgets/model/frametext.h"
#include "widgets/model/playhead.h"

#include <QAccessibleWidget>

namespace pixelplumb {

namespace {

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

/// The place of the vertex, corner or pixel that the keys move.
QString spokenPlace(const CanvasSources &sources, const CanvasHand &hand)
{
    const SceneDocument &document = *sources.document;
    if (const std::optional<VertexRef> ref = document.selectedVertex()) {
        const QString place
            = coordinateNote(document.atCurrentFrame(document.vertexAt(*ref)->position));
        if (ref->primitive == VertexRef::pending)
            return Canvas::tr("waiting vertex %1 at %2").arg(QString::number(ref->vertex), place);
        return Canvas::tr("vertex %1 of %2 %3 at %4")
            .arg(QString::number(ref->vertex), coreWord(nameOf(document.kindOf(ref->primitive))),
                 QString::number(ref->primitive), place);
    }
    if (const auto image = hand.chosenCorner ? imageInView(sources) : std::nullopt)
        return Canvas::tr("image of vertex %1 at %2")
            .arg(QString::number(*hand.chosenCorner),
                 coordinateNote(image->corners[*hand.chosenCorner]));
    if (const std::optional<QPoint> pixel = sources.playhead->pickedPixel())
        return Canvas::tr("pixel (%1, %2)").arg(pixel->x()).arg(pixel->y());
    return Canvas::tr("no pixel is picked");
}

} // namespace

QString spokenState(const CanvasSources &sources, const CanvasHand &hand)
{
    const QString frame = frameText(*sources.document);
    const QString place = spokenPlace(sources, hand);
    return frame.isEmpty() ? place : place + QStringLiteral(", ") + frame;
}

void installCanvasAccessible()
{
    [[maybe_unused]] static const bool installed
        = (QAccessible::installFactory(makeInterface), true);
}

} // namespace pixelplumb
