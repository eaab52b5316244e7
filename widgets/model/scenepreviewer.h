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

/// Draws scenes whose trace takes long in a worker thread, so that they are visible meanwhile. Of
/// the requests that arrive during a drawing only the newest is drawn next; the current drawing is
/// finished and shown, so that a long drag is seen moving.
class ScenePreviewer : public QObject {
    Q_OBJECT

public:
    explicit ScenePreviewer(QObject *parent = nullptr);

    /// The newest requested picture; null before the first.
    std::shared_ptr<const ScenePicture> picture() const { return m_picture; }
    /// True until the last scene is traced: its picture then stands for the whole run, afterwards
    /// only for what lies beyond the end of a run that was cut.
    bool isAheadOfTrace() const { return m_need == Need::TraceOnTheWay; }
    bool isRunning() const { return m_job.isRunning(); }

public slots:
    void preview(const std::shared_ptr<const pixelplumb::Scene> &scene);
    /// The last scene's trace has arrived: there is more to show only if it was cut.
    void followTrace(const std::shared_ptr<const pixelplumb::TracedScene> &traced);
    void clear();

signals:
    void pictureChanged(); ///< or its meaning

private:
    enum class Need { Nothing, TraceOnTheWay, TraceCut };

    void start(const std::shared_ptr<const Scene> &scene);
    void take(const std::shared_ptr<ScenePicture> &picture);
    std::shared_ptr<ScenePicture> spareFor(const FrameSpec &frame);

    /// A pool of its own, so that previews never wait for less urgent work.
    QThreadPool m_thread;
    Job m_job;
    std::shared_ptr<const Scene> m_next;
    std::shared_ptr<const ScenePicture> m_picture;
    /// The pictures shown, and spare ones of the same frame.
    std::vector<std::shared_ptr<ScenePicture>> m_pictures;
    Need m_need = Need::Nothing;
};

} // namespace pixelplumb
