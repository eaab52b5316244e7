// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/labcomparison.h"

#include <QWidget>

class QLabel;
class QTableWidget;

namespace pixelplumb {

/// Two studies, before and after, row by row: medians, middle halves, and whether they can be told
/// apart (objectName "labChanges").
class LabChanges : public QWidget {
    Q_OBJECT

public:
    explicit LabChanges(QWidget *parent = nullptr);

    void show(const Study &before, const Study &after, const QString &beforeName);

private:
    void fill(const LabComparison &comparison, const Study &before, const Study &after);

    QLabel *m_summary;
    QTableWidget *m_table;
};

} // namespace pixelplumb
