// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labrun.h"
#include "widgets/look/rowsmodel.h"

#include <memory>

class QSortFilterProxyModel;

namespace pixelplumb {

/// What a pixel of a family costs, ns, split into the set-up of its triangle, its column or row,
/// and itself. The parts come from the fit over all families, so that the sum is near the measured
/// time, not equal.
struct CostParts {
    double setUp = 0;
    double columns = 0;
    double pixels = 0;

    friend bool operator==(const CostParts &, const CostParts &) = default;
};

/// None where the contender or the family was not timed.
std::optional<CostParts> costPartsOf(const Study &study, const LabRow &row);

/// A contender of a study on one family.
struct LabTableRow {
    std::shared_ptr<const Study> study;
    const LabRow *row = nullptr; ///< of the study
};

/// The contenders of a study on one family, a row each, sorted by any column (objectName
/// "labTable"). What was not measured is empty and sorts last.
class LabTable : public QTableView {
    Q_OBJECT

public:
    explicit LabTable(QWidget *parent = nullptr);

    void show(const std::shared_ptr<const Study> &results, const QString &family);
    void select(const QString &contender);
    QString selected() const; ///< id; empty where none is

signals:
    void contenderSelected(const QString &contender);
    void contenderActivated(const QString &contender); ///< a double click, or Enter

protected:
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;

private:
    /// id; empty where the index is none of a row
    QString contenderAt(const QModelIndex &index) const;

    RowsModel<LabTableRow> *m_model;
    QSortFilterProxyModel *m_sorted;
    bool m_isFilling = false;
};

} // namespace pixelplumb
