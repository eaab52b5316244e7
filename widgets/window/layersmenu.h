// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <QMenu>

namespace pixelplumb {

struct Layer;

/// The figures of the course texts that can be laid over the frame. A layer with nothing to show
/// for the current scene and method is grey and says why.
class LayersMenu : public QMenu {
    Q_OBJECT

public:
    LayersMenu(const WindowParts &parts, QWidget *window);

private:
    void addLayer(const Layer &layer, const WindowParts &parts);
};

} // namespace pixelplumb
