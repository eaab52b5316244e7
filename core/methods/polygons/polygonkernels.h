// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/kernelmethod.h"
#include "core/methods/polygons/polygonoutlinerecording.h"
#include "core/methods/polygons/polygonrecording.h"
#include "core/polygons/curvechords.h"
#include "core/polygons/textoutlines.h"
#include "core/scan/polygons/polygonpieces.h"

/// The kernels of polygons and texts in the form that kernelmethod.h requires.
namespace pixelplumb {

struct FilledPolygonKernel : ShapeKernel<PrimitiveKind::Polygon> {
    static bool draws(const Primitives &primitives, std::size_t index)
    {
        return ShapeKernel::draws(primitives, index)
            && primitives.shape(index).fill != ShapeFill::Outline;
    }
    static Contours geometryOf(const Primitives &primitives, std::size_t index)
    {
        return contoursOf(primitives.shape(index));
    }
};

struct PolygonOutlineKernel : ShapeKernel<PrimitiveKind::Polygon>, InIntegers {
    template <class>
    using Recording = PolygonOutlineRecording;

    static bool draws(const Primitives &primitives, std::size_t index)
    {
        return ShapeKernel::draws(primitives, index)
            && primitives.shape(index).fill == ShapeFill::Outline;
    }
    static Contours geometryOf(const Primitives &primitives, std::size_t index)
    {
        return contoursOf(primitives.shape(index));
    }
    template <class A, class Observer>
    static void scan(const Contours &contours, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        scanPolygonOutline<WideBeside<typename A::Number>>(contours, settings.rounding, frame,
                                                           observer);
    }
};

/// Counts crossings along rows.
struct CrossingsKernel : InAnyArithmetic {
    static IntegerWidth widthFor(const Contours &contours, const FrameView &)
    {
        return integerWidthFor(contours.edges);
    }
    template <class A, class Observer>
    static void scan(const Contours &contours, const ScanSettings &, FrameView frame,
                     Observer observer)
    {
        scanPolygon<A>(contours, frame, observer);
    }
};

struct ParityKernel : FilledPolygonKernel, CrossingsKernel {
    template <class A>
    using Recording = PolygonRecording<A, PolygonForm::Whole>;
};

/// Fills a closed path of curves along its chords.
struct BezierFillKernel : ShapeKernel<PrimitiveKind::Bezier>, CrossingsKernel {
    template <class A>
    using Recording = PolygonRecording<A, PolygonForm::Chords>;

    static bool draws(const Primitives &primitives, std::size_t index)
    {
        return ShapeKernel::draws(primitives, index)
            && primitives.shape(index).fill != ShapeFill::Outline;
    }
    static Contours geometryOf(const Primitives &primitives, std::size_t index)
    {
        const Shape &path = primitives.shape(index);
        Contours contours = contoursOf(chordsOf(path));
        contours.curveCount = pieceCount(path);
        return contours;
    }
};

using Triangulate = Triangulation (*)(const Contours &);

/// A triangulation has as many triangles as the polygon has vertices; 128 bits for all of them cost
/// less than a second code path.
template <Triangulate triangulate, PolygonForm form = PolygonForm::Triangles>
struct TriangulationKernel : FilledPolygonKernel, InIntegers {
    template <class A>
    using Recording = PolygonRecording<A, form>;

    template <class A, class Observer>
    static void scan(const Contours &contours, const ScanSettings &, FrameView frame,
                     Observer observer)
    {
        scanTriangles<A>(contours, triangulate(contours), frame, observer);
    }
};

using TessellationKernel = TriangulationKernel<tessellationOf, PolygonForm::CrossingTriangles>;

struct TextKernel : ShapeKernel<PrimitiveKind::Text>, InAnyArithmetic {
    template <class A>
    using Recording = PolygonRecording<A, PolygonForm::Whole>;

    using Outlines = std::shared_ptr<const TextOutlines>;

    static Outlines geometryOf(const Primitives &primitives, std::size_t index)
    {
        return sharedOutlinesOf(primitives.shape(index));
    }
    static IntegerWidth widthFor(const Outlines &text, const FrameView &)
    {
        return integerWidthFor(text->contours.edges);
    }
    template <class A, class Observer>
    static void scan(const Outlines &text, const ScanSettings &, FrameView frame, Observer observer)
    {
        if (!text->rejection) {
            scanPolygon<A>(text->contours, frame, observer, {text, &text->contours.edges});
            return;
        }
        observer.primitiveBegun(polygonSetUpFor(text->contours, frame.origin));
        observer.primitiveRejected(*text->rejection);
    }
};

} // namespace pixelplumb
