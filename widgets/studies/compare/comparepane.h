// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contenderpace.h"
#include "core/trace/tracecursor.h"

#include <QtWidgets>

namespace pixelplumb {

class CompareLink;
class CompareView;
class Playhead;
struct SceneCost;

/// One contender: its method and settings, and its own run at the playhead's place. The truth has
/// no run and is shown finished. A narrow pane stacks its boxes and shows short counts with their
/// signs.
class ComparePane : public QWidget {
    Q_OBJECT

public:
    /// `number`: 1 … 4, as in the reasons.
    ComparePane(int number, CompareLink *link, Playhead *playhead, QWidget *parent = nullptr);

    Contender contender() const;
    void setContender(const Contender &contender); ///< without contenderChanged()
    /// Shows the contender's run of a contest; keeps the contest.
    void show(const std::shared_ptr<const Contest> &contest, std::size_t run);
    void clear(const QString &message);
    /// Shows the cost of drawing the picture beside the result.
    void showCost(const SceneCost &cost);

    /// Whether arithmetic and fill rule, as chosen, fit side by side.
    bool fitsSettingsInARow() const;
    void setSettingsDirection(QBoxLayout::Direction direction);

    CompareView *view() const;
    /// The pane's own position in its own run; none for the truth and without a run.
    std::optional<std::size_t> position() const;

signals:
    void contenderChanged();
    void roomChanged(); ///< for the settings, or the settings in it

private:
    class View;

    QComboBox *addBox(QComboBox *box, const QString &name, const QString &label);
    void offerSettings(const ScanSettings &wanted);
    void tellResult();
    ContenderTally tallyNow();
    bool isNarrow() const;
    void followPlayhead();

    int m_number;
    Playhead *m_playhead;
    QComboBox *m_method = nullptr;
    QComboBox *m_arithmetic = nullptr;
    QComboBox *m_fillRule = nullptr;
    QBoxLayout *m_settings = nullptr; ///< the boxes of arithmetic and fill rule
    QLabel *m_result = nullptr;
    QString m_figures; ///< after the result, once measured
    QString m_details; ///< of m_figures
    View *m_view = nullptr;
    ByteRounding m_rounding = ByteRounding::Nearest; ///< the scene's
    VariantSet m_variants; ///< of the contender that was set
    std::shared_ptr<const Contest> m_contest;
    std::size_t m_run = 0;
    std::unique_ptr<TraceCursor> m_cursor;
    std::optional<ContenderPace> m_pace; ///< of the recorded run, once its counts are asked for
};

} // namespace pixelplumb
