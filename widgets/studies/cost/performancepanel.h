// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measure/scenetiming.h"
#include "widgets/model/job.h"

#include <QtWidgets>

namespace pixelplumb {

class Playhead;

/// The measurement as HTML tables: numbers right-aligned, with few digits.
QString timesHtml(const SceneTiming &timing);
/// Which kernel took how many of the triangles, and why.
QString routesHtml(const FastReport &report, const QPalette &palette);
/// What was measured, in a sentence or two.
QString measurementText(const SceneTiming &timing);

/// What drawing the playhead's scene costs with the plain and with the fast kernels, and which fast
/// kernel took which triangles and why (objectName "performance"). Measures in a worker thread, on
/// request.
class PerformancePanel : public QWidget {
    Q_OBJECT

public:
    explicit PerformancePanel(Playhead *playhead, QWidget *parent = nullptr);

    bool isRunning() const { return m_job.isRunning(); }
    /// None before the first measurement, after a cancelled one, and after a change of the scene.
    const std::optional<SceneTiming> &timing() const { return m_timing; }

    QSize sizeHint() const override { return {460, 560}; }

public slots:
    void measure();
    void cancel();

signals:
    void measured();

private:
    QBoxLayout *controls();
    QWidget *contents();
    void forget();
    void take(std::optional<SceneTiming> timing);
    void tell(const QString &text);
    void present();

    Playhead *m_playhead;
    QPushButton *m_measure = nullptr;
    QLabel *m_summary = nullptr;
    QLabel *m_times = nullptr;
    QLabel *m_routes = nullptr;
    std::optional<SceneTiming> m_timing;
    Job m_job;
};

} // namespace pixelplumb
