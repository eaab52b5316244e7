// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labrun.h"

#include <QtWidgets>

namespace pixelplumb {

class ElidedLabel;
class LabCharts;
class LabControls;
class LabFiles;
class LabRun;
class Playhead;

/// What accuracy costs in time (objectName "accuracyLab"). One button judges and times every
/// contender in a worker thread; charts and tables fill meanwhile.
class AccuracyLab : public QWidget {
    Q_OBJECT

public:
    explicit AccuracyLab(Playhead *playhead, QWidget *parent = nullptr);

    bool isRunning() const;
    /// Null before the first run or opened file. While a run has no times yet, the previous
    /// results.
    const SharedResults &results() const { return m_shown.results(); }
    LabFiles *files() const { return m_files; }

    /// Study settings other than its extent, its scene and the hard cases.
    void setRequest(const StudySettings &request) { m_request = request; }
    /// The path for the command that repeats a study; empty where the scene has no file.
    void setScenePath(const QString &path);
    /// A scene that differs from its file has no command either.
    void setSceneModified(bool isModified) { m_isSceneModified = isModified; }
    /// False after a complaint.
    bool openResults(const QString &path);

    QSize sizeHint() const override;

public slots:
    void run();
    void cancel();

signals:
    /// Without results there are no charts, which need the most room.
    void neededHeightChanged();
    void resultsChanged();
    /// A contender's first wrong pixel, and the contender to compare with the truth there.
    void missRequested(const pixelplumb::LabMiss &miss);
    void complaint(const QString &text);
    void notice(const QString &text);

private:
    void connectControls();
    StudySettings settings() const;
    void takeNews(const SharedResults &news);
    void endRun();
    void showResults();
    void showChoice();
    void showState();
    void openMiss(const QString &contender);
    void saveChart();

    Playhead *m_playhead;
    LabRun *m_run;
    LabFiles *m_files;
    LabControls *m_controls;
    LabCharts *m_charts;
    QLabel *m_invitation;
    ElidedLabel *m_warnings;
    ElidedLabel *m_conditions;
    QStackedWidget *m_lastLine; ///< conditions, or progress while a study runs
    QBoxLayout *m_foot = nullptr; ///< with the warnings and the last line
    StudySettings m_request;
    QString m_scenePath;
    bool m_isSceneModified = false;
    ShownResults m_shown;
};

} // namespace pixelplumb
