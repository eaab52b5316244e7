// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/counting/operationtable.h"
#include "widgets/look/rowsmodel.h"
#include "widgets/studies/studypanel.h"

namespace pixelplumb {

class Playhead;

/// How many divisions, roundings, additions and so on the current method and arithmetic need on the
/// playhead's scene for a set-up, a span and a sample (objectName "operations", its table
/// "operationTable"). Counts in a worker thread, and only while visible.
class OperationPanel : public StudyPanel {
    Q_OBJECT

public:
    explicit OperationPanel(Playhead *playhead, QWidget *parent = nullptr);

    /// The current scene's counts; none while they are being counted or cannot be.
    const std::optional<OperationCounts> &counts() const { return m_counts; }

    QSize sizeHint() const override { return {460, 320}; }

signals:
    void counted();

private:
    void forget();
    bool beginStudy() override;
    void take(std::optional<OperationCounts> counts);
    void fillTable();

    Playhead *m_playhead;
    RowsModel<OperationTableRow> *m_rows;
    std::optional<OperationCounts> m_counts;
};

} // namespace pixelplumb
