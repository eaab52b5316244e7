// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace pixelplumb {

/// A combo box that elides the middle of a text too long for it, where Qt's own cuts through a
/// letter, so that titles with the same beginning differ.
class ElidingBox : public QComboBox {
    Q_OBJECT

public:
    using QComboBox::QComboBox;

    /// The current text, or the placeholder where there is none; elided where it does not fit, its
    /// first letters where there is hardly any room. The tool tip has the whole.
    QString shownText() const;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
};

} // namespace pixelplumb
