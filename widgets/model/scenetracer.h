// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"
#include "widgets/model/job.h"

#include <QObject>

#include <memory>

namespace pixelplumb {

/// What tracing a scene will take, from its bounding boxes clipped to the frame.
struct TraceCost {
    std::int64_t triangles = 0;
    std::int64_t columns = 0;
    std::int64_t pixels = 0; ///< of the boxes: at least what the triangles cover
    std::int64_t corners = 0; ///< of the shapes' outlines, of letters about

    static constexpr std::int64_t mostPixelsOfSmall = 150'000;
    static constexpr std::int64_t mostTrianglesOfSmall = 2'000;
    /// A row may meet every edge of a polygon.
    static constexpr std::int64_t mostCornersOfSmall = 3'000;

    /// A few milliseconds: not worth a thread, and a drag then repaints within its frame.
    bool isSmall() const
    {
        return pixels <= mostPixelsOfSmall && triangles <= mostTrianglesOfSmall
            && corners <= mostCornersOfSmall;
    }

    friend bool operator==(const TraceCost &, const TraceCost &) = default;
};

TraceCost traceCostOf(const Scene &scene);

/// Traces scenes beside the GUI thread. Small ones, which take a few milliseconds, are done at
/// once; a newer request cancels an older one, whose result is dropped, and waits until no more
/// come: traces that a drag would cancel at each move only take time from its preview. Only one
/// trace is under way at a time, so that two large ones never stand in memory together.
class SceneTracer : public QObject {
    Q_OBJECT

public:
    explicit SceneTracer(QObject *parent = nullptr);

    /// Whether a trace is under way or waits for its turn.
    bool isRunning() const { return m_job.isRunning(); }
    /// Of the large ones. It knows about how many spans there will be.
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

} // namespace pixelplumb
