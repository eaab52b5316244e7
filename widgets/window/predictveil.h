// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace pixelplumb {

class Playhead;

/// Covers a panel that shows the finished picture while Predict asks what lies ahead: the panel can
/// be neither seen nor reached by keys.
class PredictVeil : public QLabel {
    Q_OBJECT

public:
    PredictVeil(const Playhead *playhead, QWidget *panel);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void follow();

    const Playhead *m_playhead;
    QWidget *m_panel;
};

} // namespace pixelplumb
