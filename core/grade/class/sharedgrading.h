// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/gradefolder.h"
#include "core/grade/class/grader.h"
#include "core/grade/class/resultslock.h"

#include <atomic>

namespace pixelplumb {

/// Grades submissions into a folder of results, several at once, beside other runs.
class SharedGrading {
public:
    SharedGrading(const GradingOrder &order, const Assignment &assignment, const ResultsLock &lock,
                  const ProgressListener &listener);

    /// Returns the submissions that other runs have claimed.
    std::vector<QByteArray> run(std::vector<QByteArray> names);
    /// Whether the listener ended it, or it could not write.
    bool isStopped() const { return m_stop.stop_requested(); }
    const std::optional<InputError> &error() const { return m_error; }

private:
    void work();
    Descriptor claimOf(const QByteArray &name);
    void gradeAlone(const QByteArray &name);
    std::optional<InputError> gradeOne(const QByteArray &name);
    void add(const QByteArray &name, std::vector<QByteArray> &names);
    void endWith(const std::optional<InputError> &error);
    void tell(std::int64_t more);

    const GradingOrder &m_order;
    Grader m_grader;
    ResultsFolder m_results;
    const ResultsLock &m_lock;
    QByteArray m_assignment; ///< as written
    QByteArray m_circumstances;
    std::vector<QByteArray> m_names;
    const ProgressListener &m_listener;
    std::stop_source m_stop;
    std::atomic<std::size_t> m_next = 0;
    std::mutex m_mutex;
    std::int64_t m_done = 0;
    std::int64_t m_total = 0;
    std::vector<QByteArray> m_failed; ///< while others were graded
    std::vector<QByteArray> m_claimedByOthers;
    std::optional<InputError> m_error;
};

} // namespace pixelplumb
