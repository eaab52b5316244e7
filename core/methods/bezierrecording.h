// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/flatrecording.h"
#include "core/scan/beziersubdivision.h"

namespace pixelplumb {

struct BezierRecording : BezierNumbers, FlatRecording {
    using FlatRecording::record;

    static SpanPlace placeOf(const Span &step) { return freeStep(step.number); }
    static void record(const SetUp &setUp, SetUpRecord &record)
    {
        record.cells = {Quantity::integer(Int128(setUp.count) - 1),
                        Quantity::rational(1, BezierScan<NullObserver>::flatParts)};
    }
    static void record(const Span &step, SpanRecord &record)
    {
        const BezierPiece &piece = step.piece;
        record.cells = {Quantity::integer(step.number), Quantity::integer(piece.depth),
                        Quantity::rational(step.flatness, 8 * piece.pixel()),
                        Quantity::integer(step.isFlat ? 1 : 0)};
        for (std::size_t i = 0; i < piece.x.size(); ++i) {
            for (const auto &coordinates : {piece.x, piece.y})
                record.cells.push_back(i < piece.count
                                           ? Quantity::rational(coordinates[i], piece.pixel())
                                           : Quantity());
        }
    }
};

} // namespace pixelplumb
