// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/nextpixel.h"
#include "core/runs/prediction.h"
#include "core/scene/scene.h"

#include <QSet>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace pixelplumb {

class Playhead;
class SceneDocument;

/// Asks for a number of the next span, or for the next pixel, before it is shown (objectName
/// "predict"). While the panel is open, tables and histories hide what lies ahead of the playhead.
/// Every question counts once, by its first answer, unless its step has been done and undone; the
/// score lasts while the scene is open and the panel is not closed. Numbers can be seen while it is
/// closed: a question that was open then has its answer told and counts no more.
class PredictPanel : public QWidget {
    Q_OBJECT

public:
    PredictPanel(SceneDocument *document, Playhead *playhead, QWidget *parent = nullptr);

    QSize sizeHint() const override { return {360, 220}; }
    /// The workspace in which it is open is left: it is hidden, but goes on asking.
    void leaveOpen();

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;

private:
    /// What has become of the question.
    enum class State { Open, Answered };
    /// What is asked for is the same wherever the playhead stands before the step that answers it.
    struct Place {
        std::size_t run = 0;
        std::size_t step = 0;

        friend bool operator==(const Place &, const Place &) = default;
    };

    bool isOpen() const { return isVisible() || m_isLeftOpen; }
    Place place() const;
    bool hasBeenSeen() const; ///< whether its step has been done since the panel is open

    void forgetScore();
    void beginSeen();
    void goTo(std::size_t position);
    void listQuestions();
    void ask();
    void offer(const QList<QWidget *> &parts); ///< of the field and the buttons
    void check();
    void checkNumber(const Prediction &asked);
    void checkTypedPixel();
    void checkPick(const QPoint &pixel);
    void reveal();
    QString answerText() const;
    void goOn();
    void settle(const QString &verdict);
    void count(bool isRight);
    void tell(const QString &verdict);
    bool asksForPixel() const;
    const Prediction *prediction() const; ///< null where a pixel is asked for, or nothing

    Playhead *m_playhead;
    QComboBox *m_choice;
    QLabel *m_question;
    QLineEdit *m_answer;
    QPushButton *m_check, *m_show, *m_next;
    QLabel *m_verdict, *m_score;
    std::vector<Prediction> m_predictions;
    std::optional<NextPixel> m_nextPixel;
    State m_state = State::Open;
    std::size_t m_run = 0; ///< grows with every run: the same place asks another question
    /// How far a scene was stepped through since the panel is open, whatever its settings, which
    /// change neither columns nor edges.
    struct Seen {
        Scene scene; ///< its settings left out
        std::size_t spans = 0;
        std::size_t position = 0;
    };
    std::vector<Seen> m_seen; ///< that in hand is the last
    bool m_isLeftOpen = false;
    std::optional<Place> m_left; ///< where the panel was closed with a question open
    QSet<QString> m_asked; ///< the questions that have counted
    int m_right = 0;
};

} // namespace pixelplumb
