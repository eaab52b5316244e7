// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/methods/explanation.h"
#include "core/methods/tracecolumn.h"
#include "core/trace/tracerecorder.h"

#include <QStringList>

#include <memory>
#include <span>

namespace pixelplumb {

struct TracedScene;

/// The families under which menus and listings gather the methods.
enum class MethodFamily { Triangles, StableForms, Interpolation, Lines, Curves, Polygons, Others };
QString titleOf(MethodFamily family);

/// One way to turn geometry into pixels: a row of the table of methods.
struct Method {
    QString id; ///< "column-scan"
    QString title; ///< "Column scan"
    MethodFamily family = MethodFamily::Triangles;
    QString source; ///< seed and slide
    QString summary; ///< one sentence
    QStringList effects; ///< what it meets: "smooth colour"
    std::vector<PrimitiveKind> kinds = {PrimitiveKind::Triangle}; ///< what it draws
    /// Of circles and ellipses: which of them, by their fill; empty when it draws all.
    std::vector<ShapeFill> fills = {};
    std::vector<Arithmetic> arithmetics;
    /// Those of its arithmetics in which every picture is the truth, by proof.
    std::vector<Arithmetic> stableArithmetics = {};
    std::vector<FillRule> fillRules;
    /// Why it keeps no other fill rules; empty when it keeps all four.
    QString fillRuleReason = {};
    std::vector<TraceColumn> setUpColumns = {}; ///< what SetUpRecord::cells are
    std::vector<TraceColumn> spanColumns = {}; ///< what SpanRecord::cells are: the table's columns
    std::vector<TraceColumn> sampleColumns = {}; ///< what SampleRecord::cells are

    /// Draws the primitives of its kinds (sample coordinates) in order.
    void (*draw)(const Primitives &primitives, const ScanSettings &settings, FrameView frame);
    /// The same picture, bit for bit, as fast as the machine allows; null where there is no such
    /// way.
    void (*drawFast)(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
        = nullptr;
    /// Draws and records. Null when options.progress cancelled it.
    std::unique_ptr<ScanTrace> (*trace)(const Primitives &primitives, const ScanSettings &settings,
                                        FrameView frame, const TraceOptions &options);
    /// The exact numbers for which a span's cells stand, in the same order, none where there is
    /// nothing to compare. Null: those of the method's own run in exact arithmetic.
    std::vector<Quantity> (*exactSpan)(const TracedScene &traced, std::size_t span) = nullptr;
    /// The formulas of the step with this index. Null: as the columns describe them.
    Explanation (*explain)(const TracedScene &traced, std::size_t stepIndex) = nullptr;

    /// The picture, by drawFast where there is one.
    void drawFastest(const Primitives &primitives, const ScanSettings &settings,
                     FrameView frame) const
    {
        (drawFast ? drawFast : draw)(primitives, settings, frame);
    }
    bool supports(Arithmetic arithmetic) const;
    bool supports(FillRule rule) const;
    bool draws(PrimitiveKind kind) const;
    bool draws(const Shape &shape) const;
    /// True where every picture under the arithmetic is the truth, by proof.
    bool isStableIn(Arithmetic arithmetic) const;
    /// Why the method cannot draw under these settings; empty when it can.
    QString refusal(const ScanSettings &settings) const;
    /// The settings with what the method refuses replaced by its first choice.
    ScanSettings adapted(const ScanSettings &settings) const;
};

/// Every method, in the order of the method box and of the keys 1…9.
std::span<const Method> methods();
/// Null when there is no such method.
const Method *methodNamed(QStringView id);
/// The first method of the table that draws this kind; every kind has one.
const Method &firstMethodFor(PrimitiveKind kind);
const Method &firstMethodFor(const Shape &shape);

} // namespace pixelplumb
