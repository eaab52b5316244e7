// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/textoutlines.h"

#include "core/methods/polygonrecording.h"
#include "core/methods/polygons.h"
#include "core/methods/text.h"
#include "core/methods/witharithmetic.h"

#include <algorithm>

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

template <class A, class Observer>
void scanText(const TextContours &text, FrameView frame, Observer observer)
{
    if (!text.rejection) {
        scanPolygon<A>(text.contours, frame, observer);
        return;
    }
    observer.primitiveBegun(polygonSetUpFor(text.contours));
    observer.primitiveRejected(*text.rejection);
}

void draw(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    for (const Shape &shape : primitives.shapes) {
        if (shape.kind != PrimitiveKind::Text)
            continue;
        const TextContours text(shape);
        withArithmetic(settings.arithmetic, integerWidthFor(text.contours.edges),
                       [&]<class A>() { scanText<A>(text, frame, NullObserver{}); });
    }
}

std::unique_ptr<ScanTrace> trace(const Primitives &primitives, const ScanSettings &settings,
                                 FrameView frame, const TraceOptions &options)
{
    // 128 bits hold every text's outlines, whatever they are.
    return withArithmetic(settings.arithmetic, IntegerWidth::Bits128, [&]<class A>() {
        return recordTrace<PolygonRecording<A, PolygonForm::Whole>>(
            primitives.size(), settings, options,
            [&](std::size_t primitive) {
                return primitives.kindOf(primitive) == PrimitiveKind::Text;
            },
            [&](std::size_t primitive, const auto &recorder) {
                scanText<A>(TextContours(primitives.shape(primitive)), frame, recorder);
            });
    });
}

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
    method.draw = draw;
    method.trace = trace;
    return method;
}

} // namespace pixelplumb
