// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/primitiverejection.h"

#include <QRgb>

#include <cstdint>

namespace pixelplumb {

/// Receives what a kernel announces, whatever it computes in: each state crosses as its address,
/// which the listener keeps no longer than the call. Its type is known to the run's KernelStates.
class Listener {
public:
    virtual ~Listener() = default;

    virtual void primitiveBegun(const void *setUp) = 0;
    virtual void primitiveRejected(const Rejection &rejection) = 0;
    virtual void spanEntered(const void *span) = 0;
    virtual void sampleRejected(std::int64_t x, std::int64_t y, QRgb pixel, const void *sample) = 0;
    virtual void pixelWritten(std::int64_t x, std::int64_t y, QRgb before, QRgb after,
                              const void *sample)
        = 0;
};

/// The observer that announces a kernel's events to a listener.
template <class SetUp, class Span, class Sample>
class AnnouncingObserver {
public:
    explicit AnnouncingObserver(Listener &listener)
        : m_listener(&listener)
    {
    }

    void primitiveBegun(const SetUp &setUp) { m_listener->primitiveBegun(&setUp); }
    void primitiveRejected(const Rejection &rejection) { m_listener->primitiveRejected(rejection); }
    void spanEntered(const Span &span) { m_listener->spanEntered(&span); }
    void sampleRejected(std::int64_t x, std::int64_t y, QRgb pixel, const Sample &sample)
    {
        m_listener->sampleRejected(x, y, pixel, &sample);
    }
    void pixelWritten(std::int64_t x, std::int64_t y, QRgb before, QRgb after, const Sample &sample)
    {
        m_listener->pixelWritten(x, y, before, after, &sample);
    }

private:
    Listener *m_listener;
};

} // namespace pixelplumb
