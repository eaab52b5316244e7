// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/explanation.h"
#include "core/methods/tracecolumn.h"
#include "core/trace/tracerecorder.h"

#include <QStringList>

#include <memory>
#include <span>

namespace pixelplumb {

struct TracedScene;

/// One way to turn geometry into pixels: a row of the table of methods.
struct Method {
    QString id; ///< "column-scan"
    QString title; ///< "Column scan"
    QString source; ///< seed and slide
    QString summary; ///< one sentence
    QStringList effects; ///< what it meets: "smooth colour"
    std::vector<Arithmetic> arithmetics;
    std::vector<FillRule> fillRules;
    std::vector<TraceColumn> traceColumns;

    /// Draws triangles (sample coordinates) in order.
    void (*draw)(std::span<const Triangle> triangles, const ScanSettings &settings,
                 FrameView frame);
    /// The same picture, bit for bit, as fast as the machine allows; null where there is no such
    /// way.
    void (*drawFast)(std::span<const Triangle> triangles, const ScanSettings &settings,
                     FrameView frame)
        = nullptr;
    /// Draws and records. Null when options.progress cancelled it.
    std::unique_ptr<ScanTrace> (*trace)(std::span<const Triangle> triangles,
                                        const ScanSettings &settings, FrameView frame,
                                        const TraceOptions &options);
    /// The formulas of the step with this index.
    Explanation (*explain)(const TracedScene &traced, std::size_t stepIndex);

    bool supports(Arithmetic arithmetic) const;
    bool supports(FillRule rule) const;
    /// Why the method cannot draw under these settings; empty when it can.
    QString refusal(const ScanSettings &settings) const;
};

/// Every method, in the order of the method box and of the keys 1…9.
std::span<const Method> methods();
/// Null when there is no such method.
const Method *methodNamed(QStringView id);

} // namespace pixelplumb
