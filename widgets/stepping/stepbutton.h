// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

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

} // namespace pixelplumb
