// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/submissionview.h"

#include "core/grade/class/grader.h"
#include "core/scene/text/colourtext.h"
#include "widgets/look/corewords.h"
#include "widgets/look/framepainter.h"
#include "widgets/studies/grade/submissionpanel.h"

#include <QPainter>

namespace pixelplumb {

namespace {

QString pixels(std::int64_t count) { return SubmissionPanel::tr("%n pixels", nullptr, int(count)); }

/// A pixel's content: "#a06f30", "covered".
QString contentOf(const Picture &picture, std::size_t place)
{
    if (picture.hasColours)
        return colourText(picture.colours[place]);
    return picture.covered[place] != 0 ? SubmissionPanel::tr("covered")
                                       : SubmissionPanel::tr("not covered");
}

QString countText(const PictureDiff &diff, Difference verdict)
{
    const qint64 count = diff.count(verdict);
    switch (verdict) {
    case Difference::Missing:
        return SubmissionPanel::tr("%L1 missing").arg(count);
    case Difference::Extra:
        return SubmissionPanel::tr("%L1 extra").arg(count);
    case Difference::Colour:
        return SubmissionPanel::tr("%L1 of another colour, by up to %2")
            .arg(count)
            .arg(diff.largestError);
    case Difference::Undecidable:
        return SubmissionPanel::tr("%L1 undecidable: on an edge or within rounding error")
            .arg(count);
    case Difference::None:
        break;
    }
    return SubmissionPanel::tr("%L1 the same").arg(count);
}

} // namespace

QString verdictText(const PictureDiff &diff)
{
    const std::int64_t open = diff.count(Difference::Undecidable);
    if (diff.differing() > 0)
        return SubmissionPanel::tr("Wrong: %n pixels differ.", nullptr, int(diff.differing()));
    if (open > 0)
        return SubmissionPanel::tr(
            "Right within the leeway: %n pixels differ as a right program's may.", nullptr,
            int(open));
    return SubmissionPanel::tr("Right: no pixel differs.");
}

QString countsText(const PictureJudgement &judgement, const QPalette &palette)
{
    const PictureDiff &diff = judgement.diff;
    QStringList lines;
    for (const Difference verdict : allDifferences) {
        const bool isSame = verdict == Difference::None;
        if (!isSame && diff.count(verdict) == 0)
            continue;
        const QString colour = isSame ? palette.color(QPalette::Text).name()
                                      : signColour(signOf(verdict), palette).name();
        const QString glyph = isSame ? u"#"_s : signGlyph(signOf(verdict));
        lines += u"<span style=\"color:%1\"><b><tt>%2</tt></b></span>&nbsp;%3"_s.arg(
            colour, glyph, countText(diff, verdict));
    }
    if (judgement.found.isTransparent)
        lines += SubmissionPanel::tr("Its transparency is ignored; its colours count.");
    return lines.join(u"<br>"_s);
}

QString causesText(const PictureDiff &diff)
{
    if (diff.causes.empty())
        return {};
    const PictureCause &best = diff.causes.front();
    if (best.left == 0)
        return SubmissionPanel::tr("The whole picture: %1. That explains every pixel.")
            .arg(best.name);
    return SubmissionPanel::tr("The whole picture: %1. That leaves %2.")
        .arg(best.name, pixels(best.left));
}

QString pixelText(const PictureJudgement &judgement, const QPoint &pixel)
{
    const std::optional<std::size_t> place = judgement.placeOf(pixel);
    if (!place)
        return {};
    const Difference verdict = judgement.diff.verdicts[*place];
    const QString text
        = SubmissionPanel::tr("(%1, %2) student: %3, expected: %4")
              .arg(pixel.x())
              .arg(pixel.y())
              .arg(contentOf(judgement.found, *place), contentOf(judgement.expected, *place));
    return verdict == Difference::None ? text : text + u" — "_s + coreWord(nameOf(verdict));
}

SubmissionView::SubmissionView(Side side, CompareLink *link, Playhead *playhead, QWidget *parent)
    : CompareView(link, playhead, parent)
    , m_side(side)
{
    const bool isStudent = side == Side::Student;
    setObjectName(isStudent ? u"submissionPicture"_s : u"submissionExpected"_s);
    setAccessibleName(isStudent ? tr("The student's picture") : tr("The expected picture"));
    setToolTip(isStudent ? tr("The student's picture. A click picks the pixel.")
                         : tr("What the method draws. A click picks the pixel."));
}

void SubmissionView::setJudgement(const std::shared_ptr<const PictureJudgement> &judgement)
{
    m_judgement = judgement;
    if (!judgement)
        return setPicture({});
    setPicture(imageOf(m_side == Side::Student ? judgement->found : judgement->expected));
}

void SubmissionView::paintSigns(QPainter &painter, FramePainter &, const ViewMapping &mapping)
{
    const double cell = mapping.zoom().devicePixels / mapping.devicePixelRatio();
    if (!m_judgement || mapping.zoom().framePixels > 1 || cell < leastGlyphCell)
        return; // smaller marks would hide the picture
    const QRect shown = mapping.pictureIn(mapping.deviceRect(rect()) & mapping.devicePicture());
    forEachPixel(m_judgement->frame, shown, [&](const QPoint &pixel) {
        const Difference verdict = m_judgement->verdictAt(pixel);
        if (verdict != Difference::None)
            paintMark(painter, mapping.cellOf(pixel), signOf(verdict), palette());
    });
}

} // namespace pixelplumb
