// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/differenceopening.h"

#include "widgets/files/scenefiles.h"
#include "widgets/model/playhead.h"

namespace pixelplumb {

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
    standAt(*m_pixel, *traced);
}

/// Stops the playhead where the pixel's fate is decided: at the step that writes it, or, for a
/// missing one, at the step that rejects it or ends its column or row.
void DifferenceOpening::standAt(const QPoint &pixel, const TracedScene &traced)
{
    m_playhead->seek(traced.decidedAt(pixel.x(), pixel.y()));
    m_playhead->pick(pixel);
    emit pixelReached(pixel);
}

void DifferenceOpening::goToFirstDifference(const TracedScene &traced)
{
    if (const auto wrong = traced.firstWrongPixel())
        return standAt(QPoint(int(wrong->x), int(wrong->y)), traced);
    m_playhead->seek(m_playhead->end());
    emit m_playhead->message(tr("Drawn to the end: every pixel is as in the truth."));
}

} // namespace pixelplumb
