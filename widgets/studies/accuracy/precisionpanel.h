// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/bounderrors.h"
#include "widgets/studies/studypanel.h"

#include <QtWidgets>

namespace pixelplumb {

class Playhead;
class PrecisionPlot;

/// How far the bounds that each arithmetic computes are from the exact edges of the current
/// triangle. Computed in a worker thread, and only while visible.
class PrecisionPanel : public StudyPanel {
    Q_OBJECT

public:
    explicit PrecisionPanel(Playhead *playhead, QWidget *parent = nullptr);

    const std::vector<BoundErrors> &errors() const { return m_errors; }
    PrecisionPlot *plot() const { return m_plot; }

private:
    bool beginStudy() override;
    void take(std::vector<BoundErrors> errors);
    void showErrors();
    void followPosition();
    void jumpTo(std::int64_t coordinate);
    QString summary() const;

    Playhead *m_playhead;
    QComboBox *m_bound = nullptr;
    std::vector<QToolButton *> m_arithmetics; ///< in allArithmetics order, without the exact one
    PrecisionPlot *m_plot = nullptr;
    std::size_t m_triangle = 0;
    std::vector<BoundErrors> m_errors;
};

} // namespace pixelplumb
