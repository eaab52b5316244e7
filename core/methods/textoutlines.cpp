// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/textoutlines.h"

#include "core/methods/kernelmethod.h"
#include "core/methods/polygonrecording.h"
#include "core/methods/polygons.h"
#include "core/methods/text.h"

namespace pixelplumb {

namespace {

/// What is scanned of a text.
struct TextContours {
    explicit TextContours(const Shape &text)
    {
        const TextOutlines outlines = outlinesOf(text);
        contours = contoursOf(outlines.polygon);
        rejection = outlines.rejection;
    }

    Contours contours;
    std::optional<PrimitiveRejection> rejection;
};

struct TextKernel : ShapeKernel<PrimitiveKind::Text>, InAnyArithmetic {
    template <class A>
    using Recording = PolygonRecording<A, PolygonForm::Whole>;

    static TextContours geometryOf(const Primitives &primitives, std::size_t index)
    {
        return TextContours(primitives.shape(index));
    }
    static IntegerWidth widthFor(const TextContours &text)
    {
        return integerWidthFor(text.contours.edges);
    }
    template <class A, class Observer>
    static void scan(const TextContours &text, const ScanSettings &, FrameView frame,
                     Observer observer)
    {
        if (!text.rejection) {
            scanPolygon<A>(text.contours, frame, observer);
            return;
        }
        observer.primitiveBegun(polygonSetUpFor(text.contours));
        observer.primitiveRejected(*text.rejection);
    }
};

} // namespace

Method textOutlinesMethod()
{
    Method method = polygonMethod();
    method.id = QStringLiteral("text-outlines");
    method.title = QStringLiteral("Text as outlines");
    method.family = MethodFamily::Others;
    method.source = QStringLiteral("seed 002, slide “Output Primitives”: characters; seed 003, "
                                   "slide “Scan Conversion: A General Algorithm”");
    method.summary = QStringLiteral("Takes the outlines of the glyphs from a font and fills them "
                                    "as one polygon by winding number.");
    method.effects += {QStringLiteral("text"), QStringLiteral("non-zero")};
    method.kinds = {PrimitiveKind::Text};
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.setUpColumns = polygonSetUpColumns(PolygonForm::Whole);
    method.spanColumns = polygonRowColumns(PolygonForm::Whole);
    method.sampleColumns = polygonSampleColumns(PolygonForm::Whole);
    method.draw = drawWith<TextKernel>;
    method.trace = traceWith<TextKernel>;
    return method;
}

} // namespace pixelplumb
