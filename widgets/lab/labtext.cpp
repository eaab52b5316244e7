// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labtext.h"

#include "core/measure/timeleft.h"
#include "core/scan/choicenames.h"
#include "widgets/look/corewords.h"

#include <QtWidgets>

namespace pixelplumb {

namespace {

struct LabText {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::LabText)
};

} // namespace

QStringList wrappedLines(const QString &text, const QFont &font, double width)
{
    QStringList lines;
    for (const QString &paragraph : text.split(u'\n')) {
        QTextLayout layout(paragraph, font);
        QTextOption option;
        option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
        layout.setTextOption(option);
        layout.beginLayout();
        for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
            line.setLineWidth(width);
            lines.append(paragraph.mid(line.textStart(), line.textLength()).trimmed());
        }
        layout.endLayout();
    }
    return lines;
}

QString figureText(double value)
{
    // Three significant digits, so that points align; two for small numbers.
    if (value == 0)
        return u"0"_s;
    if (value >= 100)
        return QString::number(value, 'f', 0);
    return value >= 0.1 ? QString::number(value, 'f', value >= 10 ? 1 : 2)
                        : QString::number(value, 'g', 2);
}

QString spreadText(const Spread &spread)
{
    return u"%1 (%2 … %3)"_s.arg(figureText(spread.median), figureText(spread.lower),
                                 figureText(spread.upper));
}

QString wrongText(const AccuracyFigures &figures)
{
    QString text
        = LabText::tr("%1 of %2 pixels wrong").arg(figures.wrongPixels()).arg(figures.pixels);
    if (figures.wrongPixels() == 0)
        return text;
    text += LabText::tr(": %1 missing, %2 extra, ties %3 missing and %4 extra, %5 in another byte")
                .arg(figures.missing)
                .arg(figures.extra)
                .arg(figures.tiesMissing)
                .arg(figures.tiesExtra)
                .arg(figures.wrongBytes);
    if (figures.wrongBytes > 0)
        text += LabText::tr(" (off by %1 at most)").arg(figures.largestByteError);
    return text;
}

namespace {

/// The point's name, its errors, and what is known about a zero.
QStringList errorLines(const Study &study, const ParetoPoint &point, const LabRow *row)
{
    QStringList lines = {u"<b>%1</b>"_s.arg(point.label.toHtmlEscaped())};
    if (row && row->accuracy)
        lines.append(wrongText(*row->accuracy));
    const StudyContender *contender = study.contender(point.contender);
    switch (point.errorClass) {
    case ErrorClass::ZeroProved:
        lines.append(LabText::tr("no error, by proof: %1").arg(contender->domain.toHtmlEscaped()));
        break;
    case ErrorClass::ZeroTested:
        lines.append(LabText::tr("no error: proved for the plain kernel. Tests check that this "
                                 "SIMD kernel writes the same bytes; this is not proved"));
        break;
    case ErrorClass::ZeroObserved:
        lines.append(
            LabText::tr("no error observed over %1 pixels; nothing is proved").arg(point.pixels));
        break;
    case ErrorClass::Positive:
        break;
    }
    return lines;
}

QString joinedLines(QStringList lines, const LabRow *row)
{
    if (row && row->firstMiss)
        lines.append(
            LabText::tr("Click: opens the scene of its first wrong pixel (%1, %2) here and in "
                        "Compare; unsaved changes are asked about first")
                .arg(row->firstMiss->x)
                .arg(row->firstMiss->y));
    return lines.join(u"<br>"_s);
}

} // namespace

QString pointHtml(const Study &study, const ParetoPoint &point, const QString &family)
{
    const LabRow *row = study.row(point.contender, family);
    QStringList lines = errorLines(study, point, row);
    QString cost = LabText::tr("%1 ns a pixel").arg(spreadText(point.cost));
    if (point.timesReference)
        cost += LabText::tr(", ×%1 the assignment's method").arg(figureText(*point.timesReference));
    lines.append(cost);
    if (point.straight)
        lines.append(
            LabText::tr("its straight loop: %1 ns a pixel").arg(spreadText(*point.straight)));
    if (point.missesStraight)
        lines.append(LabText::tr("<b>!</b> %1 times its straight loop: more than the fair 1.3")
                         .arg(figureText(*point.missesStraight)));
    if (point.isOnFrontier)
        lines.append(point.kernel == LabKernel::Plain
                         ? LabText::tr("no plain kernel shown is as exact in less time")
                         : LabText::tr("no SIMD kernel shown is as exact in less time"));
    return joinedLines(lines, row);
}

QString untimedHtml(const Study &study, const ParetoPoint &point, const QString &family)
{
    const LabRow *row = study.row(point.contender, family);
    QStringList lines = errorLines(study, point, row);
    const StudyFamily *drawn = study.family(family);
    if (row && !row->remark.isEmpty())
        lines.append(row->remark.toHtmlEscaped());
    else if (drawn && drawn->timedPixels == 0)
        lines.append(LabText::tr("these triangles are judged and not timed"));
    else
        lines.append(study.isComplete
                         ? LabText::tr("not timed")
                         : LabText::tr("its time is measured once all of this family are judged"));
    return joinedLines(lines, row);
}

QString errorClassText(ErrorClass errorClass)
{
    switch (errorClass) {
    case ErrorClass::Positive:
        break;
    case ErrorClass::ZeroObserved:
        return LabText::tr("No error was seen in the pixels that were drawn. There may be "
                           "errors elsewhere.");
    case ErrorClass::ZeroTested:
        return LabText::tr("SIMD kernels of methods that are proved to make no error. Tests "
                           "check that the SIMD kernel writes the same bytes as the proved "
                           "plain kernel.");
    case ErrorClass::ZeroProved:
        return LabText::tr("It is proved that there is no error anywhere, for the triangles "
                           "that the dot names.");
    }
    return {};
}

QString straightLoopText()
{
    return LabText::tr("The shortest hand-written loop that draws the same pixels in "
                       "the same arithmetic. If a method's dot is near this loop, the "
                       "method costs only what its arithmetic costs.");
}

QString errorLabel(const ErrorAxis &axis, LabelLength length)
{
    const QString unit = coreWord(std::string_view(axis.unit));
    const QString title = coreWord(std::string_view(axis.title));
    if (unit == u"ppm"_s)
        return length == LabelLength::Short ? LabText::tr("per million")
                                            : LabText::tr("%1 per million").arg(title);
    return length == LabelLength::Short ? unit : u"%1, %2"_s.arg(title, unit);
}

QString plainText(const QString &html)
{
    return QTextDocumentFragment::fromHtml(html).toPlainText();
}

QString pointLabel(const ParetoPoint &point)
{
    QString text = point.label;
    if (point.isReference())
        text += u" ×1"_s;
    if (point.missesStraight)
        text += u" ! ×%1"_s.arg(figureText(*point.missesStraight));
    return text;
}

QString outcomeText(const LabRow &row)
{
    switch (row.outcome) {
    case LabOutcome::Measured:
        return {};
    case LabOutcome::Pending:
        return LabText::tr("not measured");
    case LabOutcome::Refused:
        return LabText::tr("refused: %1").arg(row.remark);
    case LabOutcome::TookTooLong:
        return LabText::tr("took too long: %1").arg(row.remark);
    case LabOutcome::Failed:
        return LabText::tr("failed: %1").arg(row.remark);
    }
    return {};
}

QStringList originOf(const Study &study)
{
    return {summaryOf(study.conditions),
            study.command.isEmpty() ? LabText::tr("(save the scene to get its command)")
                                    : study.command};
}

QStringList figureOrigin(const Study &study)
{
    QStringList lines = originOf(study);
    lines.removeAll(QString());
    for (const QString &warning : warningsOf(study))
        lines.append(u"⚠ "_s + warning);
    return lines;
}

QString priceText(const Study &study, const QString &family)
{
    const LabRow *reference = study.row(QLatin1String(referenceContenderId), family);
    if (!reference || !reference->accuracy || !study.perPixel(*reference))
        return {};
    const auto wrongOf
        = [](const AccuracyFigures &figures) { return figureText(figures.wrongPerMillion()); };
    QStringList prices;
    for (const Arithmetic arithmetic : allArithmetics) {
        const QString id = u"column-scan:"_s + nameText(nameOf(arithmetic));
        const LabRow *row = study.row(id, family);
        if (row == reference || !row || !row->accuracy || !study.perPixel(*row))
            continue;
        prices << LabText::tr("%1 takes %2× the time, %3 wrong")
                      .arg(nameText(nameOf(arithmetic)),
                           figureText(*study.perPixel(*row) / *study.perPixel(*reference)),
                           wrongOf(*row->accuracy));
    }
    if (prices.isEmpty())
        return {};
    return LabText::tr("Column scan, relative to float32 (%1 wrong pixels per million): %2.")
        .arg(wrongOf(*reference->accuracy), prices.join(u"; "_s));
}

QString invitationText(StudyExtent extent, double seconds)
{
    const QString invitation = extent == StudyExtent::Quick
        ? LabText::tr("Press Run to time fifteen contenders and count their wrong pixels (%1).")
        : LabText::tr("Press Run to time every method in every arithmetic and count its wrong "
                      "pixels (%1).");
    return invitation.arg(coreWord(aboutText(seconds)));
}

} // namespace pixelplumb
