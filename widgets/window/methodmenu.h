// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/idlesetting.h"
#include "widgets/window/windowparts.h"

#include <QMenu>

namespace pixelplumb {

/// The methods, by the digits 1 … 9 on the canvas, and the settings under which they draw. What the
/// method refuses is grey and says why.
class MethodMenu : public QMenu {
    Q_OBJECT

public:
    MethodMenu(const WindowParts &parts, QWidget *window);

private:
    void addMethods(Canvas *canvas);
    /// Adds departures from the right algorithm, which can be combined.
    void addVariants();
    template <class Choices, class Member>
    QMenu *addSettings(const char *name, const QString &title, const Choices &choices,
                       Member member);
    void greyWhereIdle(QMenu *menu, DrawingSetting setting);

    SceneDocument *m_document;
};

} // namespace pixelplumb
