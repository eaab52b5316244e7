// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvasaccessible.h"

#include "widgets/canvas/canvas.h"

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

} // namespace

void installCanvasAccessible()
{
    [[maybe_unused]] static const bool installed
        = (QAccessible::installFactory(makeInterface), true);
}

} // namespace pixelplumb
