// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"

#include <QElapsedTimer>
#include <QString>

namespace pixelplumb::cli {

/// Tells on stderr how far a long job is: only on a terminal, only after a second, and without a
/// trace once the job is done.
class Progress {
public:
    Progress();
    ~Progress();
    Q_DISABLE_COPY_MOVE(Progress)

    void show(const QString &state);
    /// Erases what is shown: to be called before anything is printed.
    void clear();
    /// Shows what it hears; it must not outlive this.
    ProgressListener listener();

private:
    bool isDue() const;

    bool m_onTerminal = false;
    bool m_shown = false;
    QElapsedTimer m_sinceStart;
    qint64 m_nextShow = 1000; ///< ms since the start
};

/// What a job comes to that is given a listener; what is shown of it is gone when it is done.
template <class Job>
auto withProgress(const Job &job)
{
    Progress progress;
    return job(progress.listener());
}

} // namespace pixelplumb::cli
