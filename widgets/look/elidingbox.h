// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace pixelplumb {

/// A combo box that leaves out the middle of a text too long for it, where Qt's own cuts a letter:
/// titles that begin alike are told apart.
class ElidingBox : public QComboBox {
    Q_OBJECT

public:
    using QComboBox::QComboBox;

    /// The current text, or the placeholder's where there is none; an ellipsis where there is no
    /// room for all of it, its first letters where there is hardly any. The tool tip has it whole.
    QString shownText() const;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
};

} // namespace pixelplumb
