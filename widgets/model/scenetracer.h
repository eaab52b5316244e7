// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/scenepicture.h"
#include "core/runs/tracedscene.h"
#include "widgets/model/job.h"

#include <QtCore>

#include <memory>
#include <vector>

namespace pixelplumb {

struct TracedScene;

/// An estimate of the work to trace a scene, from its bounding boxes clipped to the frame.
struct TraceCost {
    std::int64_t triangles = 0;
    std::int64_t columns = 0;
    std::int64_t pixels = 0; ///< of the boxes: at least as many as are covered
    std::int64_t corners = 0; ///< of the shapes' outlines; approximate for letters

    static constexpr std::int64_t mostPixelsOfSmall = 150'000;
    static constexpr std::int64_t mostTrianglesOfSmall = 2'000;
    /// A row may meet every edge of a polygon.
    static constexpr std::int64_t mostCornersOfSmall = 3'000;

    /// Whether tracing takes a few milliseconds at most: not worth a thread, and a drag repaints in
    /// time.
    bool isSmall() const
    {
        return pixels <= mostPixelsOfSmall && triangles <= mostTrianglesOfSmall
            && corners <= mostCornersOfSmall;
    }

    friend bool operator==(const TraceCost &, const TraceCost &) = default;
};

/// Of primitives on samples.
TraceCost traceCostOf(const Primitives &primitives, const FrameSpec &frame);

/// Traces scenes in a worker thread; small ones, which take a few milliseconds, at once. A newer
/// request cancels an older one, whose result is dropped, and waits until no more arrive: traces
/// that a drag would cancel at each move only slow down its preview. Only one trace runs at a time,
/// so that two large ones are never in memory together.
class SceneTracer : public QObject {
    Q_OBJECT

public:
    explicit SceneTracer(QObject *parent = nullptr);

    /// Whether a trace is running or waiting.
    bool isRunning() const { return m_job.isRunning(); }
    /// The job of the large traces. It knows the approximate number of spans.
    const Job &job() const { return m_job; }

public slots:
    void trace(const pixelplumb::Scene &scene);
    void trace(const std::shared_ptr<const pixelplumb::Scene> &scene);
    void cancel();

signals:
    void traced(std::shared_ptr<const pixelplumb::TracedScene> traced);
    void cancelled();
    /// The method cannot draw the scene under its settings, or memory ran out.
    void failed(const QString &reason);

private:
    /// Null where memory ran out.
    void take(const Scene &scene, const std::shared_ptr<const TracedScene> &outcome);

    Job m_job;
};

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
