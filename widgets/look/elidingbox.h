// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace pixelplumb {

/// A combo box that ends a text too long for it in an ellipsis, where Qt's own cuts a letter.
class ElidingBox : public QComboBox {
    Q_OBJECT

public:
    using QComboBox::QComboBox;

    /// The current text as far as there is room for it.
    QString shownText() const;

protected:
    void paintEvent(QPaintEvent *event) override;
};

} // namespace pixelplumb
