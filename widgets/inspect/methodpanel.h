// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

namespace pixelplumb {

class Playhead;

/// What the method does, where it comes from, and its pseudocode with the current step's lines
/// marked by ▶ and a tint, and scrolled into view (objectName "methodPanel", its text
/// "methodText").
class MethodPanel : public QWidget {
    Q_OBJECT

public:
    explicit MethodPanel(Playhead *playhead, QWidget *parent = nullptr);

    QSize sizeHint() const override { return {360, 420}; }

private:
    void schedulePresentation();
    void present();
    void showCurrentLines();

    Playhead *m_playhead;
    QTextBrowser *m_text;
    bool m_isStale = true; ///< while it is hidden
};

} // namespace pixelplumb
