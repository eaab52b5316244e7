// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labresults.h"

namespace pixelplumb {

/// Which results the lab shows while runs and files come and go: nothing that was shown is lost
/// before something else can be shown in its place, and the last that was can be had back.
class ShownResults {
public:
    const SharedResults &results() const { return m_results; } ///< null before the first ones
    /// What these took the place of; null where they are the first.
    const SharedResults &earlier() const { return m_earlier; }
    /// Of the last run; else they are those of before it.
    bool areOfRun() const { return m_areOfRun; }

    void beginRun();
    /// What a run has so far. It is not shown in the place of others before it has times of the
    /// family that is looked at; false then.
    bool takeNews(const SharedResults &news, const QString &family);
    /// Whatever has times is shown at the end of a run. False where nothing changes.
    bool endRun();

    void replaceBy(SharedResults results);

private:
    bool showNews();

    SharedResults m_results;
    SharedResults m_earlier;
    SharedResults m_news; ///< of the run, while they are not shown
    bool m_areOfRun = false;
};

} // namespace pixelplumb
