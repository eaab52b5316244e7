// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formulatext.h"
#include "core/runs/tracedscene.h"
#include "widgets/inspect/predictpanel.h"
#include "widgets/inspect/predictwords.h"
#include "widgets/model/playhead.h"
#include "widgets/model/typedpixel.h"

#include <QComboBox>
#include <QLineEdit>

/// Judges a student's answers, or shows the right one.
namespace pixelplumb {

void PredictPanel::check()
{
    if (m_state != State::Open)
        return;
    if (const Prediction *asked = prediction())
        checkNumber(*asked);
    else if (!m_answer->text().trimmed().isEmpty())
        checkTypedPixel();
    else if (m_playhead->pickedPixel())
        checkPick(*m_playhead->pickedPixel());
}

void PredictPanel::checkNumber(const Prediction &asked)
{
    const Guess guess = judge(asked, m_answer->text());
    const QString verdict = verdictText(asked, guess);
    if (guess != Guess::Unread && !asksForAnotherForm(guess))
        count(guess == Guess::Right);
    guess == Guess::Right ? settle(verdict) : tell(verdict);
}

void PredictPanel::checkTypedPixel()
{
    if (const std::optional<QPoint> pixel = typedPixel(m_answer->text()))
        checkPick(*pixel);
    else
        tell(tr("Type the pixel's x and y, such as 12, 7."));
}

void PredictPanel::checkPick(const QPoint &pixel)
{
    if (!isVisible() || !asksForPixel() || m_state != State::Open)
        return;
    const bool isRight = pixel == m_nextPixel->pixel;
    count(isRight);
    const QString name = tr("(%1, %2)").arg(pixel.x()).arg(pixel.y());
    if (isRight)
        settle(tr("Right, %1. %2").arg(name, m_nextPixel->reason));
    else
        tell(tr("Not %1. %2 Try again, or press Show.")
                 .arg(name, wrongPixelText(*m_playhead->traced(), m_playhead->position(), pixel)));
}

void PredictPanel::reveal()
{
    count(false);
    settle(answerText());
}

QString PredictPanel::answerText() const
{
    if (const Prediction *asked = prediction())
        return tr("%1 = %2").arg(asked->reason, term(asked->value));
    return tr("It is (%1, %2). %3")
        .arg(m_nextPixel->pixel.x())
        .arg(m_nextPixel->pixel.y())
        .arg(m_nextPixel->reason);
}

} // namespace pixelplumb
