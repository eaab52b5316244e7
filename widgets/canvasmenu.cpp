// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvasmenu.h"

namespace pixelplumb {

CanvasMenu::CanvasMenu(SceneDocument *document, const VertexRef &ref, QWidget *parent)
    : QMenu(parent)
{
    setObjectName(QStringLiteral("canvasMenu"));
    addAction(tr("Vertex &colour…"), this, [this, ref] { emit colourRequested(ref); });
    addAction(tr("&Coordinates…"), this, [this, ref] { emit coordinatesRequested(ref); });
    addSeparator();
    addAction(ref.triangle == VertexRef::pending ? tr("&Delete vertex") : tr("&Delete triangle"),
              this, [document, ref] { document->deleteVertex(ref); });
}

} // namespace pixelplumb
