// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/shading/interpolationwords.h"
#include "core/methods/shading/shadednumbers.h"
#include "core/methods/words/formulatext.h"

#include <QStringList>

namespace pixelplumb {

namespace {

QString levelsText(const Colour &colour)
{
    return u"(%1, %2, %3)"_s.arg(colour.red()).arg(colour.green()).arg(colour.blue());
}

/// What the depth test found.
QString depthText(const ShadedSampleState &state)
{
    const QString z = term(state.depth);
    if (!state.isWritten)
        return u"Refused: its depth %1 lies behind the stored depth %2."_s.arg(z,
                                                                               term(state.nearest));
    if (state.nearest.isNone())
        return u"No depth is stored here yet: %1 is kept."_s.arg(z);
    return u"Depth %1 is not behind the stored %2: the sample is written and its depth kept."_s.arg(
        z, term(state.nearest));
}

/// How much of the pixel the triangle covers; empty if all.
QString shareText(const ShadedSampleState &state)
{
    if (!state.isWritten || !state.isBlended || state.blendedAlpha == 255)
        return {};
    const QString share = state.area.isNone()
        ? u"Its alpha is %1"_s.arg(state.alpha)
        : u"Its alpha %1 times that area is %2"_s.arg(state.alpha).arg(state.blendedAlpha);
    return share
        + u": that many parts in 255 come from its own colour %1, the rest from the "
          "%2 already there."_s.arg(levelsText(state.source), levelsText(state.before));
}

} // namespace

void tellShaded(StepWords &words, const ShadedSetUpState &state)
{
    words.sentence = verticesText(state.form, state.order, state.position);
    if (state.zeroArea)
        words.sentence += segmentText(state.form, state.order);
    if (state.isDivided[indexOf(Channel::Reciprocal)])
        words.sentence += u" What the vertices carry is divided by w, because that "
                          "is what changes linearly in the frame."_s;
}

void tellShaded(StepWords &words, const ShadedSpanState &state)
{
    if (state.isBounded) {
        words.heading = walkNames(InterpolationForm::Bilinear).heading(state.walk);
        const Lattice x = state.walk.column.x * unitsPerPixel;
        const auto &corners = state.walk.corners;
        if (x < corners[0].position.x || x > corners[2].position.x)
            words.sentence = "The column lies beside the triangle, which covers parts of its "
                             "pixels: its edges are prolonged to it, and may have crossed.";
        return;
    }
    words.heading = u"Column %1"_s.arg(state.walk.column.x);
    words.sentence = "Only samples beside the centres of its pixels lie in the triangle: no bounds "
                     "are walked here.";
}

void tellShaded(StepWords &words, const ShadedSampleState &state)
{
    if (state.samples() > 0) {
        words.sentence = state.isWritten
            ? u"An edge passes through the pixel: of its %1 samples this triangle "
              "wrote %2. The pixel is the mean of all of them."_s.arg(state.samples())
                  .arg(sampleNumbersText(state.samplesWritten, state.samples()))
            : u"Refused: at each of the pixel's %1 samples that the triangle covers "
              "it lies behind what stands there."_s.arg(state.samples());
        return;
    }
    if (state.isBeyondHorizon) {
        words.sentence = "Refused: it lies beyond the horizon of the triangle's plane, where there "
                         "are no attributes.";
        return;
    }
    QStringList sentences;
    if (state.isWritten && !state.area.isNone())
        sentences.append(u"The triangle covers %1 of the pixel's square."_s.arg(term(state.area)));
    if (state.effects.depth != DepthTest::None)
        sentences.append(depthText(state));
    sentences.append(shareText(state));
    sentences.removeAll(QString());
    words.sentence = sentences.join(u' ');
}

} // namespace pixelplumb
