// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/stepping/stepactions.h"

#include <QWidget>

class QBoxLayout;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace pixelplumb {

/// The buttons that move time: to the start, back and on by column and by pixel, play, to the end;
/// the unit and speed of playing; the playhead's position.
class StepperBar : public QWidget {
    Q_OBJECT

public:
    StepperBar(Playhead *playhead, const StepActions &actions, QWidget *parent = nullptr);

private:
    void addButtons(const StepActions &actions);
    void addUnitBox(const StepActions &actions);
    void addSpeed();
    void addPositionLabel();
    void updateSpeed();
    void updatePosition();

    Playhead *m_playhead;
    QBoxLayout *m_layout;
    QComboBox *m_unitBox = nullptr;
    QSlider *m_speedSlider = nullptr;
    QDoubleSpinBox *m_speedBox = nullptr;
    QLabel *m_position = nullptr;
};

} // namespace pixelplumb
