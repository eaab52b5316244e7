// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/ahead.h"
#include "core/runs/tracedscene.h"
#include "widgets/model/tracenavigation.h"

#include <QtCore>

#include <memory>
#include <optional>
#include <set>

namespace pixelplumb {

/// The person's current place: the traced scene, the position in it, the unit of stepping, the
/// picked pixel and the breakpoints. Every view listens to this object and asks it to move; the
/// views do not know each other.
///
/// At position p the first p steps are done; the current step is step p − 1. Moving to a span or
/// sample step picks its pixel; picking a pixel by hand does not move time.
class Playhead : public QObject {
    Q_OBJECT

public:
    static constexpr double slowest = 0.5; ///< steps per second
    static constexpr double fastest = 10000;

    explicit Playhead(QObject *parent = nullptr);
    ~Playhead() override;

    /// Takes a new run. The position stays on the same column and pixel where the new trace has
    /// them, else moves to the nearest earlier step of the same primitive. A run with an added
    /// primitive is shown finished, or, while a student predicts, at that primitive's set-up.
    void setTraced(std::shared_ptr<const TracedScene> traced);
    /// Null until the first run is there.
    const TracedScene *traced() const { return m_traced.get(); }
    std::shared_ptr<const TracedScene> sharedTraced() const { return m_traced; }

    std::size_t position() const;
    std::size_t end() const; ///< the largest position
    /// The frame at the position; null without a run.
    const FrameBuffer *frame() const;
    std::optional<TraceStep> currentStep() const;
    /// The trace's index of the current step's span; none at a set-up step.
    std::optional<std::size_t> currentSpan() const;
    /// The place of the current span.
    std::optional<SpanPlace> currentPlace() const;
    /// The x of the current span, where it is a column.
    std::optional<std::int64_t> currentColumnX() const;
    /// The axis of the current span, else of the run's first one; Column without a run.
    SpanAxis axis() const;
    /// The pixel (x, y) that the current step wrote or refused, if any.
    std::optional<QPoint> currentPixel() const;

    StepUnit unit() const { return m_unit; }
    bool isPlaying() const { return m_timer.isActive(); }
    double stepsPerSecond() const { return m_stepsPerSecond; }

    std::optional<QPoint> pickedPixel() const { return m_picked; }

    /// True while a student predicts what the next steps compute: no view shows it. At the end of
    /// the run nothing is left to predict, and all is shown.
    bool isAheadHidden() const { return ahead() == Ahead::Hidden; }
    Ahead ahead() const { return aheadAt(position()); }

    const Breakpoints &breakpoints() const { return m_breakpoints; }

public slots:
    void seek(std::size_t position);
    void seekToSpan(std::size_t span); ///< just after the span was entered
    void seekToPixelStep(std::size_t stepIndex); ///< just after that step
    void setUnit(pixelplumb::StepUnit unit);
    /// Forward and backward undo each other everywhere but at the ends: the stops are the unit's
    /// landings (see TraceNavigation) and the position from which the stepping started.
    void step(pixelplumb::StepUnit unit, pixelplumb::StepDirection direction);
    /// Moves to the next breakpoint in that direction, else to the end or the start.
    void run(pixelplumb::StepDirection direction);
    /// Moves to the next or previous step that writes the picked pixel; emits message() when there
    /// is none.
    void runToPickedPixel(pixelplumb::StepDirection direction);
    void setForetold(bool isForetold); ///< whether a student predicts what is ahead
    void pick(const QPoint &pixel); ///< clamped to the frame
    void nudgePick(int dx, int dy);
    /// For a column or a row; a free span has no place at which to pause again.
    void toggleSpanBreakpoint(const pixelplumb::SpanPlace &place);
    void togglePixelBreakpoint(const QPoint &pixel);
    void clearBreakpoints();
    void setPlaying(bool playing); ///< at the end, playing starts again from the start
    void setStepsPerSecond(double stepsPerSecond); ///< slowest … fastest

signals:
    void tracedChanged();
    /// Also follows every tracedChanged().
    void positionChanged(std::size_t position);
    void unitChanged(pixelplumb::StepUnit unit);
    void pickedPixelChanged();
    /// Emitted by pick(), even for the same pixel; not by a nudge, which only moves towards one.
    void pixelChosen(const QPoint &pixel);
    /// Precedes positionChanged(), where that is the cause.
    void aheadHiddenChanged(bool hidden);
    void breakpointsChanged();
    void playingChanged(bool playing);
    void stepsPerSecondChanged(double stepsPerSecond);
    /// A text for the status bar.
    void message(const QString &text);

private:
    TraceNavigation navigation() const { return TraceNavigation(*m_traced->trace); }
    void moveTo(std::size_t position);
    Ahead aheadAt(std::size_t position) const;
    void tellAhead(); ///< if it changed
    bool setPicked(std::optional<QPoint> pixel);
    QPoint clampedToFrame(const QPoint &pixel) const;
    std::size_t stopFrom(std::size_t position, StepUnit unit, StepDirection direction) const;
    void playDueSteps();

    std::shared_ptr<const TracedScene> m_traced;
    std::unique_ptr<TraceCursor> m_cursor;
    StepUnit m_unit = StepUnit::Span;
    std::optional<QPoint> m_picked;
    bool m_isForetold = false;
    Ahead m_toldAhead = Ahead::Shown;
    Breakpoints m_breakpoints;
    /// The position between landings at which stepping started; forgotten by any other move.
    std::optional<std::size_t> m_setOutFrom;
    QTimer m_timer;
    QElapsedTimer m_sinceLastTick;
    double m_stepsDue = 0; ///< fraction of a step carried between ticks
    double m_stepsPerSecond = 10;
};

} // namespace pixelplumb
