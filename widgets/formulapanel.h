// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QTextBrowser;

namespace pixelplumb {

class Playhead;
struct Explanation;

/// The formulas of the step in hand with its numbers put in (objectName "formulaPanel").
class FormulaPanel : public QWidget {
    Q_OBJECT

public:
    explicit FormulaPanel(Playhead *playhead, QWidget *parent = nullptr);

    QSize sizeHint() const override;

protected:
    void changeEvent(QEvent *event) override;

private:
    void explainStep();
    void present(const Explanation &explanation);

    Playhead *m_playhead;
    QLabel *m_heading;
    QLabel *m_sentence;
    QTextBrowser *m_formulas;
};

} // namespace pixelplumb
