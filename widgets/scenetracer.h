// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/tracedscene.h"

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>

#include <memory>

namespace pixelplumb {

/// What tracing a scene will take, from its bounding boxes clipped to the frame.
struct TraceCost {
    std::int64_t triangles = 0;
    std::int64_t columns = 0;
    std::int64_t pixels = 0; ///< of the boxes: at least what the triangles cover

    static constexpr std::int64_t mostPixelsOfSmall = 150'000;
    static constexpr std::int64_t mostTrianglesOfSmall = 2'000;

    /// A few milliseconds: not worth a thread, and a drag then repaints within its frame.
    bool isSmall() const
    {
        return pixels <= mostPixelsOfSmall && triangles <= mostTrianglesOfSmall;
    }

    friend bool operator==(const TraceCost &, const TraceCost &) = default;
};

TraceCost traceCostOf(const Scene &scene);

struct TraceOutcome {
    std::shared_ptr<const TracedScene> traced; ///< null when cancelled or failed
    QString failure;
};

/// Traces scenes beside the GUI thread. Small ones, which take a few milliseconds, are done at
/// once; a newer request cancels an older one, whose result is dropped, and waits until no more
/// come: traces that a drag would cancel at each move only take time from its preview. Only one
/// trace is under way at a time, so that two large ones never stand in memory together.
class SceneTracer : public QObject {
    Q_OBJECT

public:
    explicit SceneTracer(QObject *parent = nullptr);
    ~SceneTracer() override; ///< cancels and waits

    /// Whether a trace is under way or waits for its turn.
    bool isRunning() const;

public slots:
    void trace(const pixelplumb::Scene &scene);
    void trace(const std::shared_ptr<const pixelplumb::Scene> &scene);
    void cancel();

signals:
    void started();
    void progressChanged(int percent);
    void traced(std::shared_ptr<const pixelplumb::TracedScene> traced);
    void cancelled();
    /// The method cannot draw the scene under its settings, or memory ran out.
    void failed(const QString &reason);

private:
    struct Progress;

    void start(const std::shared_ptr<const Scene> &scene);
    void startNext();
    void finish();
    void tellProgress();

    QFutureWatcher<TraceOutcome> m_watcher;
    std::unique_ptr<Progress>
        m_progress; ///< shared with the worker; null when nothing is under way
    std::shared_ptr<const Scene> m_next; ///< waits for the cancelled one to end, and for a rest
    QTimer m_restTimer; ///< runs while requests come one after another
    QTimer m_progressTimer;
};

} // namespace pixelplumb
