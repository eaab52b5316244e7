// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "core/lab/study/pareto.h"
#include "core/scan/choicenames.h"

#include <algorithm>
#include <array>

namespace pixelplumb::cli {

namespace {

using Line = QStringList;

/// Aligns the first column and the last, a remark, as words, the others as numbers.
QStringList withRemarks(const std::vector<Line> &lines)
{
    return alignedRows(lines, [last = lines.front().size() - 1](qsizetype column) {
        return column == 0 || column == last;
    });
}

/// Empty where nothing was measured, since 0.000 would be a number.
QString number(const std::optional<double> &value, int digits)
{
    return value ? QString::number(*value, 'f', digits) : QString();
}

QString shortNumber(const std::optional<double> &value)
{
    return value ? QString::number(*value, 'g', 3) : QString();
}

QString wrongText(const AccuracyFigures &figures, const StudyContender &contender)
{
    if (figures.wrongPixels() > 0)
        return number(figures.wrongPerMillion(), 2);
    if (!contender.isProved)
        return u"0 seen"_s;
    return contender.kernel == LabKernel::Fast ? u"0 tested"_s : u"0 proved"_s;
}

QString shareText(std::int64_t count, std::int64_t of)
{
    return number(of == 0 ? std::nullopt : std::optional(100 * double(count) / double(of)), 1);
}

QString remarkOf(const LabRow &row)
{
    QStringList remarks;
    if (row.outcome != LabOutcome::Measured)
        remarks << nameOf(row.outcome);
    if (!row.remark.isEmpty())
        remarks << row.remark;
    if (const auto times = row.missesStraight())
        remarks << u"misses 1.3 of its straight loop: %1"_s.arg(*times, 0, 'f', 2);
    return remarks.join(u": "_s);
}

Line lineOf(const Study &study, const LabRow &row)
{
    const StudyContender &contender = *study.contender(row.contender);
    const LabRow *reference = study.row(QLatin1String(referenceContenderId), row.family);
    const auto perPixel = study.perPixel(row);
    std::optional<double> timesReference;
    if (perPixel && reference && study.perPixel(*reference))
        timesReference = *perPixel / *study.perPixel(*reference);
    Line line = {row.contender};
    line.push_back(number(perPixel, 2));
    line.push_back(number(timesReference, 2));
    line.push_back(number(row.cost && row.cost->timesStraight
                              ? std::optional(row.cost->timesStraight->median)
                              : std::nullopt,
                          2));
    if (const auto &figures = row.accuracy) {
        line.push_back(wrongText(*figures, contender));
        line.push_back(shareText(figures->wrongTriangles, figures->triangles));
        line.push_back(QString::number(figures->missing));
        line.push_back(QString::number(figures->extra));
        line.push_back(QString::number(figures->tiesMissing + figures->tiesExtra));
        line.push_back(shortNumber(std::max(figures->farthestMissing, figures->farthestExtra)));
        line.push_back(QString::number(figures->wrongBytes));
        line.push_back(QString::number(figures->largestByteError));
        line.push_back(
            shortNumber(figures->levels ? std::optional(figures->levels->largest) : std::nullopt));
    } else {
        line.resize(line.size() + 9);
    }
    line.push_back(remarkOf(row));
    return line;
}

QStringList familyText(const Study &study, const StudyFamily &family)
{
    std::vector<Line> lines
        = {{u"contender"_s, u"ns/px"_s, u"× assignment"_s, u"× straight"_s, u"wrong ppm"_s,
            u"% triangles"_s, u"missing"_s, u"extra"_s, u"ties"_s, u"farthest px"_s, u"bytes"_s,
            u"by levels"_s, u"before rounding"_s, QString()}};
    for (const LabRow &row : study.rows) {
        if (row.family == family.id)
            lines.push_back(lineOf(study, row));
    }
    QStringList text = {QString(), u"%1: %2"_s.arg(family.title, family.stresses)};
    text += u"%1 triangles; timed %2 of them, %3 pixels, %4 bytes of cache lines"_s
                .arg(family.triangles)
                .arg(family.timedTriangles)
                .arg(family.timedPixels)
                .arg(family.timedBytes);
    return text + withRemarks(lines);
}

QStringList fitText(const Study &study)
{
    std::vector<Line> lines = {{u"contender"_s, u"ns a triangle"_s, u"a column"_s, u"a pixel"_s,
                                u"off by %"_s, QString()}};
    for (const StudyContender &contender : study.contenders) {
        if (const auto &fit = contender.fit) {
            lines.push_back({contender.id, number(fit->perTriangle, 1), number(fit->perColumn, 2),
                             number(fit->perPixel, 2), number(100 * fit->residual, 0), QString()});
        }
    }
    if (lines.size() == 1)
        return {};
    return QStringList{QString(),
                       u"What set-up, columns and pixels take, fitted over the families"_s}
    + withRemarks(lines);
}

/// How even the brightness of lines is in all directions.
QStringList brightnessText(const Study &study)
{
    QStringList text;
    QString last;
    for (const EffectRow &row : study.effects) {
        const auto range = brightnessRangeOf(study.effects, row.group);
        if (row.group == last || !range)
            continue;
        last = row.group;
        text << u"%1: brightness for each pixel of length %2 to %3, ratio %4"_s.arg(
            row.group, number(range->least, 4), number(range->greatest, 4),
            number(range->greatest / range->least, 4));
    }
    return text;
}

/// What effects cost and correct.
QStringList effectsText(const Study &study)
{
    if (study.effects.empty())
        return {};
    std::vector<Line> lines
        = {{u"scene"_s, u"way"_s, u"arithmetic"_s, u"ns/px"_s, u"× first"_s, u"error, levels"_s,
            u"wrong pixels"_s, u"off the surface"_s, u"brightness"_s, QString()}};
    for (const EffectRow &row : study.effects)
        lines.push_back(
            {row.group, row.way, nameText(nameOf(row.arithmetic)),
             number(row.perPixel ? std::optional(row.perPixel->median) : std::nullopt, 2),
             number(row.timesFirst ? std::optional(row.timesFirst->median) : std::nullopt, 2),
             number(row.rms, 2), QString::number(row.wrongPixels), shortNumber(row.distance),
             number(row.brightness, 4),
             row.isTooSlow() ? u"over %1"_s.arg(mostTimesLoop) : QString()});
    return QStringList{
               QString(),
               u"What effects cost and what they mend: plain kernels of the column scan, of lines "
               "by their own methods; errors from the exact area or the truth; kernels from their "
               "straight loops"_s}
    + withRemarks(lines) + brightnessText(study);
}

} // namespace

QStringList studyLines(const Study &study)
{
    QStringList text = {summaryOf(study.conditions)};
    for (const QString &warning : warningsOf(study))
        text << u"! "_s + warning;
    for (const StudyFamily &family : study.families)
        text += familyText(study, family);
    text += fitText(study);
    text += effectsText(study);
    text << QString() << u"again: "_s + study.command;
    return text;
}

} // namespace pixelplumb::cli
