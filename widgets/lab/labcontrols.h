// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/pareto.h"

#include <QtWidgets>

namespace pixelplumb {

class LabRun;

/// The lab's row of buttons and boxes: run, extent, what is shown, files; and a line of progress,
/// which is placed elsewhere.
class LabControls : public QWidget {
    Q_OBJECT

public:
    explicit LabControls(const LabRun *run, QWidget *parent = nullptr);

    StudyExtent extent() const;
    QString family() const; ///< id; empty before there are any
    const ErrorAxis &errorAxis() const;
    /// The progress of a running study with its cancel button, a line to be placed by the caller.
    QWidget *progress() const { return m_running; }

    /// Keeps the chosen family where the new list has it.
    void setFamilies(const std::vector<StudyFamily> &families);
    /// Whether there is anything to save.
    void setHasResults(bool hasResults);
    void showRunning(); ///< or not, following the run

signals:
    void runRequested();
    void cancelRequested();
    void extentChanged();
    void choiceChanged(); ///< of the family or the error
    void openRequested();
    void saveRequested();
    void saveTableRequested();
    void saveChartRequested();
    void copyCommandRequested();

private:
    QComboBox *addBox(QBoxLayout *row, const char *name, const QString &accessibleName,
                      const QString &toolTip);
    void addFileMenu(QBoxLayout *row);
    void makeProgress();
    void tellProgress();

    const LabRun *m_run;
    QPushButton *m_start = nullptr;
    QComboBox *m_extent = nullptr;
    QComboBox *m_family = nullptr;
    QComboBox *m_error = nullptr;
    QWidget *m_running = nullptr; ///< the line of the progress
    QProgressBar *m_progress = nullptr;
    QList<QAction *> m_outputs; ///< that need results
};

} // namespace pixelplumb
