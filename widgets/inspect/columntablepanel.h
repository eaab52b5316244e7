// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;

namespace pixelplumb {

class ColumnTable;
class Playhead;

/// The column table below a row of switches for its groups of columns.
class ColumnTablePanel : public QWidget {
    Q_OBJECT

public:
    explicit ColumnTablePanel(Playhead *playhead, QWidget *parent = nullptr);

    ColumnTable *table() const { return m_table; }

private:
    void describe();

    Playhead *m_playhead;
    ColumnTable *m_table;
    QLabel *m_summary;
};

} // namespace pixelplumb
