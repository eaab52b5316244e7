// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/nextpixel.h"
#include "core/runs/explain/prediction.h"
#include "core/scene/scene.h"

#include <QtWidgets>

namespace pixelplumb {

class Playhead;
class SceneDocument;

/// Asks for a number of the next span, or for the next pixel, before it is shown (objectName
/// "predict"). While the panel is open, tables and histories hide what lies ahead of the playhead.
/// Every question counts once, by its first answer, unless its step has been done and undone; the
/// score lasts until another scene is opened or the panel is closed. A closed panel hides no
/// numbers, so a question that was open then is answered and no longer counts.
class PredictPanel : public QWidget {
    Q_OBJECT

public:
    PredictPanel(SceneDocument *document, Playhead *playhead, QWidget *parent = nullptr);

    QSize sizeHint() const override { return {360, 220}; }
    /// Hides the panel without closing it when its workspace is left: it goes on asking.
    void leaveOpen();

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;

private:
    /// The state of the question.
    enum class State { Open, Answered };
    /// Identifies a question: it is the same at every position before the step that answers it.
    struct Place {
        std::size_t run = 0;
        std::size_t step = 0;

        friend bool operator==(const Place &, const Place &) = default;
    };

    bool isOpen() const { return isVisible() || m_isLeftOpen; }
    Place place() const;
    bool hasBeenSeen() const; ///< whether its step has been done since the panel was opened

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
    const Prediction *prediction() const; ///< null where the question is a pixel, or none

    Playhead *m_playhead;
    QComboBox *m_choice;
    QLabel *m_question;
    QLineEdit *m_answer;
    QPushButton *m_check, *m_show, *m_next;
    QLabel *m_verdict, *m_score;
    std::vector<Prediction> m_predictions;
    std::optional<NextPixel> m_nextPixel;
    State m_state = State::Open;
    std::size_t m_run = 0; ///< grows with every run: the same place is then another question
    /// How far a scene was stepped through since the panel was opened, whatever its settings, which
    /// change neither columns nor edges.
    struct Seen {
        Scene scene; ///< without its settings
        std::size_t spans = 0;
        std::size_t position = 0;
    };
    std::vector<Seen> m_seen; ///< the current one is last
    bool m_isLeftOpen = false;
    std::optional<Place> m_left; ///< where the panel was closed with a question open
    QSet<QString> m_asked; ///< the questions that have counted
    int m_right = 0;
};

/// The verdict on an answer in Predict, with the reason when it is right.
QString verdictText(const Prediction &prediction, Guess guess);

} // namespace pixelplumb
