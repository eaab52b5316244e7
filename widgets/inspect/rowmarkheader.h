// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHeaderView>

namespace pixelplumb {

/// The column table's left margin: where a triangle or its second half begins, and the current row.
class RowMarkHeader : public QHeaderView {
    Q_OBJECT

public:
    explicit RowMarkHeader(QWidget *parent = nullptr);

    QSize sizeHint() const override;

protected:
    void paintSection(QPainter *painter, const QRect &rect, int section) const override;
};

} // namespace pixelplumb
