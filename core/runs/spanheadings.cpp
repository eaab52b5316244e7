// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/spanheadings.h"

#include "core/trace/namednumbers.h"

#include <algorithm>

namespace pixelplumb {

namespace {

QString placeText(const SpanPlace &place)
{
    switch (place.axis) {
    case SpanAxis::Column:
        return withMinus(
            QStringLiteral(QT_TRANSLATE_NOOP("core", "Column %1")).arg(place.coordinate));
    case SpanAxis::Row:
        return withMinus(QStringLiteral(QT_TRANSLATE_NOOP("core", "Row %1")).arg(place.coordinate));
    case SpanAxis::Free:
        break;
    }
    return QStringLiteral(QT_TRANSLATE_NOOP("core", "Step %1")).arg(place.coordinate);
}

/// The noun by which a span's numbers count the parts of a primitive; empty if none does.
QString countedPart(const ScanTrace &trace)
{
    const auto has = [&trace](const QString &id) { return hasNumber(trace.numbers().span, id); };
    if (has("polygon") && has("triangle"))
        return u"triangle"_s;
    return has("edge") ? u"edge"_s : QString();
}

} // namespace

std::vector<NumberDescription> spanHeadings(const TracedScene &traced)
{
    std::vector<NumberDescription> headings = traced.trace->numbers().span;
    if (traced.trace->spanCount() == 0)
        return headings;
    // Some titles follow the settings, which all spans of a run share.
    const std::vector<NumberDescription> inForce = traced.trace->spanWords(0).numbers;
    for (std::size_t i = 0; i < inForce.size(); ++i) {
        if (inForce[i].title != headings[i].title)
            headings[i] = inForce[i];
    }
    return headings;
}

QString partName(const ScanTrace &trace, std::size_t span)
{
    const int part = trace.placeOf(span).part;
    const QString counted = countedPart(trace);
    return counted.isEmpty() ? QStringLiteral(QT_TRANSLATE_NOOP("core", "part %1")).arg(part + 1)
                             : u"%1 %2"_s.arg(counted).arg(part);
}

QString spanHeading(const ScanTrace &trace, std::size_t span)
{
    const StepWords words = trace.spanWords(span);
    if (!words.heading.isEmpty())
        return words.heading;
    const SpanPlace &place = trace.placeOf(span);
    const bool isNamed = place.part > 0 || !countedPart(trace).isEmpty();
    return isNamed ? placeText(place) + u", "_s + partName(trace, span) : placeText(place);
}

SpanAxis commonAxis(const ScanTrace &trace)
{
    if (trace.spanCount() == 0)
        return SpanAxis::Free;
    const SpanAxis axis = trace.placeOf(0).axis;
    for (std::size_t span = 1; span < trace.spanCount(); ++span) {
        if (trace.placeOf(span).axis != axis)
            return SpanAxis::Free;
    }
    return axis;
}

} // namespace pixelplumb
