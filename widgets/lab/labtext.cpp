// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labtext.h"

#include "core/measure/timeleft.h"

#include <QCoreApplication>

namespace pixelplumb {

namespace {

QString translated(const char *text) { return QCoreApplication::translate("AccuracyLab", text); }

} // namespace

QString figureText(double value)
{
    // Three figures that count, so that points stand below each other; of small ones as many.
    if (value == 0)
        return QStringLiteral("0");
    if (value >= 100)
        return QString::number(value, 'f', 0);
    return value >= 0.1 ? QString::number(value, 'f', value >= 10 ? 1 : 2)
                        : QString::number(value, 'g', 2);
}

QString spreadText(const Spread &spread)
{
    return QStringLiteral("%1 (%2 … %3)")
        .arg(figureText(spread.median), figureText(spread.lower), figureText(spread.upper));
}

QString wrongText(const AccuracyFigures &figures)
{
    QString text
        = translated("%1 of %2 pixels wrong").arg(figures.wrongPixels()).arg(figures.pixels);
    if (figures.wrongPixels() == 0)
        return text;
    text += translated(": %1 missing, %2 extra, ties %3 missing and %4 extra, %5 in another byte")
                .arg(figures.missing)
                .arg(figures.extra)
                .arg(figures.tiesMissing)
                .arg(figures.tiesExtra)
                .arg(figures.wrongBytes);
    if (figures.wrongBytes > 0)
        text += translated(" (off by %1 at most)").arg(figures.largestByteError);
    return text;
}

QString pointHtml(const Study &study, const ParetoPoint &point, const QString &family)
{
    QStringList lines = {QStringLiteral("<b>%1</b>").arg(point.label.toHtmlEscaped())};
    const LabRow *row = study.row(point.contender, family);
    if (row && row->accuracy)
        lines.append(wrongText(*row->accuracy));
    if (point.errorClass == ErrorClass::ZeroProved) {
        const StudyContender *contender = study.contender(point.contender);
        lines.append(translated("no error, by proof")
                     + (contender && !contender->domain.isEmpty()
                            ? QStringLiteral(": ") + contender->domain.toHtmlEscaped()
                            : QString()));
    } else if (point.errorClass == ErrorClass::ZeroObserved) {
        lines.append(translated("no error observed over %1 pixels").arg(point.pixels));
    }
    QString cost = translated("%1 ns a pixel").arg(spreadText(point.cost));
    if (point.timesReference)
        cost += translated(", ×%1 the assignment's method").arg(figureText(*point.timesReference));
    lines.append(cost);
    if (point.straight)
        lines.append(
            translated("its straight loop: %1 ns a pixel").arg(spreadText(*point.straight)));
    if (point.missesStraight)
        lines.append(translated("<b>!</b> %1 times its straight loop: more than the fair 1.3")
                         .arg(figureText(*point.missesStraight)));
    if (point.isOnFrontier)
        lines.append(translated("nobody is as exact for less time"));
    if (row && row->firstMiss)
        lines.append(translated("Click: opens the scene of its first wrong pixel (%1, %2) here and "
                                "in Compare; unsaved changes are asked about first")
                         .arg(row->firstMiss->x)
                         .arg(row->firstMiss->y));
    return lines.join(QStringLiteral("<br>"));
}

QString pointLabel(const ParetoPoint &point)
{
    QString text = point.label;
    if (point.contender == QLatin1String(referenceContenderId))
        text += QStringLiteral(" ×1");
    if (point.missesStraight)
        text += QStringLiteral(" ! ×%1").arg(figureText(*point.missesStraight));
    return text;
}

QString outcomeText(const LabRow &row)
{
    switch (row.outcome) {
    case LabOutcome::Measured:
        return {};
    case LabOutcome::Pending:
        return translated("not measured");
    case LabOutcome::Refused:
        return translated("refused: %1").arg(row.remark);
    case LabOutcome::TookTooLong:
        return translated("took too long: %1").arg(row.remark);
    case LabOutcome::Failed:
        return translated("failed: %1").arg(row.remark);
    }
    return {};
}

QStringList originOf(const Study &study)
{
    return {summaryOf(study.conditions),
            study.command.isEmpty() ? translated("(save the scene to get its command)")
                                    : study.command};
}

QString invitationText(StudyExtent extent, double seconds)
{
    const QString what = translated("Run draws the same triangles by every contender, counts the "
                                    "pixels that differ from the truth, and times all of them in "
                                    "turn, beside straight loops that do the same work.");
    const QString howLong = extent == StudyExtent::Quick
        ? translated("The quick study takes fourteen contenders and %1.")
        : translated("The full study takes every method in every arithmetic and %1.");
    return what + u' ' + howLong.arg(aboutText(seconds));
}

} // namespace pixelplumb
