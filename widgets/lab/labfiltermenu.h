// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labrun.h"

#include <QtWidgets>

#include <memory>
#include <set>

namespace pixelplumb {

/// The contenders left out of charts and table: by the names of arithmetics and kernels, by the ids
/// of methods; the straight loops by `straightLoops`.
struct LabFilter {
    static inline const QString straightLoops = u"straight"_s;
    std::set<QString> leftOut;

    /// By the contender's id.
    bool leavesOut(const QString &contender) const;
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

private:
    void fill();
    /// What the tick shows or leaves out has this name.
    void addTick(const QString &name, const QString &text, const QIcon &icon = {});
    void tell();

    QMenu *m_menu;
    LabFilter m_filter;
    QStringList m_methods; ///< ids
};

} // namespace pixelplumb
