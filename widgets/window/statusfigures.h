// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/elidedlabel.h"
#include "widgets/model/job.h"

namespace pixelplumb {

class Playhead;

/// What the method and the arithmetic in hand get wrong of this scene, and what they take
/// (objectName "statusFigures"). Measured beside the GUI thread, and only while it is seen.
class StatusFigures : public ElidedLabel {
    Q_OBJECT

public:
    explicit StatusFigures(Playhead *playhead, QWidget *parent = nullptr);

    bool isMeasuring() const { return m_job.isRunning(); }

protected:
    void showEvent(QShowEvent *event) override;

private:
    void measure();

    Playhead *m_playhead;
    bool m_isStale = true;
    Job m_job;
};

} // namespace pixelplumb
