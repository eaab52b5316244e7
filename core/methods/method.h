// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/run.h"
#include "core/methods/words/pseudocode.h"

#include <QStringList>

#include <span>

namespace pixelplumb {

/// The families under which menus and listings gather the methods.
enum class MethodFamily { Triangles, StableForms, Interpolation, Lines, Curves, Polygons, Others };
QString titleOf(MethodFamily family);

/// One way to turn geometry into pixels: a row of the table of methods.
struct Method {
    QString id; ///< "column-scan"
    QString title; ///< "Column scan"
    MethodFamily family = MethodFamily::Triangles;
    QString source; ///< course text and slide, by the names of resources/sources.md
    QString summary; ///< one sentence
    Pseudocode pseudocode = {}; ///< what the kernel does, line by line
    Pseudocode shadedPseudocode = {}; ///< with effects beyond colour, if the method supports any
    std::vector<Effect> effects = {}; ///< that it supports
    /// The arithmetics in which it supports more than smooth colour and clipping; empty if all.
    std::vector<Arithmetic> shadingArithmetics = {};
    QStringList remarks = {}; ///< what else it does, and what it leaves out: "holes"
    std::vector<PrimitiveKind> kinds = {PrimitiveKind::Triangle}; ///< what it draws
    /// Whether it fills triangles from bound to bound in columns or in rows; Free: neither.
    SpanAxis spanAxis = SpanAxis::Free;
    /// Which closed shapes it draws, by their fill, its own first; empty if all.
    std::vector<ShapeFill> fills = {};
    std::vector<Arithmetic> arithmetics;
    /// The arithmetics in which every picture is the truth, by proof.
    std::vector<Arithmetic> stableArithmetics = {};
    std::vector<FillRule> fillRules;
    /// Why it supports no other fill rules; empty if it supports all.
    QString fillRuleReason = {};
    std::vector<Variant> variants = {}; ///< departures that it accepts
    bool roundsPoints = false; ///< draws from vertices, ends or a centre on whole pixels
    /// For runs that call for nothing but colour; a trace has its own (ScanTrace::numbers).
    TraceNumbers numbers = {};

    bool hasFastKernels = false; ///< untraced pictures come from core/fast
    bool testsEdges = false; ///< and can make the mistakes of a program that does

    /// Behind Run::draw() and Run::trace().
    bool (*draw)(const Run &run, FrameView frame, const ProgressListener &listener);
    std::unique_ptr<ScanTrace> (*trace)(const Run &run, FrameView frame,
                                        const TraceOptions &options);

    bool supports(Arithmetic arithmetic) const;
    bool supports(FillRule rule) const;
    bool supports(Effect effect) const;
    /// Whether it has in this arithmetic all effects that it supports.
    bool shadesIn(Arithmetic arithmetic) const;
    bool supports(Variant variant) const;
    /// Whether it walks between two edges, and so can make the mistakes of such a walk.
    bool walksEdges() const;
    bool draws(PrimitiveKind kind) const;
    bool draws(const Shape &shape) const;
    /// True where every picture under the arithmetic is the truth, by proof, without variants.
    bool isStableIn(Arithmetic arithmetic) const;
    /// Like isStableIn(), for settings, which may have variants.
    bool isStableUnder(const ScanSettings &settings) const
    {
        return settings.isRight() && isStableIn(settings.arithmetic);
    }
    /// Why the method cannot draw under these settings, to be read after its name: "does not
    /// compute in …"; empty when it can.
    QString objection(const ScanSettings &settings) const;
    /// Why it cannot draw triangles with the effects that a plan runs, and which methods can, to be
    /// read after its name. Smooth colour and clipping are no objection: a method that draws in one
    /// colour says so.
    QString objection(const EffectPlan &plan, const ScanSettings &settings) const;
    /// Why it cannot draw a line or curve with the antialiasing that the appearance asks for, and
    /// which methods can under the settings, to be read after its name. Empty for shapes that it
    /// never draws.
    QString objection(const Shape &shape, const Appearance &appearance,
                      const ScanSettings &settings) const;
    /// The objection to settings, after the method's id; empty when it can draw.
    QString refusal(const ScanSettings &settings) const;
    /// The settings, with each choice that the method refuses replaced by its first one.
    ScanSettings adapted(const ScanSettings &settings) const;
};

/// Why a method that fills columns or rows from bound to bound supports no rule that asks on which
/// edge a sample lies.
QString spanRuleReason(SpanAxis axis);

/// Every method, in the order of the method box and of the keys 1…9.
std::span<const Method> methods();
/// Null when there is no such method.
const Method *methodNamed(QStringView id);
/// The first method of the table that draws this kind; every kind has one.
const Method &firstMethodFor(PrimitiveKind kind);
const Method &firstMethodFor(const Shape &shape);
/// The first that draws it with this appearance; if none does, one without antialiasing.
const Method &firstMethodFor(const Shape &shape, const Appearance &appearance);

} // namespace pixelplumb
