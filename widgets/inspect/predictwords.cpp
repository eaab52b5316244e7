// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/predictwords.h"

#include "core/methods/formulatext.h"
#include "widgets/look/corewords.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace pixelplumb {

namespace {

struct PredictWords {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::PredictWords)
};

/// What the brackets of a rule mean, "⌈y_B⌉ is the first whole number not below y_B", without y_B's
/// value, which is asked for itself. The formula, where nothing is rounded.
QString meaningOf(const QString &rule)
{
    static const QRegularExpression brackets(
        QStringLiteral("^[^=]+ = (([⌈⌊])(.+?)( \\+ ½)?[⌉⌋]( [−+] 1)?)$"));
    const QRegularExpressionMatch parts = brackets.match(rule);
    if (!isRounding(rule) || !parts.hasMatch())
        return rule;
    const QString rounded = parts.captured(1);
    const QString number = parts.captured(3);
    if (!parts.captured(4).isEmpty())
        return PredictWords::tr("%1 is the whole number nearest to %2").arg(rounded, number);
    if (parts.captured(5) == QStringLiteral(" − 1"))
        return PredictWords::tr("%1 is the last whole number below %2").arg(rounded, number);
    if (parts.captured(5) == QStringLiteral(" + 1"))
        return PredictWords::tr("%1 is the first whole number above %2").arg(rounded, number);
    return parts.captured(2) == QStringLiteral("⌈")
        ? PredictWords::tr("%1 is the first whole number not below %2").arg(rounded, number)
        : PredictWords::tr("%1 is the last whole number not above %2").arg(rounded, number);
}

/// Whether the number is the previous span's plus something: "y_B ← y_B′ + m₀₂".
bool isStepped(const Prediction &prediction)
{
    return prediction.rule.contains(prediction.title + QStringLiteral("′ "));
}

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
            .arg((guess == Guess::RoundedUp ? QStringLiteral("⌈%1⌉") : QStringLiteral("⌊%1⌋"))
                     .arg(prediction.title),
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
    return PredictWords::tr("Not yet: %1. Put the numbers in, or have it shown.")
        .arg(meaningOf(prediction.rule));
}

} // namespace pixelplumb
