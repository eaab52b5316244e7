// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/lab/operationcounts.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace pixelplumb {

/// Where counting numbers count: one in hand in each thread while it lives.
class OperationTally {
public:
    OperationTally()
        : m_before(std::exchange(inHand, this))
    {
    }
    ~OperationTally() { inHand = m_before; }
    OperationTally(const OperationTally &) = delete;
    OperationTally &operator=(const OperationTally &) = delete;

    static void count(Operation operation, std::int64_t times = 1)
    {
        if (inHand && !inHand->m_isPaused)
            inHand->counts.stages[std::size_t(inHand->m_stage)][std::size_t(operation)] += times;
    }

    WorkStage enter(WorkStage stage) { return std::exchange(m_stage, stage); }
    void beginPrimitive()
    {
        m_stage = WorkStage::SetUp;
        m_asked.clear();
    }

    OperationCounts counts;

private:
    friend class OncePerEdge;

    /// What was asked of an edge.
    struct Asked {
        Vertex from, to;
        int what = 0;

        friend bool operator==(const Asked &, const Asked &) = default;
    };

    static inline thread_local OperationTally *inHand = nullptr;

    OperationTally *m_before;
    WorkStage m_stage = WorkStage::SetUp;
    bool m_isPaused = false;
    std::vector<Asked> m_asked; ///< of the primitive in hand
};

/// To the end of its block nothing is counted if the same was asked of the same edge before: a walk
/// starts with the very quotients that the set-up shows.
class OncePerEdge {
public:
    static constexpr int slope = -1; ///< what: this, a channel's rate, or the pre-step
    static constexpr int preStep = -2;

    OncePerEdge(const Vertex &from, const Vertex &to, int what)
        : m_tally(OperationTally::inHand)
    {
        if (!m_tally)
            return;
        m_wasPaused = m_tally->m_isPaused;
        const OperationTally::Asked asked{from, to, what};
        const auto end = m_tally->m_asked.end();
        const auto lately
            = end - std::min<std::ptrdiff_t>(longestMemory, std::ssize(m_tally->m_asked));
        if (std::find(lately, end, asked) != end)
            m_tally->m_isPaused = true;
        else
            m_tally->m_asked.push_back(asked);
    }
    ~OncePerEdge()
    {
        if (m_tally)
            m_tally->m_isPaused = m_wasPaused;
    }
    OncePerEdge(const OncePerEdge &) = delete;
    OncePerEdge &operator=(const OncePerEdge &) = delete;

    bool isFirst() const { return m_tally && !m_tally->m_isPaused; }

private:
    /// As much as a triangle's edges are asked; a polygon may have any number of edges.
    static constexpr std::ptrdiff_t longestMemory = 16;

    OperationTally *m_tally;
    bool m_wasPaused = false;
};

} // namespace pixelplumb
