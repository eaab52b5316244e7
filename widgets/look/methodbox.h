// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/labels.h"

namespace pixelplumb {

/// All methods under the headings of their families, which cannot be chosen; an entry's data is the
/// method's id. As wide as the longest title where there is room.
class MethodBox : public ElidingBox {
    Q_OBJECT

public:
    explicit MethodBox(QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return ElidingBox::sizeHint(); }

private:
    int m_titleWidth = 0; ///< the longest, px
};

} // namespace pixelplumb
