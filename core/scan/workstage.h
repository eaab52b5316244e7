// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>

namespace pixelplumb {

/// What a kernel's operations are for.
enum class WorkStage {
    SetUp, ///< the primitive as a whole
    Span, ///< one column, row or step
    Pixel, ///< one sample
};

/// An observer that also wants to know what the kernel's operations are for, through enter(stage),
/// which returns the stage that was left. Other observers pay nothing for it.
template <class Observer>
concept HearsStages = requires(Observer observer, WorkStage stage)
{
    {
        observer.enter(stage)
        } -> std::same_as<WorkStage>;
};

/// Marks a kernel's work until the end of the block as belonging to a stage.
template <class Observer>
class WorkScope {
public:
    WorkScope(const Observer &, WorkStage) { }
};

template <HearsStages Observer>
class WorkScope<Observer> {
public:
    WorkScope(const Observer &observer, WorkStage stage)
        : m_observer(observer)
        , m_left(m_observer.enter(stage))
    {
    }
    WorkScope(const WorkScope &) = delete;
    WorkScope &operator=(const WorkScope &) = delete;
    ~WorkScope() { m_observer.enter(m_left); }

private:
    Observer m_observer;
    WorkStage m_left;
};

} // namespace pixelplumb
