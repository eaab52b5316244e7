// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace pixelplumb {

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
