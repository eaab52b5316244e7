// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/resultsfolder.h"
#include "core/grade/descriptor.h"

namespace pixelplumb {

/// Lets several runs grade into one folder of results at the same time. Its locks lie on bytes of
/// one file, and the kernel releases those of a process that has ended, however it ended. On a disk
/// without locks every run gets all of them: there, only one may be at work.
class ResultsLock {
public:
    /// An error where the folder's lock file cannot be made.
    static Result<ResultsLock> of(const ResultsFolder &results);

    /// Whether no other run is at work here; then none begins before share() or leave(). Does not
    /// wait.
    bool takeAlone();
    /// Works beside other runs; waits while one is alone.
    void share();
    void leave();

    /// Claims a submission until the descriptor is closed, which is not open where another run has
    /// claimed it.
    Result<Descriptor> claim(const QByteArray &submission) const;

private:
    ResultsLock(ResultsFolder results, Descriptor file)
        : m_results(std::move(results))
        , m_file(std::move(file))
    {
    }

    ResultsFolder m_results;
    Descriptor m_file;
};

} // namespace pixelplumb
