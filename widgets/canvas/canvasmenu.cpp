// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvasmenu.h"

#include "widgets/look/corewords.h"

#include <QInputDialog>

namespace pixelplumb {

CanvasMenu::CanvasMenu(SceneDocument *document, const VertexRef &ref, QWidget *parent)
    : QMenu(parent)
{
    setObjectName(QStringLiteral("canvasMenu"));
    addAction(tr("Vertex &colour…"), this, [this, ref] { emit colourRequested(ref); });
    addAction(tr("&Coordinates…"), this, [this, ref] { emit coordinatesRequested(ref); });
    addSeparator();
    const bool isPending = ref.primitive == VertexRef::pending;
    if (!isPending && document->kindOf(ref.primitive) == PrimitiveKind::Text)
        addAction(tr("&Text…"), this, [this, document, ref] { askForText(document, ref); });
    if (!isPending)
        addAction(tr("&Hide %1").arg(coreWord(nameOf(document->kindOf(ref.primitive)))), this,
                  [document, ref] { document->hidePrimitive(ref.primitive); });
    addAction(isPending ? tr("&Delete vertex")
                        : tr("&Delete %1").arg(coreWord(nameOf(document->kindOf(ref.primitive)))),
              this, [document, ref] { document->deleteVertex(ref); });
}

void CanvasMenu::askForText(SceneDocument *document, const VertexRef &ref)
{
    const auto index = std::size_t(ref.primitive) - document->scene().triangles.size();
    bool isAccepted = false;
    const QString text = QInputDialog::getText(
        parentWidget(), tr("Text"), tr("The characters that are drawn:"), QLineEdit::Normal,
        QString::fromStdString(document->scene().shapes[index].text), &isAccepted);
    if (isAccepted)
        document->setText(ref.primitive, text);
}

} // namespace pixelplumb
