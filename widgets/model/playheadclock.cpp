// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/playhead.h"

#include <algorithm>
#include <chrono>

/// Playing: steps become due over time.
namespace pixelplumb {

namespace {

using namespace std::chrono_literals;

constexpr auto frameTime = 16ms; // faster ticks would not be seen at 60 Hz
constexpr double longestTick = 0.25; // seconds; playing does not leap after a dialog or a sleep

} // namespace

void Playhead::setPlaying(bool playing)
{
    if (playing == isPlaying() || (playing && end() == 0))
        return;
    if (playing) {
        if (position() == end())
            seek(0);
        m_stepsDue = 0;
        m_sinceLastTick.start();
        m_timer.start(frameTime);
    } else {
        m_timer.stop();
    }
    emit playingChanged(playing);
}

void Playhead::setStepsPerSecond(double stepsPerSecond)
{
    const double bounded = std::clamp(stepsPerSecond, slowest, fastest);
    if (bounded == m_stepsPerSecond)
        return;
    m_stepsPerSecond = bounded;
    emit stepsPerSecondChanged(bounded);
}

void Playhead::playDueSteps()
{
    const double seconds = double(m_sinceLastTick.nsecsElapsed()) * 1e-9;
    m_sinceLastTick.start();
    m_stepsDue += std::min(seconds, longestTick) * m_stepsPerSecond;
    std::size_t target = position();
    for (; m_stepsDue >= 1; m_stepsDue -= 1)
        target = navigation().landingFrom(target, m_unit, StepDirection::Forward);
    if (target == position())
        return;
    const auto pause
        = navigation().breakpointFrom(position(), target, m_breakpoints, StepDirection::Forward);
    seek(pause.value_or(target));
    if (pause || position() == end())
        setPlaying(false);
}

} // namespace pixelplumb
