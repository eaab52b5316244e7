// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"

#include <QElapsedTimer>
#include <QString>

namespace pixelplumb::cli {

/// Shows on stderr how far a long job is: only on a terminal, only after a second; erased once the
/// job is done.
class Progress {
public:
    Progress();
    ~Progress();
    Q_DISABLE_COPY_MOVE(Progress)

    void show(const QString &state);
    /// Erases what is shown: to be called before anything is printed.
    void clear();
    /// Shows what it is told; it must not outlive this object.
    ProgressListener listener();

private:
    bool isDue() const;

    bool m_onTerminal = false;
    bool m_shown = false;
    QElapsedTimer m_sinceStart;
    qint64 m_nextShow = 1000; ///< ms since the start
};

/// Runs a job with a progress listener and returns its result; what was shown is erased at the end.
template <class Job>
auto withProgress(const Job &job)
{
    Progress progress;
    return job(progress.listener());
}

} // namespace pixelplumb::cli
