// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formulaexplanation.h"

#include "core/methods/formulanames.h"
#include "core/methods/formulatext.h"
#include "core/methods/rejectiontext.h"
#include "core/oracle/oracle.h"
#include "core/trace/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::array channelSubjects
    = {FormulaSubject::Red, FormulaSubject::Green, FormulaSubject::Blue};
constexpr std::size_t namedVertices = 8;

/// Whether there is an earlier step from which a formula goes on.
enum class FormulaStart { Fresh, Continued };

/// The channel whose letter stands in a colour's title.
FormulaSubject subjectOf(const TraceColumn &column)
{
    using Group = TraceColumnGroup;
    if (column.group != Group::EdgeColours && column.group != Group::ColourRates
        && column.group != Group::FirstColour)
        return FormulaSubject::General;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        if (column.title.contains(channelLetters[channel]))
            return channelSubjects[channel];
    }
    return FormulaSubject::General;
}

/// One line for each column that has a formula.
void appendLines(Explanation &explanation, const std::vector<TraceColumn> &columns,
                 const std::vector<Quantity> &used, const std::vector<Quantity> &exact,
                 const FormulaNames &names, FormulaStart start)
{
    for (std::size_t i = 0; i < columns.size() && i < used.size(); ++i) {
        const TraceColumn &column = columns[i];
        if (column.formula.isEmpty() || used[i].isNone())
            continue;
        FormulaLine line;
        line.subject = subjectOf(column);
        line.symbols = start == FormulaStart::Fresh && !column.startFormula.isEmpty()
            ? column.startFormula
            : column.formula;
        line.substituted = names.substituted(line.symbols);
        line.used = used[i];
        if (i < exact.size())
            line.exact = exact[i];
        explanation.lines.push_back(line);
    }
}

QString primitiveText(const TracedScene &traced, std::size_t primitive)
{
    const QString kind = nameOf(traced.primitives.kindOf(primitive));
    return kind.left(1).toUpper() + kind.sliced(1) + QStringLiteral(" %1").arg(primitive);
}

QString verticesText(const TracedScene &traced, std::size_t primitive)
{
    std::vector<Vertex> vertices;
    if (traced.primitives.isTriangle(primitive)) {
        const auto order = traced.trace->setUp(primitive).order;
        for (const int index : order)
            vertices.push_back(traced.primitives.triangles[primitive].vertices[std::size_t(index)]);
    } else {
        vertices = traced.primitives.shape(primitive).vertices;
    }
    QStringList points;
    for (std::size_t i = 0; i < std::min(vertices.size(), namedVertices); ++i)
        points.append(QStringLiteral("P%1 = %2").arg(i).arg(pointText(vertices[i].position)));
    if (vertices.size() > namedVertices)
        points.append(QStringLiteral("… %1 in all").arg(vertices.size()));
    return points.join(QStringLiteral(", ")) + u'.';
}

Explanation explainSetUp(const TracedScene &traced, std::size_t primitive)
{
    const SetUpRecord setUp = traced.trace->setUp(primitive);
    Explanation explanation;
    explanation.heading = QStringLiteral("%1: set-up").arg(primitiveText(traced, primitive));
    explanation.sentence = verticesText(traced, primitive);
    if (setUp.rejection) {
        explanation.sentence += u' ' + rejectionText(*setUp.rejection);
        return explanation;
    }
    FormulaNames names;
    names.add(traced.method->setUpColumns, setUp.cells);
    appendLines(explanation, traced.method->setUpColumns, setUp.cells, {}, names,
                FormulaStart::Fresh);
    return explanation;
}

QString placeText(const SpanPlace &place)
{
    switch (place.axis) {
    case SpanAxis::Column:
        return QStringLiteral("Column %1").arg(place.coordinate);
    case SpanAxis::Row:
        return QStringLiteral("Row %1").arg(place.coordinate);
    case SpanAxis::Free:
        break;
    }
    return QStringLiteral("Step %1").arg(place.coordinate);
}

QString spanSentence(const SpanRecord &span)
{
    if (span.place.axis == SpanAxis::Free)
        return QStringLiteral("One step of the method.");
    const QString others
        = span.place.axis == SpanAxis::Column ? QStringLiteral("rows") : QStringLiteral("columns");
    if (span.drawnSamples() == 0)
        return QStringLiteral("No sample of the frame lies here.");
    const QString range
        = QStringLiteral("%1 %2 to %3").arg(others).arg(span.firstDrawn).arg(span.endDrawn - 1);
    if (span.lower.isNone())
        return QStringLiteral("The samples on the %1 are tested one by one.").arg(range);
    return QStringLiteral("The bounds %1 and %2 cover the %3.")
        .arg(term(span.lower), term(span.upper), range);
}

/// The span before this one in the same part of the primitive.
std::optional<SpanRecord> previousSpan(const ScanTrace &trace, std::size_t span)
{
    if (span == trace.firstSpanOf(trace.primitiveOf(span))
        || trace.placeOf(span - 1).part != trace.placeOf(span).part)
        return std::nullopt;
    return trace.span(span - 1);
}

FormulaNames spanNames(const TracedScene &traced, const SpanRecord &span,
                       const std::optional<SpanRecord> &previous)
{
    FormulaNames names;
    names.add(traced.method->setUpColumns, traced.trace->setUp(span.primitive).cells);
    names.add(traced.method->spanColumns, span.cells, previous ? &previous->cells : nullptr);
    return names;
}

Explanation explainSpan(const TracedScene &traced, const TraceStep &step)
{
    const ScanTrace &trace = *traced.trace;
    const SpanRecord span = trace.span(step.span);
    const std::optional<SpanRecord> previous = previousSpan(trace, step.span);
    const FormulaNames names = spanNames(traced, span, previous);
    Explanation explanation;
    explanation.heading = placeText(span.place);
    if (span.place.part > 0)
        explanation.heading += QStringLiteral(", part %1").arg(span.place.part + 1);
    explanation.isHalfChange = span.place.part > 0 && !previous;
    explanation.sentence = spanSentence(span);
    appendLines(explanation, traced.method->spanColumns, span.cells,
                exactSpanCells(traced, step.span), names,
                previous ? FormulaStart::Continued : FormulaStart::Fresh);
    return explanation;
}

/// Which tests keep a sample out.
QString refusalSentence(const std::vector<TraceColumn> &columns, const SampleRecord &sample)
{
    QStringList failed;
    for (std::size_t i = 0; i < columns.size() && i < sample.cells.size(); ++i) {
        if (columns[i].group == TraceColumnGroup::Decision && !sample.cells[i].isNone()
            && sample.cells[i].toDouble() < 0)
            failed.append(QStringLiteral("%1 = %2").arg(columns[i].title, term(sample.cells[i])));
    }
    if (failed.isEmpty())
        return QStringLiteral("Refused: no test is negative, but the fill rule gives this sample "
                              "to the other side.");
    return QStringLiteral("Refused: %1 %2 negative.")
        .arg(failed.join(QStringLiteral(", ")),
             failed.size() == 1 ? QStringLiteral("is") : QStringLiteral("are"));
}

/// The bytes of a written sample, and its levels where no column describes them.
void appendBytes(Explanation &explanation, const TracedScene &traced, const TraceStep &step,
                 const SampleRecord &sample, const ExactSample &exact)
{
    const ByteRounding rounding = traced.scene.settings.rounding;
    const bool nearest = rounding == ByteRounding::Nearest;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        if (sample.colour[channel].isNone())
            continue;
        const QString name = channelLetters[channel];
        FormulaLine byte;
        byte.subject = channelSubjects[channel];
        byte.symbols = (nearest ? QStringLiteral("byte = ⌊%1 + ½⌋") : QStringLiteral("byte = ⌊%1⌋"))
                           .arg(name);
        byte.substituted = (nearest ? QStringLiteral("⌊%1 + ½⌋") : QStringLiteral("⌊%1⌋"))
                               .arg(term(sample.colour[channel]));
        byte.used = Quantity::integer(std::clamp<std::int64_t>(sample.level[channel], 0, 255));
        if (!exact.colour[channel].isNone())
            byte.exact = Quantity::integer(
                oracle::byteColourAt(traced.primitives.triangles[step.primitive], sample.x,
                                     sample.y, rounding)
                    .channels[channel]);
        explanation.lines.push_back(byte);
    }
}

Explanation explainSample(const TracedScene &traced, const TraceStep &step)
{
    const ScanTrace &trace = *traced.trace;
    const std::vector<SampleRecord> samples = trace.samples(step.span);
    const std::size_t place = step.sample - trace.firstSampleOf(step.span);
    Explanation explanation;
    if (place >= samples.size())
        return explanation;
    const SampleRecord &sample = samples[place];
    const bool isWritten = sample.fate == SampleFate::Written;
    const SpanRecord span = trace.span(step.span);
    FormulaNames names = spanNames(traced, span, previousSpan(trace, step.span));
    names.add(QStringLiteral("x"), Quantity::integer(sample.x));
    names.add(QStringLiteral("y"), Quantity::integer(sample.y));
    for (std::size_t channel = 0; channel < 3; ++channel)
        names.add(QString(channelLetters[channel]), sample.colour[channel],
                  place > 0 ? std::optional(samples[place - 1].colour[channel]) : std::nullopt);
    names.add(traced.method->sampleColumns, sample.cells,
              place > 0 ? &samples[place - 1].cells : nullptr);

    explanation.heading = (isWritten ? QStringLiteral("Pixel (%1, %2)")
                                     : QStringLiteral("Sample (%1, %2), refused"))
                              .arg(sample.x)
                              .arg(sample.y);
    explanation.sentence = isWritten ? QStringLiteral("The sample is covered and written.")
                                     : refusalSentence(traced.method->sampleColumns, sample);
    if (sample.clamped)
        explanation.sentence += QStringLiteral(" A level left 0 … 255 and is clamped.");
    // A span of one sample, the step of a line, has its decision in the span.
    if (samples.size() == 1)
        appendLines(explanation, traced.method->spanColumns, span.cells,
                    exactSpanCells(traced, step.span), names,
                    previousSpan(trace, step.span) ? FormulaStart::Continued : FormulaStart::Fresh);
    const ExactSample exact = exactSampleOf(traced, step.span, sample);
    appendLines(explanation, traced.method->sampleColumns, sample.cells, exact.cells, names,
                place == 0 ? FormulaStart::Fresh : FormulaStart::Continued);
    if (isWritten)
        appendBytes(explanation, traced, step, sample, exact);
    return explanation;
}

} // namespace

Explanation explainByFormulas(const TracedScene &traced, std::size_t stepIndex)
{
    const TraceStep step = traced.trace->stepAt(stepIndex);
    switch (step.kind) {
    case StepKind::SetUp:
        return explainSetUp(traced, step.primitive);
    case StepKind::Span:
        return explainSpan(traced, step);
    case StepKind::Sample:
        return explainSample(traced, step);
    }
    return {};
}

Explanation explainStep(const TracedScene &traced, std::size_t stepIndex)
{
    return traced.method->explain ? traced.method->explain(traced, stepIndex)
                                  : explainByFormulas(traced, stepIndex);
}

} // namespace pixelplumb
