// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/formulaexplanation.h"

#include "core/methods/words/formulatext.h"
#include "core/methods/words/rejectiontext.h"
#include "core/runs/explain/byteexplanation.h"
#include "core/runs/explain/formulanames.h"
#include "core/runs/explain/projectionstages.h"
#include "core/runs/explain/refusaltext.h"
#include "core/runs/explain/rejectedprimitives.h"
#include "core/runs/explain/segmenttext.h"
#include "core/runs/explain/setupsentence.h"
#include "core/runs/spanheadings.h"
#include "core/runs/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// One line for each number that has a formula.
void appendLines(Explanation &explanation, const std::vector<NumberDescription> &columns,
                 const std::vector<Quantity> &used, const std::vector<Quantity> &exact,
                 const FormulaNames &names, FormulaStart start)
{
    for (std::size_t i = 0; i < columns.size() && i < used.size(); ++i) {
        const NumberDescription &number = columns[i];
        FormulaLine line;
        line.symbols = formulaInForce(number, used[i], start);
        if (line.symbols.isEmpty())
            continue;
        line.subject = number.subject;
        line.substituted = names.substituted(line.symbols, number.title, placesOfOperands(used[i]));
        line.used = used[i];
        if (i < exact.size())
            line.exact = exact[i];
        explanation.lines.push_back(line);
    }
}

QString primitiveText(const TracedScene &traced, std::size_t primitive)
{
    const QString kind = nameOf(traced.primitives.kindOf(primitive));
    return kind.left(1).toUpper() + kind.sliced(1) + u" %1"_s.arg(primitive);
}

Explanation explainBeginning(const TracedScene &traced, std::size_t primitive)
{
    const SetUpRecord setUp = traced.trace->setUp(primitive);
    Explanation explanation;
    explanation.heading = u"%1: set-up"_s.arg(primitiveText(traced, primitive));
    explanation.stages = stageFormulas(traced, primitive);
    const auto rejection = rejectionOf(traced, primitive);
    const QString rejected = rejection ? u' ' + rejectionText(*rejection) : QString();
    if (setUp.rejection) {
        explanation.sentence = setUpSentence(traced, primitive, {}) + rejected;
        return explanation;
    }
    const StepWords words = traced.trace->setUpWords(primitive);
    explanation.sentence = setUpSentence(traced, primitive, words.sentence) + rejected;
    FormulaNames names;
    names.add(words.numbers, setUp.cells);
    appendLines(explanation, words.numbers, setUp.cells, exactSetUpCells(traced, primitive), names,
                FormulaStart::Fresh);
    return explanation;
}

/// `visited`: the span's samples that the kernel visited; `antialiasing`: the triangle's.
QString spanSentence(const SpanRecord &span, std::size_t visited, FillRule rule,
                     Antialiasing antialiasing)
{
    const QString others = span.place.axis == SpanAxis::Column ? u"rows"_s : u"columns"_s;
    // Antialiasing has samples besides the pixels' centres, and the bounds may lie between them.
    if (span.drawnSamples() == 0)
        return visited == 0
            ? (rule == FillRule::Closed ? u"No sample of the frame lies here."_s
                                        : u"The fill rule takes no sample of the frame here."_s)
            : u"No pixel's centre lies here, but other samples of %1 may."_s.arg(
                visited == 1 ? u"1 pixel"_s : u"%1 pixels"_s.arg(visited));
    const QString range = span.drawnSamples() == 1
        ? u"%1 %2"_s.arg(others.chopped(1)).arg(span.firstDrawn)
        : u"%1 %2 to %3"_s.arg(others).arg(span.firstDrawn).arg(span.endDrawn - 1);
    if (span.lower.isNone())
        return span.drawnSamples() == 1
            ? u"The sample on the %1 is tested."_s.arg(range)
            : u"The samples on the %1 are tested one by one."_s.arg(range);
    const QString pattern = antialiasing == Antialiasing::None
        ? u"The bounds %1 and %2 cover the %3."_s
        : antialiasing == Antialiasing::Area
        ? u"At the pixels' centres the bounds are %1 and %2; the area that the "
          "triangle covers is computed on the %3."_s
        : u"The bounds %1 and %2 cover the pixel centres of the %3; other samples "
          "next to them may lie in the triangle."_s;
    return pattern.arg(term(span.lower), term(span.upper), range);
}

/// A span with the previous one of the same primitive.
struct SpanPair {
    SpanPair(const ScanTrace &trace, std::size_t index)
        : current(trace.span(index))
        , words(trace.spanWords(index))
    {
        if (index > trace.firstSpanOf(current.primitive))
            previous = trace.span(index - 1);
    }

    SpanRecord current;
    StepWords words;
    std::optional<SpanRecord> previous;
};

FormulaNames spanNames(const TracedScene &traced, const SpanPair &spans)
{
    FormulaNames names;
    const std::size_t primitive = spans.current.primitive;
    names.add(traced.trace->numbers().setUp, traced.trace->setUp(primitive).cells);
    names.add(spans.words.numbers, spans.current.cells,
              spans.previous ? &spans.previous->cells : nullptr);
    return names;
}

Explanation explainSpan(const TracedScene &traced, const TraceStep &step)
{
    const SpanPair spans(*traced.trace, step.span);
    Explanation explanation;
    explanation.heading = spanHeading(*traced.trace, step.span);
    explanation.event = spans.words.event;
    const std::size_t visited
        = traced.trace->endSampleOf(step.span) - traced.trace->firstSampleOf(step.span);
    explanation.sentence = spans.words.sentence.isEmpty()
        ? spanSentence(spans.current, visited, traced.scene.settings.fillRule,
                       traced.primitives.kindOf(spans.current.primitive) == PrimitiveKind::Triangle
                           ? traced.antialiasing()
                           : Antialiasing::None)
        : spans.words.sentence;
    appendLines(explanation, spans.words.numbers, spans.current.cells,
                exactSpanCells(traced, step.span), spanNames(traced, spans),
                startOfSpan(*traced.trace, step.span));
    return explanation;
}

/// A sample's numbers that no formula computes or names, if effects ran: u as it would be without
/// perspective, how many of the pixel's samples were written.
void appendGiven(Explanation &explanation, const std::vector<NumberDescription> &columns,
                 const std::vector<Quantity> &used)
{
    for (std::size_t i = 0; i < columns.size() && i < used.size(); ++i) {
        const QString &title = columns[i].title;
        const bool isTold = std::ranges::any_of(columns, [&title](const NumberDescription &other) {
            return other.formula.contains(title);
        });
        if (!used[i].isNone() && columns[i].formula.isEmpty() && !isTold)
            explanation.lines.push_back({columns[i].subject, title, {}, used[i], {}});
    }
}

/// Whether it covers samples; the pixels of other kinds are chosen step by step along them.
bool isCovering(PrimitiveKind kind)
{
    return kind == PrimitiveKind::Triangle || kind == PrimitiveKind::Polygon
        || kind == PrimitiveKind::Text;
}

QString writtenSentence(const TracedScene &traced, std::size_t primitive,
                        const SampleRecord &sample)
{
    if (!isCovering(traced.primitives.kindOf(primitive)))
        return u"The pixel belongs to this step and is written."_s;
    if (traced.trace->setUp(primitive).zeroArea)
        return u"The sample is drawn: the triangle has no area, and %1."_s.arg(
            segmentText(traced.primitives.triangles[primitive], sample.x, sample.y));
    return u"The sample is drawn."_s;
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
    const SpanPair spans(trace, step.span);
    const StepWords words = trace.sampleWords(step.span, place);
    const FormulaNames ofSpan = spanNames(traced, spans);
    FormulaNames names = ofSpan;
    names.add("x", Quantity::integer(sample.x));
    names.add("y", Quantity::integer(sample.y));
    // The step of a line or a circle is its one sample: the numbers are in the span.
    const bool isStep = traced.trace->numbers().sample.empty() && samples.size() == 1;
    for (std::size_t channel = 0; channel < 3 && !isStep; ++channel)
        names.add(QString(channelLetters[channel]), sample.colour[channel],
                  place > 0 ? std::optional(samples[place - 1].colour[channel]) : std::nullopt);
    names.add(words.numbers, sample.cells, place > 0 ? &samples[place - 1].cells : nullptr);

    explanation.heading
        = (isWritten ? QStringLiteral(QT_TRANSLATE_NOOP("core", "Pixel (%1, %2)"))
                     : QStringLiteral(QT_TRANSLATE_NOOP("core", "Sample (%1, %2), refused")))
              .arg(sample.x)
              .arg(sample.y);
    explanation.sentence = words.sentence;
    if (words.sentence.isEmpty())
        explanation.sentence = isWritten
            ? writtenSentence(traced, step.primitive, sample)
            : refusalSentence(traced, step.primitive, sample, decisionsOf(words.numbers, sample));
    if (sample.clamped)
        explanation.sentence += u" A level left 0 … 255 and is clamped."_s;
    if (isStep)
        appendLines(explanation, spans.words.numbers, spans.current.cells,
                    exactSpanCells(traced, step.span), ofSpan, startOfSpan(trace, step.span));
    const ExactSample exact = exactSamplesOf(traced, step.span, {&sample, 1}).front();
    appendLines(explanation, words.numbers, sample.cells, exact.cells, names, startOfSample(place));
    if (traced.shading())
        appendGiven(explanation, words.numbers, sample.cells);
    if (isWritten)
        appendBytes(explanation, traced,
                    {words.numbers, sample, exact, trace.changes()[step.sample].after});
    return explanation;
}

Explanation explained(const TracedScene &traced, const TraceStep &step)
{
    switch (step.kind) {
    case StepKind::SetUp:
        return explainBeginning(traced, step.primitive);
    case StepKind::Span:
        return explainSpan(traced, step);
    case StepKind::Sample:
        return explainSample(traced, step);
    }
    return {};
}

} // namespace

FormulaStart startOfSpan(const ScanTrace &trace, std::size_t span)
{
    return trace.beginsPart(span) ? FormulaStart::Fresh : FormulaStart::Continued;
}

QString formulaInForce(const NumberDescription &number, const Quantity &used, FormulaStart start)
{
    if (number.formula.isEmpty() || used.isNone())
        return {};
    return start == FormulaStart::Fresh && !number.startFormula.isEmpty() ? number.startFormula
                                                                          : number.formula;
}

Explanation explainStep(const TracedScene &traced, std::size_t stepIndex)
{
    Explanation explanation = explained(traced, traced.trace->stepAt(stepIndex));
    for (QString *text : {&explanation.heading, &explanation.sentence, &explanation.event})
        *text = withMinus(*text);
    return explanation;
}

} // namespace pixelplumb
