// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/compare/comparetext.h"

#include "core/scan/choicenames.h"
#include "core/scene/text/colourtext.h"
#include "widgets/look/corewords.h"
#include "widgets/studies/compare/comparepane.h"
#include "widgets/studies/compare/comparepanel.h"
#include "widgets/studies/compare/compareview.h"

namespace pixelplumb {

namespace {

QString countOf(const ContenderTally &tally, Difference kind)
{
    return QString::number(tally.againstTruth.count(kind));
}

} // namespace

QString agreementLegend(const AgreementMap &agreement, const QPalette &palette)
{
    QStringList legend;
    for (int agreeing = agreement.contenderCount(); agreeing > 0; --agreeing) {
        const QString who = agreeing == agreement.contenderCount() ? ComparePanel::tr("all agree")
            : agreeing == 1                                        ? ComparePanel::tr("none agree")
                            : ComparePanel::tr("%1 agree").arg(agreeing);
        QString meaning = u"%1: %2"_s.arg(who).arg(agreement.countAgreeing(agreeing));
        meaning.replace(u' ', u"&nbsp;"_s); // lines break only between the colours
        legend.append(u"<span style=\"background:%1\">&nbsp;&nbsp;&nbsp;</span>&nbsp;%2"_s.arg(
            agreementColour(agreeing, agreement.contenderCount(), palette).name(), meaning));
    }
    return legend.join(u"&nbsp;&nbsp; "_s);
}

QString resultText(const ContenderRun &run, const ContenderTally &tally)
{
    const int written = int(run.tally.written);
    QString text;
    if (written == 0 && !run.contender.isTruth())
        text = ComparePane::tr("Draws nothing of this scene.");
    else if (run.contender.isTruth())
        text = ComparePane::tr("%n pixels, shown finished", nullptr, written);
    else
        text = (tally == run.tally
                    ? ComparePane::tr("%n pixels: %1 missing, %2 extra, %3 in another colour",
                                      nullptr, written)
                    : ComparePane::tr("%4 of %n pixels so far: %1 missing, %2 extra, %3 in another "
                                      "colour",
                                      nullptr, written)
                          .replace(QLatin1String("%4"), QString::number(tally.written)))
                   .arg(countOf(tally, Difference::Missing), countOf(tally, Difference::Extra),
                        countOf(tally, Difference::Colour));
    if (run.tally.undrawn > 0)
        text += ComparePane::tr("; %1 undrawn, of other kinds").arg(run.tally.undrawn);
    const std::vector<Variant> variants = variantsIn(run.contender.settings.variants);
    if (!variants.empty())
        text += ComparePane::tr("; with %1").arg(namesOf(variants).join(u' '));
    return text;
}

QString shortResultText(const ContenderRun &run, const ContenderTally &tally)
{
    if (run.tally.written == 0 || run.contender.isTruth())
        return resultText(run, tally);
    const QString pixels = QString::number(run.tally.written);
    QStringList wrong;
    const auto count = [&](Difference kind, const QString &text) {
        if (tally.againstTruth.count(kind) > 0)
            wrong += text.arg(countOf(tally, kind));
    };
    count(Difference::Missing, ComparePane::tr("%1 missing"));
    count(Difference::Extra, ComparePane::tr("%1 extra"));
    count(Difference::Colour, ComparePane::tr("%1 wrong colour"));
    const bool isFinished = tally == run.tally;
    if (wrong.isEmpty())
        wrong += isFinished ? ComparePane::tr("correct") : ComparePane::tr("correct so far");
    return ComparePane::tr("%1: %2").arg(
        isFinished ? pixels : u"%1/%2"_s.arg(tally.written).arg(pixels), wrong.join(u", "_s));
}

QString carriedText(const Contest &contest)
{
    QStringList lines;
    const CarriedAgreement *previous = nullptr;
    for (const CarriedAgreement &agreement : contest.carried) {
        const bool isSamePair = previous && previous->first == agreement.first
            && previous->second == agreement.second;
        if (isSamePair)
            lines.back() += u"; "_s + textOf(agreement);
        else
            lines.append(ComparePanel::tr("%1 and %2, apart from colour: %3")
                             .arg(agreement.first + 1)
                             .arg(agreement.second + 1)
                             .arg(textOf(agreement)));
        previous = &agreement;
    }
    return lines.join(u'\n');
}

QString pixelText(const Contest &contest, const std::optional<QPoint> &picked)
{
    if (contest.agreement.differing() == 0)
        return ComparePanel::tr("All agree on every pixel.");
    if (!picked || !contest.runs.front().picture.view().contains(picked->x(), picked->y()))
        return ComparePanel::tr(
                   "Pixels that differ: %1. Click one in the picture “Finished” to see why.")
            .arg(contest.agreement.differing());
    const PixelComparison pixel = comparePixel(contest, picked->x(), picked->y());
    const int all = contest.agreement.contenderCount();
    if (pixel.agreeing == all)
        return ComparePanel::tr(
                   "Pixel (%1, %2): all agree. Pixels that differ: %3; click one in the picture "
                   "“Finished” to see why.")
            .arg(picked->x())
            .arg(picked->y())
            .arg(contest.agreement.differing());
    QStringList lines = {ComparePanel::tr("Pixel (%1, %2): %3 of %4 agree. %5: %6")
                             .arg(picked->x())
                             .arg(picked->y())
                             .arg(pixel.agreeing)
                             .arg(all)
                             .arg(coreWord(nameOf(pixel.reason)), coreWord(textOf(pixel.reason)))};
    QStringList right;
    for (std::size_t i = 0; i < pixel.opinions.size(); ++i) {
        const PixelOpinion &opinion = pixel.opinions[i];
        const QString value
            = opinion.written ? colourText(opinion.colour) : ComparePanel::tr("not drawn");
        const QString text = ComparePanel::tr("%1: %2").arg(i + 1).arg(value);
        if (opinion.words.isEmpty())
            right.append(text);
        else
            lines.append(text + u", "_s + inEnglish(opinion.words));
    }
    if (!right.isEmpty())
        lines.append(right.join(u";  "_s));
    return lines.join(u'\n');
}

} // namespace pixelplumb
