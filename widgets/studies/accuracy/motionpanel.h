// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/motionstudy.h"
#include "widgets/look/rowsmodel.h"
#include "widgets/studies/accuracy/motionview.h"
#include "widgets/studies/studypanel.h"

#include <QtWidgets>

namespace pixelplumb {

class SceneDocument;

/// Moving slivers: lets the document's scene move, plays it, and counts what flickers: the pixels
/// of each frame and those that come or go, compared with the truth (objectName "motion", its table
/// "motionTable"). Draws in a worker thread, and only while visible. The slider sets the document's
/// current frame, which the window traces and shows.
class MotionPanel : public StudyPanel {
    Q_OBJECT

public:
    explicit MotionPanel(SceneDocument *document, QWidget *parent = nullptr);

    /// The current scene's study; none while it is being counted, and for a still scene.
    const std::optional<MotionStudy> &study() const { return m_study; }

    QSize sizeHint() const override;

signals:
    void neededHeightChanged();

protected:
    void hideEvent(QHideEvent *event) override;

private:
    QBoxLayout *motionRow();
    QBoxLayout *playRow();
    void makeTable();
    void showAllColumns();
    void setMotion();
    void followScene();
    bool beginStudy() override;
    void take(std::optional<MotionStudy> study);
    void showFrame();
    void play(bool isPlaying);
    void tellStudy();

    SceneDocument *m_document;
    QLineEdit *m_x, *m_y;
    QSpinBox *m_frames;
    QPushButton *m_move, *m_stop;
    QSlider *m_slider;
    QToolButton *m_play;
    QLabel *m_position;
    MotionView *m_view;
    QTableView *m_table;
    RowsModel<MotionFrame> *m_rows;
    std::optional<MotionStudy> m_study;
    QString m_objection; ///< why the method cannot draw the scene that was counted last
    Job m_drawing;
    QTimer m_clock; ///< runs while the motion plays
};

} // namespace pixelplumb
