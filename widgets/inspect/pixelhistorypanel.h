// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

namespace pixelplumb {

class PixelHistoryModel;
class Playhead;

/// How the picked pixel got its colour: every triangle's attempt, with jumps to the steps that
/// wrote it (objectName "pixelHistory").
class PixelHistoryPanel : public QWidget {
    Q_OBJECT

public:
    explicit PixelHistoryPanel(Playhead *playhead, QWidget *parent = nullptr);

    QSize sizeHint() const override;

protected:
    void showEvent(QShowEvent *event) override;

private:
    void scheduleUpdate();
    void takePixel();
    void followPosition();
    void describePixel();
    void select(const QModelIndex &attempt);
    void showReason(const QModelIndex &index);
    void fitReason();
    void fitColumns();
    void goToWrite(const QModelIndex &index);

    Playhead *m_playhead;
    PixelHistoryModel *m_model;
    QLabel *m_heading;
    QScrollArea *m_reasonArea;
    QLabel *m_reason;
    QTreeView *m_attempts;
    bool m_isStale = true;
};

} // namespace pixelplumb
