// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "core/runs/undrawn.h"
#include "core/scan/choicenames.h"
#include "core/scene/text/colourtext.h"

#include <QJsonArray>

namespace pixelplumb::cli {

namespace {

std::vector<PixelComparison> differingPixels(const CompareReport &report)
{
    std::vector<PixelComparison> pixels;
    const AgreementMap &agreement = report.contest.agreement;
    const FrameSpec &spec = agreement.spec();
    for (std::int64_t column = 0; column < spec.width; ++column) {
        for (std::int64_t row = 0; row < spec.height; ++row) {
            const std::int64_t x = spec.firstColumn + column;
            const std::int64_t y = spec.firstRow + row;
            if (agreement.agreeingAt(x, y) == agreement.contenderCount())
                continue;
            if (pixels.size() >= report.pixelLimit)
                return pixels;
            pixels.push_back(comparePixel(report.contest, x, y));
        }
    }
    return pixels;
}

QString number(std::int64_t value) { return QString::number(value); }

/// Aligns the first column left, the others right.
QStringList aligned(const std::vector<QStringList> &rows)
{
    return alignedRows(rows, [](qsizetype column) { return column == 0; });
}

/// The kinds of the scene's primitives that a contender leaves out.
QStringList kindsUndrawnBy(const ContenderRun &run, const Contest &contest)
{
    return run.contender.isTruth() ? QStringList()
                                   : kindsUndrawn(contest.primitives, *run.contender.method);
}

/// A line for each contender that leaves out kinds; the table then has a column for their pixels.
QStringList undrawnLines(const Contest &contest)
{
    QStringList lines;
    for (std::size_t i = 0; i < contest.runs.size(); ++i) {
        const QStringList kinds = kindsUndrawnBy(contest.runs[i], contest);
        if (!kinds.isEmpty())
            lines.append(u"%1 does not draw %2: missing, extra and colour are those of the rest."_s
                             .arg(i + 1)
                             .arg(kinds.join(u", "_s)));
    }
    return lines;
}

QStringList contenderTable(const Contest &contest)
{
    const QStringList undrawn = undrawnLines(contest);
    QStringList head = {u"contender"_s, u"pixels"_s, u"missing"_s, u"extra"_s, u"colour"_s};
    if (!undrawn.isEmpty())
        head.append(u"undrawn"_s);
    for (std::size_t i = 1; i <= contest.runs.size(); ++i)
        head.append(u"≠%1"_s.arg(i));
    std::vector<QStringList> rows = {head};
    for (std::size_t i = 0; i < contest.runs.size(); ++i) {
        const ContenderRun &run = contest.runs[i];
        const auto against
            = [&run](Difference kind) { return number(run.tally.againstTruth.count(kind)); };
        QStringList row = {u"%1 %2"_s.arg(i + 1).arg(run.contender.name()),
                           number(run.tally.written), against(Difference::Missing),
                           against(Difference::Extra), against(Difference::Colour)};
        if (!undrawn.isEmpty())
            row.append(number(run.tally.undrawn));
        for (std::size_t j = 0; j < contest.runs.size(); ++j)
            row.append(i == j ? u"–"_s : number(run.tally.differsFrom[j]));
        rows.push_back(row);
    }
    return aligned(rows) + undrawn;
}

QStringList agreementTable(const AgreementMap &agreement)
{
    std::vector<QStringList> rows = {{u"agree"_s, u"pixels"_s}};
    for (int agreeing = agreement.contenderCount(); agreeing > 0; --agreeing) {
        rows.push_back({u"%1 of %2"_s.arg(agreeing).arg(agreement.contenderCount()),
                        number(agreement.countAgreeing(agreeing))});
    }
    for (const Disagreement reason : allDisagreements) {
        if (agreement.count(reason) > 0)
            rows.push_back({u"  "_s + nameOf(reason), number(agreement.count(reason))});
    }
    return aligned(rows);
}

/// Agreement on attributes other than colour, by the pairs of contenders that carry them.
QStringList carriedLines(const Contest &contest)
{
    QStringList lines;
    for (const CarriedAgreement &agreement : contest.carried)
        lines.append(u"%1 and %2, %3"_s.arg(agreement.first + 1)
                         .arg(agreement.second + 1)
                         .arg(textOf(agreement)));
    return lines.isEmpty() ? lines : QStringList{QString()} + lines;
}

QJsonObject jsonOf(const CarriedAgreement &agreement)
{
    const bool differs = agreement.differing > 0;
    return {
        {u"contenders"_s, QJsonArray{qint64(agreement.first + 1), qint64(agreement.second + 1)}},
        {u"number"_s, agreement.title},
        {u"samples"_s, qint64(agreement.samples)},
        {u"differing"_s, qint64(agreement.differing)},
        {u"largest"_s, agreement.largest},
        {u"x"_s, differs ? QJsonValue(qint64(agreement.x)) : QJsonValue()},
        {u"y"_s, differs ? QJsonValue(qint64(agreement.y)) : QJsonValue()}};
}

QString valueText(const PixelOpinion &opinion)
{
    return opinion.written ? colourText(opinion.colour) : u"not drawn"_s;
}

QStringList pixelLines(const PixelComparison &pixel)
{
    QStringList values;
    QStringList reasons;
    for (std::size_t i = 0; i < pixel.opinions.size(); ++i) {
        const PixelOpinion &opinion = pixel.opinions[i];
        values.append(u"%1 %2"_s.arg(i + 1).arg(valueText(opinion)));
        if (!opinion.words.isEmpty())
            reasons.append(u"    %1 %2"_s.arg(i + 1).arg(opinion.words));
    }
    return QStringList{withMinus(u"(%1, %2) "_s.arg(pixel.x).arg(pixel.y))
                       + u"%1: %2"_s.arg(nameOf(pixel.reason), values.join(u", "_s))}
    + reasons;
}

QJsonObject jsonOf(const PixelComparison &pixel)
{
    QJsonArray opinions;
    for (const PixelOpinion &opinion : pixel.opinions) {
        opinions.append(QJsonObject{
            {u"colour"_s, opinion.written ? QJsonValue(colourText(opinion.colour)) : QJsonValue()},
            {u"reason"_s, nameOf(opinion.deviation.reason)},
            {u"words"_s, opinion.words}});
    }
    return {{u"x"_s, qint64(pixel.x)},
            {u"y"_s, qint64(pixel.y)},
            {u"agreeing"_s, pixel.agreeing},
            {u"reason"_s, nameOf(pixel.reason)},
            {u"contenders"_s, opinions}};
}

QJsonObject jsonOf(const ContenderRun &run, const Contest &contest)
{
    const auto against
        = [&run](Difference kind) { return qint64(run.tally.againstTruth.count(kind)); };
    QJsonArray differs;
    for (const std::int64_t count : run.tally.differsFrom)
        differs.append(qint64(count));
    const Contender &contender = run.contender;
    QJsonArray variants;
    for (const Variant variant : variantsIn(contender.settings.variants))
        variants.append(nameText(nameOf(variant)));
    return {
        {u"method"_s, contender.isTruth() ? u"truth"_s : contender.method->id},
        {u"arithmetic"_s,
         nameText(nameOf(contender.isTruth() ? Arithmetic::Exact : contender.settings.arithmetic))},
        {u"fillRule"_s, nameText(nameOf(contender.settings.fillRule))},
        {u"variants"_s, variants},
        {u"pixels"_s, qint64(run.tally.written)},
        {u"missing"_s, against(Difference::Missing)},
        {u"extra"_s, against(Difference::Extra)},
        {u"colour"_s, against(Difference::Colour)},
        {u"undrawn"_s, qint64(run.tally.undrawn)},
        {u"kindsNotDrawn"_s, QJsonArray::fromStringList(kindsUndrawnBy(run, contest))},
        {u"differsFrom"_s, differs}};
}

} // namespace

QStringList compareLines(const CompareReport &report)
{
    const AgreementMap &agreement = report.contest.agreement;
    QStringList lines = contenderTable(report.contest);
    lines += QStringList{QString()} + agreementTable(agreement) + carriedLines(report.contest);
    if (agreement.differing() == 0)
        return lines + QStringList{QString(), u"All agree on every pixel."_s};
    lines.append(QString());
    const std::vector<PixelComparison> pixels = differingPixels(report);
    for (const PixelComparison &pixel : pixels)
        lines += pixelLines(pixel);
    const std::int64_t more = agreement.differing() - std::int64_t(pixels.size());
    if (more > 0)
        lines.append(u"and %1 more; --limit %2 lists all"_s.arg(more).arg(agreement.differing()));
    return lines;
}

QJsonObject compareJson(const CompareReport &report)
{
    const AgreementMap &agreement = report.contest.agreement;
    QJsonArray contenders;
    for (const ContenderRun &run : report.contest.runs)
        contenders.append(jsonOf(run, report.contest));
    QJsonArray agreeing; // pixels on which 1, 2, … agree
    for (int count = 1; count <= agreement.contenderCount(); ++count)
        agreeing.append(qint64(agreement.countAgreeing(count)));
    QJsonObject reasons;
    for (const Disagreement reason : allDisagreements)
        reasons.insert(nameOf(reason), qint64(agreement.count(reason)));
    QJsonArray carried;
    for (const CarriedAgreement &each : report.contest.carried)
        carried.append(jsonOf(each));
    QJsonArray pixels;
    for (const PixelComparison &pixel : differingPixels(report))
        pixels.append(jsonOf(pixel));
    return {{u"contenders"_s, contenders}, {u"agreeing"_s, agreeing},
            {u"reasons"_s, reasons},       {u"differing"_s, qint64(agreement.differing())},
            {u"carried"_s, carried},       {u"pixels"_s, pixels}};
}

} // namespace pixelplumb::cli
