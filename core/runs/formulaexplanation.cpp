// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/formulaexplanation.h"

#include "core/methods/formulatext.h"
#include "core/methods/rejectiontext.h"
#include "core/oracle/oracle.h"
#include "core/runs/formulanames.h"
#include "core/runs/projectionstages.h"
#include "core/runs/refusaltext.h"
#include "core/runs/setupsentence.h"
#include "core/runs/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::array channelSubjects
    = {NumberSubject::Red, NumberSubject::Green, NumberSubject::Blue};

/// Whether there is an earlier step from which a formula goes on.
enum class FormulaStart { Fresh, Continued };

/// One line for each number that has a formula.
void appendLines(Explanation &explanation, const std::vector<NumberDescription> &columns,
                 const std::vector<Quantity> &used, const std::vector<Quantity> &exact,
                 const FormulaNames &names, FormulaStart start)
{
    for (std::size_t i = 0; i < columns.size() && i < used.size(); ++i) {
        const NumberDescription &number = columns[i];
        if (number.formula.isEmpty() || used[i].isNone())
            continue;
        FormulaLine line;
        line.subject = number.subject;
        line.symbols = start == FormulaStart::Fresh && !number.startFormula.isEmpty()
            ? number.startFormula
            : number.formula;
        line.substituted = names.substituted(line.symbols, number.title);
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

Explanation explainBeginning(const TracedScene &traced, std::size_t primitive)
{
    const SetUpRecord setUp = traced.trace->setUp(primitive);
    Explanation explanation;
    explanation.heading = QStringLiteral("%1: set-up").arg(primitiveText(traced, primitive));
    explanation.stages = stageFormulas(traced, primitive);
    if (setUp.rejection) {
        explanation.sentence
            = setUpSentence(traced, primitive, {}) + u' ' + rejectionText(*setUp.rejection);
        return explanation;
    }
    const StepWords words = traced.trace->setUpWords(primitive);
    explanation.sentence = setUpSentence(traced, primitive, words.sentence);
    FormulaNames names;
    names.add(words.numbers, setUp.cells);
    appendLines(explanation, words.numbers, setUp.cells, exactSetUpCells(traced, primitive), names,
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
    const QString others
        = span.place.axis == SpanAxis::Column ? QStringLiteral("rows") : QStringLiteral("columns");
    if (span.drawnSamples() == 0)
        return QStringLiteral("No sample of the frame lies here.");
    const QString range = span.drawnSamples() == 1
        ? QStringLiteral("%1 %2").arg(others.chopped(1)).arg(span.firstDrawn)
        : QStringLiteral("%1 %2 to %3").arg(others).arg(span.firstDrawn).arg(span.endDrawn - 1);
    if (span.lower.isNone())
        return span.drawnSamples() == 1
            ? QStringLiteral("The sample on the %1 is tested.").arg(range)
            : QStringLiteral("The samples on the %1 are tested one by one.").arg(range);
    return QStringLiteral("The bounds %1 and %2 cover the %3.")
        .arg(term(span.lower), term(span.upper), range);
}

/// A span with the one before it on the same primitive.
struct SpanPair {
    SpanPair(const ScanTrace &trace, std::size_t index)
        : current(trace.span(index))
        , words(trace.spanWords(index))
    {
        if (index > trace.firstSpanOf(current.primitive))
            previous = trace.span(index - 1);
    }

    /// Formulas start afresh in each part of a primitive.
    FormulaStart start() const
    {
        return previous && previous->place.part == current.place.part ? FormulaStart::Continued
                                                                      : FormulaStart::Fresh;
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
    explanation.sentence
        = spans.words.sentence.isEmpty() ? spanSentence(spans.current) : spans.words.sentence;
    appendLines(explanation, spans.words.numbers, spans.current.cells,
                exactSpanCells(traced, step.span), spanNames(traced, spans), spans.start());
    return explanation;
}

std::vector<SampleDecision> decisionsOf(const std::vector<NumberDescription> &columns,
                                        const SampleRecord &sample)
{
    std::vector<SampleDecision> decisions;
    for (std::size_t i = 0; i < columns.size() && i < sample.cells.size(); ++i) {
        if (columns[i].group == NumberGroup::Decision)
            decisions.push_back({columns[i].title, sample.cells[i]});
    }
    return decisions;
}

/// "⌊R + ½⌋", with the clamp where it was needed; % stands for the level.
QString byteFormula(ByteRounding rounding, std::int64_t level)
{
    const QString rounded
        = rounding == ByteRounding::Nearest ? QStringLiteral("⌊% + ½⌋") : QStringLiteral("⌊%⌋");
    if (level < 0)
        return QStringLiteral("max(0, ") + rounded + u')';
    return level > 255 ? QStringLiteral("min(255, ") + rounded + u')' : rounded;
}

/// The byte of an exact level.
Quantity byteOf(const Quantity &level, ByteRounding rounding)
{
    const CommonFraction exact{level.numerator(), level.denominator()};
    const Int128 byte = rounding == ByteRounding::Nearest ? exact.nearest() : exact.floor();
    return Quantity::integer(std::clamp<Int128>(byte, 0, 255));
}

/// What a sample has on which effects were done and no formula tells or names: u as it would be
/// without perspective, how many of the pixel's samples were written.
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

/// What the last stage of a sample's effects made of the colour: "r", "s", "mod"; empty where none
/// did anything to it.
QString lastStage(const std::vector<NumberDescription> &columns, const std::vector<Quantity> &used)
{
    for (const QString &stage : {QStringLiteral("mean"), QStringLiteral("r"), QStringLiteral("s"),
                                 QStringLiteral("mod")}) {
        const auto column
            = std::ranges::find(columns, stage + QStringLiteral("_R"), &NumberDescription::title);
        const auto place = std::size_t(column - columns.begin());
        if (place < used.size() && !used[place].isNone())
            return stage;
    }
    return {};
}

/// The bytes that stand in the pixel: those of the last stage.
void appendBytesOf(Explanation &explanation, const QString &stage, QRgb pixel)
{
    const Colour colour = unpacked(pixel);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Quantity byte = Quantity::integer(colour.channels[channel]);
        explanation.lines.push_back(
            {channelSubjects[channel],
             QStringLiteral("byte = %1_%2").arg(stage).arg(channelLetters[channel]),
             term(byte),
             byte,
             {}});
    }
}

/// The bytes of a written sample, and its levels where no column describes them.
void appendBytes(Explanation &explanation, const TracedScene &traced, const SampleRecord &sample,
                 const ExactSample &exact)
{
    const ByteRounding rounding = traced.scene.settings.rounding;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        if (sample.colour[channel].isNone())
            continue;
        const auto filled = [&](const QString &level) {
            return byteFormula(rounding, sample.level[channel]).replace(u'%', level);
        };
        FormulaLine byte;
        byte.subject = channelSubjects[channel];
        byte.symbols = QStringLiteral("byte = ") + filled(QString(channelLetters[channel]));
        byte.substituted = filled(term(sample.colour[channel]));
        byte.used = Quantity::integer(std::clamp<std::int64_t>(sample.level[channel], 0, 255));
        if (exact.colour[channel].isRational())
            byte.exact = byteOf(exact.colour[channel], rounding);
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
    const SpanPair spans(trace, step.span);
    const StepWords words = trace.sampleWords(step.span, place);
    const FormulaNames ofSpan = spanNames(traced, spans);
    FormulaNames names = ofSpan;
    names.add(QStringLiteral("x"), Quantity::integer(sample.x));
    names.add(QStringLiteral("y"), Quantity::integer(sample.y));
    // The step of a line or a circle is its one sample: the numbers stand in the span.
    const bool isStep = traced.trace->numbers().sample.empty() && samples.size() == 1;
    for (std::size_t channel = 0; channel < 3 && !isStep; ++channel)
        names.add(QString(channelLetters[channel]), sample.colour[channel],
                  place > 0 ? std::optional(samples[place - 1].colour[channel]) : std::nullopt);
    names.add(words.numbers, sample.cells, place > 0 ? &samples[place - 1].cells : nullptr);

    explanation.heading = (isWritten ? QStringLiteral("Pixel (%1, %2)")
                                     : QStringLiteral("Sample (%1, %2), refused"))
                              .arg(sample.x)
                              .arg(sample.y);
    explanation.sentence = words.sentence;
    if (words.sentence.isEmpty())
        explanation.sentence = isWritten
            ? QStringLiteral("The sample is covered and written.")
            : refusalSentence(traced, step.primitive, sample, decisionsOf(words.numbers, sample));
    if (sample.clamped)
        explanation.sentence += QStringLiteral(" A level left 0 … 255 and is clamped.");
    if (isStep)
        appendLines(explanation, spans.words.numbers, spans.current.cells,
                    exactSpanCells(traced, step.span), ofSpan, spans.start());
    const ExactSample exact = exactSamplesOf(traced, step.span, {&sample, 1}).front();
    appendLines(explanation, words.numbers, sample.cells, exact.cells, names,
                place == 0 ? FormulaStart::Fresh : FormulaStart::Continued);
    if (traced.plan)
        appendGiven(explanation, words.numbers, sample.cells);
    const QString stage = lastStage(words.numbers, sample.cells);
    if (isWritten && stage.isEmpty())
        appendBytes(explanation, traced, sample, exact);
    else if (isWritten)
        appendBytesOf(explanation, stage, trace.changes()[step.sample].after);
    return explanation;
}

} // namespace

QString spanHeading(const ScanTrace &trace, std::size_t span)
{
    const StepWords words = trace.spanWords(span);
    if (!words.heading.isEmpty())
        return words.heading;
    const SpanPlace &place = trace.placeOf(span);
    return place.part == 0 ? placeText(place)
                           : placeText(place) + QStringLiteral(", part %1").arg(place.part + 1);
}

Explanation explainStep(const TracedScene &traced, std::size_t stepIndex)
{
    const TraceStep step = traced.trace->stepAt(stepIndex);
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

} // namespace pixelplumb
