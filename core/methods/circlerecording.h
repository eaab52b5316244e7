// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/flatrecording.h"
#include "core/scan/circleexplicit.h"
#include "core/scan/circlefill.h"
#include "core/scan/circlemidpoint.h"
#include "core/scan/circleparametric.h"

namespace pixelplumb {

/// The centre and the radii: what all methods of circles begin with.
struct RoundRecording : FlatRecording {
    static void recordRound(const Round &round, SetUpRecord &record)
    {
        record.cells
            = {px(round.centre.x), px(round.centre.y), px(round.radiusX), px(round.radiusY)};
    }
};

struct CircleFillRecording : CircleFillNumbers, RoundRecording {
    using FlatRecording::record;

    static SpanPlace placeOf(const Span &row) { return {SpanAxis::Row, row.y, 0}; }
    static void record(const Round &round, SetUpRecord &record) { recordRound(round, record); }
    static void record(const Span &row, SpanRecord &record)
    {
        record.lower = px(row.left);
        record.upper = px(row.right);
        record.firstSample = row.firstSample;
        record.endSample = row.endSample;
        record.firstDrawn = row.firstDrawn;
        record.endDrawn = row.endDrawn;
        record.cells = {Quantity::integer(row.y), record.lower, record.upper,
                        Quantity::integer(row.firstSample), Quantity::integer(row.endSample - 1)};
    }
    template <class Observer>
    static void walk(const Round &, const Span &row, const ScanSettings &, Observer observer)
    {
        const std::int64_t width = row.endDrawn - row.firstDrawn;
        if (width <= 0)
            return;
        std::vector<QRgb> pixels(std::size_t(width), QRgb(0));
        fillRow(row,
                FrameView{pixels.data(), width, std::int32_t(row.firstDrawn), std::int32_t(row.y),
                          std::int32_t(width), 1},
                observer);
    }
};

template <class A>
struct CircleExplicitRecording : CircleExplicitNumbers<A>, RoundRecording {
    using Span = CircleExplicitStep<A>;
    using FlatRecording::record;

    static SpanPlace placeOf(const Span &step) { return freeStep(step.number); }
    static void record(const Round &round, SetUpRecord &record) { recordRound(round, record); }
    static void record(const Span &step, SpanRecord &record)
    {
        record.cells = {Quantity::integer(step.x), px(step.distance), rootOf(step.root),
                        Quantity::integer(step.above), Quantity::integer(step.below)};
    }

private:
    static Quantity rootOf(Lattice root) { return px(root); }
    template <std::floating_point Float>
    static Quantity rootOf(Float root)
    {
        return Quantity::of(root);
    }
};

template <class Float>
struct CircleParametricRecording : CircleParametricNumbers<Float>, RoundRecording {
    using FlatRecording::record;

    static SpanPlace placeOf(const CircleParametricStep<Float> &step)
    {
        return freeStep(step.number);
    }
    static void record(const CircleParametricSetUp<Float> &setUp, SetUpRecord &record)
    {
        recordRound(setUp.round, record);
        record.cells.push_back(Quantity::of(setUp.angleStep));
    }
    static void record(const CircleParametricStep<Float> &step, SpanRecord &record)
    {
        record.cells = {Quantity::integer(step.number), Quantity::of(step.angle),
                        Quantity::of(step.curveX),      Quantity::of(step.curveY),
                        Quantity::integer(step.x),      Quantity::integer(step.y)};
    }
};

struct MidpointRecording : MidpointNumbers, FlatRecording {
    using FlatRecording::record;

    static SpanPlace placeOf(const Span &step) { return freeStep(step.x, step.arc); }
    static void record(const MidpointSetUp &setUp, SetUpRecord &record)
    {
        record.cells = {Quantity::integer(setUp.centre.x), Quantity::integer(setUp.centre.y),
                        Quantity::integer(setUp.radiusX), Quantity::integer(setUp.radiusY)};
    }
    static void record(const Span &step, SpanRecord &record)
    {
        const auto decision = [&](Int128 number, bool exists) {
            return exists ? Quantity::rational(number, step.decisionUnit) : Quantity();
        };
        record.cells = {Quantity::integer(step.arc + 1),
                        decision(step.decision, step.hasDecision),
                        Quantity::integer(step.x),
                        Quantity::integer(step.y),
                        decision(step.nextDecision - step.decision, step.hasDecision),
                        decision(step.nextDecision, true)};
    }
};

} // namespace pixelplumb
