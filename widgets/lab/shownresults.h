// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labresults.h"

namespace pixelplumb {

/// Which results the lab shows while runs and files come and go: results stay until others can be
/// shown in their place, and the previous ones can be restored.
class ShownResults {
public:
    const SharedResults &results() const { return m_results; } ///< null before the first ones
    /// The results before these; null where these are the first.
    const SharedResults &earlier() const { return m_earlier; }
    /// Whether the results are from the last run, not from before it.
    bool areOfRun() const { return m_areOfRun; }

    void beginRun();
    /// Takes a run's results so far. They do not replace others, and this returns false, until they
    /// have times of the shown family.
    bool takeNews(const SharedResults &news, const QString &family);
    /// Shows the run's results if they have times. False where nothing changes.
    bool endRun();

    void replaceBy(SharedResults results);

private:
    bool showNews();

    SharedResults m_results;
    SharedResults m_earlier;
    SharedResults m_news; ///< of the run, while not shown
    bool m_areOfRun = false;
};

} // namespace pixelplumb
