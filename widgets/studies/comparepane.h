// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contest.h"
#include "core/trace/tracecursor.h"

#include <QWidget>

class QBoxLayout;
class QComboBox;
class QLabel;

namespace pixelplumb {

class CompareLink;
class CompareView;
class Playhead;
struct LiveFigures;

/// One contender: what it is, and its own run at the place where the playhead is. The truth has no
/// run; it is shown finished. Where what is ahead is hidden, the truth and methods that go another
/// way are shown at the pixels that are decided, and nothing is counted. Where the pane is narrow,
/// its boxes stand one below the other and the counts are short, with their signs.
class ComparePane : public QWidget {
    Q_OBJECT

public:
    /// number: 1 … 4, as the reasons call it.
    ComparePane(int number, CompareLink *link, Playhead *playhead, QWidget *parent = nullptr);
    ~ComparePane() override;

    Contender contender() const;
    void setContender(const Contender &contender); ///< without contenderChanged()
    /// The contender's part of a contest; the contest is kept.
    void show(const std::shared_ptr<const Contest> &contest, std::size_t run);
    void clear(const QString &message);
    /// What drawing the shown picture takes, beside how it did.
    void showFigures(const LiveFigures &figures);

    CompareView *view() const;
    /// The pane's own position in its own run; none for the truth and without a run.
    std::optional<std::size_t> position() const;

signals:
    void contenderChanged();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    class View;

    QComboBox *addBox(const QString &name, const QString &label);
    void offerSettings(const ScanSettings &wanted);
    void tellResult();
    bool isNarrow() const;
    void followPlayhead();
    bool goesTheSameWay() const; ///< as the playhead's run
    void showPicture(const QImage &picture);

    int m_number;
    Playhead *m_playhead;
    QComboBox *m_method = nullptr;
    QComboBox *m_arithmetic = nullptr;
    QComboBox *m_fillRule = nullptr;
    QBoxLayout *m_settings = nullptr; ///< the boxes of arithmetic and fill rule
    QLabel *m_result = nullptr;
    QString m_figures; ///< behind the result, once they are measured
    QString m_details; ///< of them
    View *m_view = nullptr;
    ByteRounding m_rounding = ByteRounding::Nearest; ///< the scene's
    VariantSet m_variants; ///< of the contender that it was given
    std::shared_ptr<const Contest> m_contest;
    std::size_t m_run = 0;
    std::unique_ptr<TraceCursor> m_cursor;
};

} // namespace pixelplumb
