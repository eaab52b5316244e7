// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

namespace pixelplumb {

class ColumnTable;
class ElidedLabel;
class Playhead;

/// The column table below a row of switches for its groups of columns and a row filter.
class ColumnTablePanel : public QWidget {
    Q_OBJECT

public:
    explicit ColumnTablePanel(Playhead *playhead, QWidget *parent = nullptr);

    ColumnTable *table() const { return m_table; }

private:
    void addFilter(QHBoxLayout *row);
    void describe();

    Playhead *m_playhead;
    ColumnTable *m_table;
    ElidedLabel *m_summary;
    QWidget *m_filter = nullptr;
};

} // namespace pixelplumb
