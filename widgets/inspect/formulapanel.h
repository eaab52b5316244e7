// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scansettings.h"

#include <QtWidgets>

#include <tuple>

namespace pixelplumb {

class Playhead;
struct Explanation;

/// The formulas of the current step with its numbers put in (objectName "formulaPanel").
class FormulaPanel : public QWidget {
    Q_OBJECT

public:
    explicit FormulaPanel(Playhead *playhead, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// The height at which no step of the run needs scrolling, estimated from a few of its steps.
    /// It resets with the method, the arithmetic and the width; otherwise it only grows, so that
    /// the panel does not change size while stepping.
    int neededHeight() const { return m_neededHeight; }

signals:
    /// The needed height has changed, or something other than the person made the panel lower.
    void neededHeightChanged();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void takeTraced();
    void explainStep();
    void present(const Explanation &explanation);
    void measureRun();
    void growTo(int formulas);
    bool isScrolledTo(const Explanation &explanation) const;
    void fitScrollBar();
    int sentenceHeight(const Explanation &explanation) const;
    int formulasHeight(const Explanation &explanation) const;
    Arithmetic arithmetic() const;

    Playhead *m_playhead;
    QLabel *m_heading;
    QLabel *m_sentence;
    QTextBrowser *m_formulas;
    int m_neededHeight = 0;
    /// What the needed height was measured for: method, arithmetic and the width of the formulas.
    std::tuple<QString, Arithmetic, int> m_measured;
    QTimer m_measuring; ///< waits until the panel has its size
};

} // namespace pixelplumb
