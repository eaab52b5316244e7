// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contest.h"
#include "widgets/studies/studypanel.h"

#include <QtWidgets>

namespace pixelplumb {

class AgreementView;
class CompareLink;
class ComparePane;
class Playhead;

/// Two to four contenders draw the playhead's scene side by side, each at the playhead's place,
/// with one zoom; beside them the map of where they agree, and the reason for the picked pixel in
/// words. Draws in a worker thread, and only while visible.
class ComparePanel : public StudyPanel {
    Q_OBJECT

public:
    explicit ComparePanel(Playhead *playhead, QWidget *parent = nullptr);

    std::vector<Contender> contenders() const;
    /// Null until the first contest is finished.
    const Contest *contest() const { return m_contest.get(); }
    const std::vector<ComparePane *> &panes() const { return m_panes; }

    QSize sizeHint() const override { return {960, 520}; }

public slots:
    /// Two to four.
    void setContenders(const std::vector<pixelplumb::Contender> &contenders);
    /// Centres a pixel of the current scene in every pane, once the contest is finished.
    void lookAt(const QPoint &pixel);
    void cancel();

private:
    void addControls(QBoxLayout *layout);
    void addPane();
    void removePane();
    void alignSettings();
    void choosePanes();
    void compareAnew();
    bool beginStudy() override;
    bool canAllDraw(const Scene &scene, const std::vector<Contender> &contenders);
    void take(const std::shared_ptr<const Contest> &contest);
    void measure();
    void tellPixel();

    Playhead *m_playhead;
    CompareLink *m_link;
    std::vector<ComparePane *> m_panes;
    QBoxLayout *m_row = nullptr;
    QBoxLayout *m_mapAndReason = nullptr;
    AgreementView *m_agreement = nullptr;
    QLabel *m_legend = nullptr;
    QLabel *m_reason = nullptr;
    QToolButton *m_more = nullptr;
    QToolButton *m_fewer = nullptr;
    bool m_isChosen = false; ///< the panes have contenders
    std::shared_ptr<const Contest> m_contest;
    std::optional<QPoint> m_lookedAt; ///< to be centred when the next contest is finished
    Job m_timing;
};

} // namespace pixelplumb
