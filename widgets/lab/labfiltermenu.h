// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labrun.h"

#include <QToolButton>

#include <memory>
#include <set>

class QMenu;

namespace pixelplumb {

/// The contenders left out of charts and table.
struct LabFilter {
    std::set<Arithmetic> arithmetics;
    std::set<LabKernel> kernels;
    std::set<QString> methods; ///< ids
    enum class StraightLoops { Shown, LeftOut } straightLoops = StraightLoops::Shown;

    bool leavesNobodyOut() const { return *this == LabFilter(); }
    /// By the contender's id.
    bool leavesOut(const QString &contender) const;

    friend bool operator==(const LabFilter &, const LabFilter &) = default;
};

/// The results without the contenders left out.
std::shared_ptr<const Study> filtered(const std::shared_ptr<const Study> &results,
                                      const LabFilter &filter);

/// Chooses the contenders shown (objectName "labShown"): arithmetics with their dots, kernels,
/// methods and straight loops, a tick each.
class LabFilterMenu : public QToolButton {
    Q_OBJECT

public:
    explicit LabFilterMenu(QWidget *parent = nullptr);

    const LabFilter &filter() const { return m_filter; }
    /// Offers these contenders' methods.
    void setContenders(const std::vector<StudyContender> &contenders);

signals:
    void filterChanged();

protected:
    void changeEvent(QEvent *event) override;

private:
    void fill();
    void addTick(const QString &name, const QString &text, const QIcon &icon, bool isShown,
                 const std::function<void(bool isShown)> &show);
    void tell();

    QMenu *m_menu;
    LabFilter m_filter;
    QStringList m_methods; ///< ids
};

} // namespace pixelplumb
