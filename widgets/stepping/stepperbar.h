// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/stepping/stepactions.h"

#include <QtWidgets>

namespace pixelplumb {

/// A tool button whose sign may follow its text, so that it points in the button's direction:
/// "column ▶".
class StepButton : public QToolButton {
    Q_OBJECT

public:
    enum class SignSide { Alone, BeforeText, AfterText };

    /// Takes icon, icon text and keys from the action.
    StepButton(QAction *action, SignSide side, QWidget *parent = nullptr);

    QSize sizeHint() const override;

    /// Reserves room for these texts, in addition to the current one.
    void keepRoomFor(const QStringList &texts);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    SignSide m_side;
    QStringList m_texts;
};

/// The buttons that move time: to the start, back and on by column and by pixel, play, to the end;
/// the unit and speed of playing.
class StepperBar : public QWidget {
    Q_OBJECT

public:
    StepperBar(Playhead *playhead, const StepActions &actions, QWidget *parent = nullptr);

private:
    void addButtons(const StepActions &actions);
    void addUnitBox(const StepActions &actions);
    void addSpeed();

    Playhead *m_playhead;
    QBoxLayout *m_layout;
    QComboBox *m_unitBox = nullptr;
};

} // namespace pixelplumb
