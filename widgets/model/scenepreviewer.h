// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/scenepicture.h"
#include "widgets/model/job.h"

#include <QObject>
#include <QThreadPool>

#include <memory>
#include <vector>

namespace pixelplumb {

struct TracedScene;

/// Draws scenes whose trace takes long, so that they can be seen meanwhile, beside the GUI thread.
/// Of requests that come while a drawing is under way only the newest is drawn next; the one under
/// way is finished and shown, so that a long drag is seen moving.
class ScenePreviewer : public QObject {
    Q_OBJECT

public:
    explicit ScenePreviewer(QObject *parent = nullptr);

    /// The newest picture that is wanted; null before the first.
    std::shared_ptr<const ScenePicture> picture() const { return m_picture; }
    /// True while the trace of the last scene is not there: its picture then stands for the whole
    /// run, else only for what lies beyond the end of a run that was cut.
    bool isAheadOfTrace() const { return m_need == Need::TraceOnTheWay; }
    bool isRunning() const { return m_job.isRunning(); }

public slots:
    void preview(const std::shared_ptr<const pixelplumb::Scene> &scene);
    /// The trace of the last scene is there: only a cut one leaves something to show.
    void followTrace(const std::shared_ptr<const pixelplumb::TracedScene> &traced);
    void clear();

signals:
    void pictureChanged(); ///< or what it stands for

private:
    enum class Need { Nothing, TraceOnTheWay, TraceCut };

    void start(const std::shared_ptr<const Scene> &scene);
    void take(const std::shared_ptr<ScenePicture> &picture);
    std::shared_ptr<ScenePicture> spareFor(const FrameSpec &frame);

    /// Of its own, so that it never waits behind work that is less urgent.
    QThreadPool m_thread;
    Job m_job;
    std::shared_ptr<const Scene> m_next;
    std::shared_ptr<const ScenePicture> m_picture;
    /// Those that are shown, and spare ones of the same frame.
    std::vector<std::shared_ptr<ScenePicture>> m_pictures;
    Need m_need = Need::Nothing;
};

} // namespace pixelplumb
