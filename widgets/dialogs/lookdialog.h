// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/dialogs/scenelook.h"

#include <QtWidgets>

namespace pixelplumb {

/// Camera, lights and materials of a scene: a form over the keys of its file.
class LookDialog : public QDialog {
    Q_OBJECT

public:
    LookDialog(const Scene &scene, const QString &folder, QWidget *parent = nullptr);

    /// Once the dialog is accepted: what was chosen.
    const ChosenLook &look() const { return m_chosen; }

private:
    void addButtons(QBoxLayout *row);
    void show(const QModelIndex &part);
    void judge();

    SceneLook *m_look;
    ChosenLook m_chosen;
    QTreeView *m_tree;
    QPushButton *m_removal = nullptr;
    QLabel *m_verdict;
    QDialogButtonBox *m_buttons;
};

} // namespace pixelplumb
