// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/idlesetting.h"
#include "widgets/window/windowparts.h"

#include <QMenu>

namespace pixelplumb {

/// The methods, by the digits 1 … 9 on the canvas, and departures from the right algorithm. What
/// the method refuses is grey and says why.
class MethodMenu : public QMenu {
    Q_OBJECT

public:
    MethodMenu(const WindowParts &parts, QWidget *window);

private:
    void addMethods(Canvas *canvas);
    void addVariants(); ///< can be combined

    SceneDocument *m_document;
};

} // namespace pixelplumb
