// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/methods/words/formulatext.h"
#include "core/runs/tracedscene.h"
#include "widgets/inspect/predictpanel.h"
#include "widgets/look/corewords.h"
#include "widgets/model/playhead.h"
#include "widgets/model/steptext.h"

#include <QtWidgets>

#include <algorithm>

namespace pixelplumb {

namespace {

struct PredictWords {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::PredictWords)
};

/// What the brackets of a rule mean, "⌈y_B⌉ is the first whole number not below y_B", without y_B's
/// value, which is asked for itself. The formula, where nothing is rounded.
QString meaningOf(const QString &rule)
{
    static const QRegularExpression brackets(u"^[^=]+ = (([⌈⌊])(.+?)( \\+ ½)?[⌉⌋]( [−+] 1)?)$"_s);
    const QRegularExpressionMatch parts = brackets.match(rule);
    if (!isRounding(rule) || !parts.hasMatch())
        return rule;
    const QString rounded = parts.captured(1);
    const QString number = parts.captured(3);
    if (!parts.captured(4).isEmpty())
        return PredictWords::tr("%1 is the whole number nearest to %2").arg(rounded, number);
    if (parts.captured(5) == u" − 1"_s)
        return PredictWords::tr("%1 is the last whole number below %2").arg(rounded, number);
    if (parts.captured(5) == u" + 1"_s)
        return PredictWords::tr("%1 is the first whole number above %2").arg(rounded, number);
    return parts.captured(2) == u"⌈"_s
        ? PredictWords::tr("%1 is the first whole number not below %2").arg(rounded, number)
        : PredictWords::tr("%1 is the last whole number not above %2").arg(rounded, number);
}

/// Whether the number is the previous span's plus something: "y_B ← y_B′ + m₀₂".
bool isStepped(const Prediction &prediction)
{
    return prediction.rule.contains(prediction.title + u"′ "_s);
}

constexpr std::size_t mostScenesSeen = 16; ///< of edits that are undone and redone

} // namespace

QString verdictText(const Prediction &prediction, Guess guess)
{
    switch (guess) {
    case Guess::Right:
        return PredictWords::tr("Right: %1 = %2.").arg(prediction.reason, term(prediction.value));
    case Guess::Unread:
        return PredictWords::tr("Type a number, such as 2, 2.75, 11/4 or 2 3/4.");
    case Guess::Earlier:
        return isStepped(prediction)
            ? PredictWords::tr("That is %1 of the span before: what does one step add to it?")
                  .arg(prediction.title)
            : PredictWords::tr("That is %1 of the span before: %2.")
                  .arg(prediction.title, meaningOf(prediction.rule));
    case Guess::RoundedUp:
    case Guess::RoundedDown:
        return PredictWords::tr("That is %1, the whole number next to it. The question asks for %2 "
                                "itself: a fraction, or a decimal rounded to %3 places or more.")
            .arg((guess == Guess::RoundedUp ? u"⌈%1⌉"_s : u"⌊%1⌋"_s).arg(prediction.title),
                 prediction.title)
            .arg(leastPlaces);
    case Guess::Unrounded:
        return PredictWords::tr("Near, but a whole number is asked for: %1.")
            .arg(coreWord(prediction.words));
    case Guess::Near:
        return PredictWords::tr("Near: a fraction is wanted, or a decimal rounded to %1 places or "
                                "more.")
            .arg(leastPlaces);
    case Guess::OneOff:
        return PredictWords::tr("One off: %1.").arg(meaningOf(prediction.rule));
    case Guess::OtherSign:
        return PredictWords::tr("The sign is the other one.");
    case Guess::Wrong:
        break;
    }
    return PredictWords::tr("Not yet: %1. Substitute the numbers, or press Show.")
        .arg(meaningOf(prediction.rule));
}

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

bool PredictPanel::hasBeenSeen() const
{
    const TracedScene *traced = m_playhead->traced();
    const std::size_t step = place().step;
    if (prediction() && prediction()->isRepeated)
        return true;
    if (!traced || m_seen.empty() || step >= traced->trace->stepCount())
        return false;
    return prediction() ? traced->trace->stepAt(step).span < m_seen.back().spans
                        : step < m_seen.back().position;
}

void PredictPanel::beginSeen()
{
    const TracedScene *traced = m_playhead->traced();
    if (!isOpen() || !traced)
        return;
    Scene scene = traced->scene;
    scene.settings = {};
    const auto known = std::ranges::find(m_seen, scene, &Seen::scene);
    if (known != m_seen.end())
        std::rotate(known, known + 1, m_seen.end());
    else
        m_seen.push_back({std::move(scene)});
    if (m_seen.size() > mostScenesSeen)
        m_seen.erase(m_seen.begin());
}

void PredictPanel::goTo(std::size_t position)
{
    if (isOpen() && !m_seen.empty()) {
        Seen &seen = m_seen.back();
        if (const std::optional<std::size_t> span = m_playhead->currentSpan())
            seen.spans = std::max(seen.spans, *span + 1);
        seen.position = std::max(seen.position, position);
    }
    listQuestions();
}

} // namespace pixelplumb
