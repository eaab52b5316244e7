// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/lines/linerecording.h"
#include "core/methods/polygons/polygonoutlinenumbers.h"

namespace pixelplumb {

inline PolygonOutlineSetUp lineStateOf(const PolygonOutlineSetUp &setUp) { return setUp; }
inline PolygonOutlineState lineStateOf(const PolygonOutlineSetUp &,
                                       const PolygonOutlineStepOf<Int128> &step)
{
    return {lineStateOf(step.line, static_cast<const SymmetricStep &>(step)), step.edge,
            lineStateOf(step.line)};
}

/// Each edge is a part of the polygon, walked column by column or row by row.
struct PolygonOutlineRecording
    : LineStepRecording<ExactArithmetic<Int128>, PolygonOutlineNumbersOf<Int128>> {
    static const NumberTable<PolygonOutlineSetUp> &setUpNumbers()
    {
        static const auto table = polygonOutlineSetUpNumbers();
        return table;
    }
    static const NumberTable<PolygonOutlineState> &spanNumbers()
    {
        static const auto table = polygonOutlineNumbers();
        return table;
    }
    static SpanPlace placeOf(const Span &step)
    {
        SpanPlace place = LineStepRecording::placeOf(step);
        place.part = int(step.edge);
        return place;
    }
};

} // namespace pixelplumb
