// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/playhead.h"

#include <QtGui>

namespace pixelplumb {

/// Every way to move the playhead, as actions that the menu, the stepper bar and the keys share.
class StepActions : public QObject {
    Q_OBJECT

public:
    explicit StepActions(Playhead *playhead, QObject *parent = nullptr);

    QAction *toStart() const { return m_toStart; }
    QAction *toEnd() const { return m_toEnd; }
    QAction *play() const { return m_play; }
    QAction *step(StepUnit unit, StepDirection direction) const;
    QAction *runToPixel(StepDirection direction) const;
    QAction *toggleColumnBreakpoint() const { return m_columnBreakpoint; }
    QAction *togglePixelBreakpoint() const { return m_pixelBreakpoint; }
    QAction *clearBreakpoints() const { return m_clearBreakpoints; }
    QAction *unit(StepUnit unit) const;
    QList<QAction *> units() const { return m_units->actions(); }

private:
    QAction *add(const QString &name, const QString &text, const QString &iconText,
                 const QKeySequence &key, const QString &tip);
    template <class Do>
    QAction *addMove(const QString &name, const QString &text, const QString &iconText,
                     const QKeySequence &key, const QString &tip, Do move);
    void addSteps();
    void addBreakpoints();
    void addUnits();
    void updateEnabled();
    void updatePlay();
    void nameSpans();

    Playhead *m_playhead;
    QAction *m_toStart = nullptr;
    QAction *m_toEnd = nullptr;
    QAction *m_play = nullptr;
    QAction *m_steps[3][2] = {}; ///< [StepUnit][StepDirection]
    QAction *m_runToPixel[2] = {}; ///< [StepDirection]
    std::optional<SpanAxis> m_namedAxis;
    QAction *m_columnBreakpoint = nullptr;
    QAction *m_pixelBreakpoint = nullptr;
    QAction *m_clearBreakpoints = nullptr;
    QActionGroup *m_units = nullptr;
};

} // namespace pixelplumb
