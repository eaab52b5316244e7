// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labplot.h"

#include <QWidget>

class QBoxLayout;
class QLabel;

namespace pixelplumb {

class ElidedLabel;
class LabCharts;
class LabControls;
class LabFiles;
class LabRun;
class Playhead;

/// What accuracy costs in time (objectName "accuracyLab"): one button judges and times every
/// contender beside the GUI thread; charts and tables fill while it goes on.
class AccuracyLab : public QWidget {
    Q_OBJECT

public:
    explicit AccuracyLab(Playhead *playhead, QWidget *parent = nullptr);
    ~AccuracyLab() override;

    bool isRunning() const;
    /// Null before the first run, and before a file was opened. While a run has no times yet, those
    /// before it.
    const SharedResults &results() const { return m_results; }
    /// What these took the place of.
    const SharedResults &earlierResults() const { return m_earlier; }
    LabFiles *files() const { return m_files; }

    /// What is asked of a study beside its extent, its scene and the hard cases.
    void setRequest(const StudySettings &request) { m_request = request; }
    /// For the command that does a study again; empty where the scene has no file.
    void setScenePath(const QString &path);
    /// A scene that is not as its file says has no command either.
    void setSceneModified(bool isModified) { m_isSceneModified = isModified; }
    /// False after a complaint.
    bool openResults(const QString &path);
    bool compareWith(const QString &path);

    QSize sizeHint() const override { return {960, 400}; }

public slots:
    void run();
    void cancel();
    /// Back to what the results in hand took the place of, and forth again.
    void showEarlier();

signals:
    void resultsChanged();
    /// A contender's first wrong pixel, and who is to be seen beside the truth there.
    void missRequested(const pixelplumb::LabMiss &miss);
    void complaint(const QString &text);
    void notice(const QString &text);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void connectControls();
    StudySettings settings() const;
    void takeNews(const SharedResults &news);
    void showRun();
    void endRun();
    void replaceBy(SharedResults results);
    void take(const SharedResults &results);
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
    QBoxLayout *m_foot = nullptr; ///< of these two
    StudySettings m_request;
    QString m_scenePath;
    bool m_isSceneModified = false;
    bool m_isRunShown = false; ///< of the last run; else results of before it are
    SharedResults m_news; ///< of it, while it is not shown
    SharedResults m_results;
    SharedResults m_earlier;
};

} // namespace pixelplumb
