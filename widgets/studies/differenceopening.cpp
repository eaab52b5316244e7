// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/differenceopening.h"

#include "widgets/files/scenefiles.h"
#include "widgets/model/playhead.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The pixel that is wrong from this position on: the one that was just written, else one that
/// should have been by now.
std::optional<QPoint> wrongPixelAt(const TracedScene &traced, std::size_t position)
{
    const TraceStep step = traced.trace->stepAt(position - 1);
    if (step.kind == StepKind::Sample) {
        const PixelChange &change = traced.trace->changes()[step.sample];
        const Difference kind = traced.differences.at(change.x, change.y);
        if (kind == Difference::Extra || kind == Difference::Colour)
            return QPoint(change.x, change.y);
    }
    const FrameSpec &frame = traced.scene.frame;
    for (int column = 0; column < frame.width; ++column) {
        for (int row = 0; row < frame.height; ++row) {
            const QPoint pixel(frame.firstColumn + column, frame.firstRow + row);
            if (traced.differences.at(pixel.x(), pixel.y()) == Difference::Missing
                && traced.decidedAt(pixel.x(), pixel.y()) == position)
                return pixel;
        }
    }
    return std::nullopt;
}

} // namespace

DifferenceOpening::DifferenceOpening(SceneFiles *files, Playhead *playhead, QObject *parent)
    : QObject(parent)
    , m_files(files)
    , m_playhead(playhead)
{
    connect(playhead, &Playhead::tracedChanged, this, &DifferenceOpening::arrive);
}

void DifferenceOpening::open(const Scene &scene)
{
    m_pixel.reset();
    m_awaited = scene;
    if (!m_files->showScene(scene))
        m_awaited.reset();
}

bool DifferenceOpening::openAt(const Scene &scene, const QPoint &pixel)
{
    m_pixel = pixel;
    m_awaited = scene;
    const bool isShown = m_files->showScene(scene);
    if (!isShown)
        m_awaited.reset();
    return isShown;
}

void DifferenceOpening::arrive()
{
    const TracedScene *traced = m_playhead->traced();
    if (!m_awaited || !traced || traced->scene != *m_awaited)
        return;
    m_awaited.reset();
    if (!m_pixel)
        return goToFirstDifference(*traced);
    m_playhead->seek(traced->decidedAt(m_pixel->x(), m_pixel->y()));
    m_playhead->pick(*m_pixel);
    emit pixelReached(*m_pixel);
}

void DifferenceOpening::goToFirstDifference(const TracedScene &traced)
{
    const auto mark = std::ranges::find(traced.marks, MarkKind::FirstDifference, &TraceMark::kind);
    if (mark == traced.marks.end()) {
        m_playhead->seek(m_playhead->end());
        emit m_playhead->message(tr("Drawn to the end: every pixel is as in the truth."));
        return;
    }
    m_playhead->seek(mark->step + 1);
    if (const std::optional<QPoint> pixel = wrongPixelAt(traced, mark->step + 1))
        m_playhead->pick(*pixel);
}

} // namespace pixelplumb
