// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/scenedocument.h"

#include <QMenu>

namespace pixelplumb {

/// The menu of a vertex.
class CanvasMenu : public QMenu {
    Q_OBJECT

public:
    CanvasMenu(SceneDocument *document, const VertexRef &ref, QWidget *parent = nullptr);

signals:
    void colourRequested(const pixelplumb::VertexRef &ref);
    void coordinatesRequested(const pixelplumb::VertexRef &ref);

private:
    void askForText(SceneDocument *document, const VertexRef &ref);
};

} // namespace pixelplumb
