// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/predictpanel.h"

#include "core/runs/tracedscene.h"
#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"
#include "widgets/look/symbolitems.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

#include <utility>

namespace pixelplumb {

namespace {

QLabel *wordsIn(QWidget *parent, const char *name, const QString &accessible)
{
    QLabel *label = readingLabel(name, accessible, parent);
    label->setTextFormat(Qt::RichText);
    label->setMinimumWidth(1); // a long word must not widen the window
    return label;
}

QPushButton *button(QWidget *parent, const char *name, const QString &text)
{
    auto *made = new QPushButton(text, parent);
    made->setObjectName(QString::fromLatin1(name));
    made->setAutoDefault(false);
    return made;
}

} // namespace

PredictPanel::PredictPanel(SceneDocument *document, Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_choice(new SymbolBox(this))
    , m_question(wordsIn(this, "predictQuestion", tr("The question")))
    , m_answer(new QLineEdit(this))
    , m_check(button(this, "predictCheck", tr("&Check")))
    , m_show(button(this, "predictShow", tr("Sho&w")))
    , m_next(button(this, "predictNext", tr("&Next")))
    , m_verdict(wordsIn(this, "predictVerdict", tr("What is said of the answer")))
    , m_score(wordsIn(this, "predictScore", tr("Score")))
{
    named(this, "predict", tr("Predict"));
    // A click beside the fields, or on a disabled one, takes the focus from the canvas, and gives
    // it to the field that can be used.
    setFocusPolicy(Qt::ClickFocus);
    named(m_choice, "predictChoice", tr("What is asked for"));
    named(m_answer, "predictAnswer", tr("Your answer"));
    m_check->setToolTip(tr("Compare the answer with what the kernel computes (Enter)"));
    m_show->setToolTip(tr("Give up this question and see how the number comes about"));
    m_next->setToolTip(tr("Step on and ask again (Enter)"));
    m_verdict->setMinimumHeight(fontMetrics().lineSpacing() * 3);
    m_verdict->setAlignment(Qt::AlignTop | Qt::AlignLeft);

    auto *form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(8);
    form->addRow(tr("As&k for"), m_choice);
    form->addRow(m_question);
    form->addRow(tr("&Answer"), m_answer);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    for (QPushButton *made : {m_check, m_show, m_next})
        buttons->addWidget(made, 1);
    withParts(new QVBoxLayout(this), {form, buttons, m_verdict, Room(), m_score}, 8, 8);

    connect(m_choice, &QComboBox::currentIndexChanged, this, &PredictPanel::ask);
    connect(m_answer, &QLineEdit::returnPressed, this,
            [this] { m_state == State::Open ? check() : goOn(); });
    connect(m_check, &QPushButton::clicked, this, &PredictPanel::check);
    connect(m_show, &QPushButton::clicked, this, &PredictPanel::reveal);
    connect(m_next, &QPushButton::clicked, this, &PredictPanel::goOn);
    connect(playhead, &Playhead::positionChanged, this, &PredictPanel::goTo);
    connect(playhead, &Playhead::tracedChanged, this, [this] {
        ++m_run;
        beginSeen();
    });
    connect(playhead, &Playhead::pixelChosen, this, &PredictPanel::checkPick);
    connect(document, &SceneDocument::opened, this, &PredictPanel::forgetScore);
    forgetScore();
}

void PredictPanel::leaveOpen() { m_isLeftOpen = isOpen(); }

void PredictPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (std::exchange(m_isLeftOpen, false))
        return listQuestions();
    m_playhead->setForetold(true);
    m_seen.clear();
    beginSeen();
    listQuestions();
    if (!event->spontaneous() && m_answer->isEnabled())
        m_answer->setFocus(); // what is typed next is the answer, and no key of the canvas
}

void PredictPanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    if (event->spontaneous() || m_isLeftOpen)
        return; // a minimized window shows no numbers either
    m_playhead->setForetold(false);
    if (m_state == State::Open && m_choice->count() > 0)
        m_left = place();
    if (!m_asked.isEmpty())
        emit m_playhead->message(tr("Predict is closed. %1.").arg(m_score->text()));
    forgetScore();
}

void PredictPanel::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    if (m_answer->isEnabled())
        m_answer->setFocus(event->reason());
}

void PredictPanel::forgetScore()
{
    m_asked.clear();
    m_right = 0;
    m_score->clear();
}

PredictPanel::Place PredictPanel::place() const
{
    if (const Prediction *asked = prediction())
        return {m_run, asked->step};
    return {m_run, m_nextPixel ? m_nextPixel->step : m_playhead->end()};
}

bool PredictPanel::asksForPixel() const
{
    return m_nextPixel && m_choice->currentIndex() == int(m_predictions.size());
}

const Prediction *PredictPanel::prediction() const
{
    const int index = m_choice->currentIndex();
    return index >= 0 && index < int(m_predictions.size()) ? &m_predictions[std::size_t(index)]
                                                           : nullptr;
}

/// Enables the given parts. Qt would pass the focus of a disabled widget to the next one in the
/// window, where further typing would act as keys.
void PredictPanel::offer(const QList<QWidget *> &parts)
{
    for (QWidget *part : std::initializer_list<QWidget *>{m_answer, m_check, m_show, m_next}) {
        const bool isOffered = parts.contains(part);
        if (!isOffered && part->hasFocus())
            (part != m_answer && m_answer->isEnabled() ? m_answer : static_cast<QWidget *>(this))
                ->setFocus();
        part->setEnabled(isOffered);
    }
}

/// Lists the questions; the kind chosen stays from span to span.
void PredictPanel::listQuestions()
{
    if (!isVisible())
        return;
    const QString chosen = m_choice->currentText();
    m_predictions.clear();
    m_nextPixel.reset();
    if (const TracedScene *traced = m_playhead->traced()) {
        m_predictions = predictionsAfter(*traced, m_playhead->position());
        m_nextPixel = nextPixelAfter(*traced, m_playhead->position());
    }
    {
        const QSignalBlocker blocker(m_choice);
        m_choice->clear();
        for (const Prediction &prediction : m_predictions)
            m_choice->addItem(prediction.title);
        if (m_nextPixel)
            m_choice->addItem(tr("the next pixel"));
        const int same = m_choice->findText(chosen);
        const auto open = std::ranges::find(m_predictions, false, &Prediction::isRepeated);
        m_choice->setCurrentIndex(
            same >= 0 ? same : std::min(int(open - m_predictions.begin()), m_choice->count() - 1));
    }
    ask();
}

void PredictPanel::ask()
{
    m_state = State::Open;
    m_answer->clear();
    m_verdict->clear();
    QString example;
    if (const Prediction *asked = prediction()) {
        const bool isWhole = asksForWhole(*asked);
        example = isWhole ? tr("2") : tr("2, 2.75, 11/4 or 2 3/4");
        m_question->setText(typesetHtml(
            tr("%1: what is %2?").arg(coreWord(asked->place), coreWord(asked->words)) + u' '
            + (isWhole ? tr("A whole number.")
                       : tr("A fraction, or a decimal rounded to %1 places or more.")
                             .arg(leastPlaces))));
    } else if (asksForPixel()) {
        example = tr("x, y");
        m_question->setText(tr("Which pixel of the frame is written next? Type its x, y, "
                               "right-click it, or go there with the arrow keys and press Check."));
    } else {
        m_question->setText(
            m_playhead->end() == 0
                ? tr("Nothing is drawn yet. Draw a triangle: Predict then asks for its "
                     "numbers.")
                : tr("The run has ended, so there is nothing to predict: step back, "
                     "or go to the start."));
    }
    m_answer->setPlaceholderText(example);
    if (const Prediction *asked = prediction(); asked && asked->isRepeated)
        m_verdict->setText(tr("This number is the same along the whole primitive and stands in "
                              "earlier rows of the table, so the answer does not count."));
    else if (!example.isEmpty() && hasBeenSeen())
        m_verdict->setText(tr("This step has already been shown, so the answer does not count."));
    if (!example.isEmpty() && m_left == place())
        return settle(tr("The panel was closed with this question open. %1").arg(answerText()));
    offer(example.isEmpty() ? QList<QWidget *>() : QList<QWidget *>{m_answer, m_check, m_show});
}

/// To the step that was asked for; set-ups before it are passed over.
void PredictPanel::goOn() { m_playhead->seekToPixelStep(place().step); }

/// Closes the question; the next key goes on.
void PredictPanel::settle(const QString &verdict)
{
    m_state = State::Answered;
    tell(verdict);
    offer({m_answer, m_next});
}

void PredictPanel::count(bool isRight)
{
    const Place asked = place();
    const QString question
        = u"%1 %2 %3"_s.arg(asked.run).arg(asked.step).arg(m_choice->currentText());
    if (hasBeenSeen() || m_asked.contains(question))
        return;
    m_asked.insert(question);
    m_right += int(isRight);
    m_score->setText(tr("Right at the first try: %1 of %2").arg(m_right).arg(m_asked.size()));
}

void PredictPanel::tell(const QString &verdict)
{
    m_verdict->setText(typesetHtml(verdict));
    m_verdict->setAccessibleDescription(verdict);
}

} // namespace pixelplumb
