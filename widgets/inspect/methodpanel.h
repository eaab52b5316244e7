// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QTextBrowser;

namespace pixelplumb {

class Playhead;

/// This method: what it does, where it comes from, and its pseudocode with the lines that the step
/// in hand does marked by ▶ and a tint, and in view (objectName "methodPanel", its text
/// "methodText").
class MethodPanel : public QWidget {
    Q_OBJECT

public:
    explicit MethodPanel(Playhead *playhead, QWidget *parent = nullptr);

    QSize sizeHint() const override { return {360, 420}; }

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void schedulePresentation();
    void present();
    void showLinesInHand();

    Playhead *m_playhead;
    QTextBrowser *m_text;
    bool m_isStale = true; ///< while it is not seen
};

} // namespace pixelplumb
