// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

namespace pixelplumb {

/// One line of plain text that ends in an ellipsis where it does not fit; the tool tip has the
/// whole.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget *parent = nullptr);

    void setWholeText(const QString &text);
    /// The part that fits.
    QString shownText() const;

    QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent *event) override;
};

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

/// A spin box of decimals with a point, like all numbers of the window. It accepts a comma as a
/// point: Qt's own box drops it, and 0,5 becomes 5.
class DecimalBox : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;

    double valueFromText(const QString &text) const override
    {
        return QDoubleSpinBox::valueFromText(QString(text).replace(u',', u'.'));
    }

protected:
    QValidator::State validate(QString &text, int &position) const override
    {
        text.replace(u',', u'.');
        return QDoubleSpinBox::validate(text, position);
    }
};

} // namespace pixelplumb
