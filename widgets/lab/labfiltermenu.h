// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labfilter.h"

#include <QToolButton>

class QMenu;

namespace pixelplumb {

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
