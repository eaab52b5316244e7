// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

namespace pixelplumb {

/// A tool button whose sign may follow its text, so that it points where the button goes: "column
/// ▶".
class StepButton : public QToolButton {
    Q_OBJECT

public:
    enum class SignSide { Alone, BeforeText, AfterText };

    /// Takes its icon, its icon text and its keys from the action.
    StepButton(QAction *action, SignSide side, QWidget *parent = nullptr);

    QSize sizeHint() const override;

    /// Texts for which there has to be room, beside the one of the moment.
    void keepRoomFor(const QStringList &texts);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    SignSide m_side;
    QStringList m_texts;
};

} // namespace pixelplumb
