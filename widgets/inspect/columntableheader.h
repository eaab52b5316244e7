// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHeaderView>

namespace pixelplumb {

class SymbolText;

/// The column table's header: symbols with subscripts, above the bar of the edge to which they
/// belong.
class ColumnTableHeader : public QHeaderView {
    Q_OBJECT

public:
    explicit ColumnTableHeader(QWidget *parent = nullptr);

    QSize sizeHint() const override;
    /// The width that a section's title needs, px.
    int titleWidth(int section) const;

protected:
    void paintSection(QPainter *painter, const QRect &rect, int section) const override;

private:
    QString title(int section) const;
};

} // namespace pixelplumb
