// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/prediction.h"

#include "core/methods/words/formulatext.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/tracedscene.h"
#include "core/scene/text/coordinatetext.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pixelplumb {

namespace {

/// Whether any span in [first, end) has the cell.
std::vector<bool> isThereIn(const ScanTrace &trace, std::size_t first, std::size_t end)
{
    std::vector<bool> isThere(trace.numbers().span.size(), false);
    for (std::size_t span = first; span < end; ++span) {
        const std::vector<Quantity> cells = trace.span(span).cells;
        bool areAll = true;
        for (std::size_t i = 0; i < isThere.size(); ++i) {
            isThere[i] = isThere[i] || (i < cells.size() && !cells[i].isNone());
            areAll = areAll && isThere[i];
        }
        if (areAll)
            break;
    }
    return isThere;
}

/// Keeps only those that have one value in the primitive's spans.
void keepConstant(std::vector<bool> &candidates, const ScanTrace &trace, std::size_t primitive)
{
    std::vector<Quantity> values(candidates.size());
    const std::size_t end = trace.endSpanOf(primitive);
    for (std::size_t span = trace.firstSpanOf(primitive); span < end; ++span) {
        if (std::find(candidates.begin(), candidates.end(), true) == candidates.end())
            return;
        const std::vector<Quantity> cells = trace.span(span).cells;
        for (std::size_t i = 0; i < std::min(candidates.size(), cells.size()); ++i) {
            if (!candidates[i] || cells[i].isNone())
                continue;
            if (values[i].isNone())
                values[i] = cells[i];
            candidates[i] = cells[i] == values[i];
        }
    }
}

/// For each cell of a span's primitive (SpanRecord::cells): whether all of its spans that have it
/// agree, but for rounding, and an earlier span than this one already has it.
std::vector<bool> constantNumbersBefore(const TracedScene &traced, std::size_t span)
{
    const ScanTrace &trace = *traced.trace;
    const std::size_t primitive = trace.primitiveOf(span);
    std::vector<bool> constant = isThereIn(trace, trace.firstSpanOf(primitive), span);
    const bool hasTwin = traced.exactTrace && primitive < traced.exactTrace->primitiveCount();
    keepConstant(constant, hasTwin ? *traced.exactTrace : trace, primitive);
    return constant;
}

// Relative errors.
constexpr double readingError = 1e-9; ///< of a fraction read as a double
constexpr double float32Error = 0x1p-22; ///< of a fraction beside a float32: its last two places

/// The number that a formula computes: the part before "←" or "=".
QString assignedIn(const QString &symbols)
{
    const qsizetype end = std::max(symbols.indexOf(u" ← "_s), symbols.indexOf(u" = "_s));
    return symbols.left(end);
}

/// A formula may name what it computes in words, followed by the symbol for it.
QString askedFor(const QString &symbols)
{
    const QString assigned = assignedIn(symbols);
    if (!assigned.contains(u' '))
        return assigned;
    const QString name = symbols.sliced(assigned.size() + u" = "_s.size());
    return u"the %1, %2"_s.arg(assigned, name);
}

/// "p_k ← p_k₊₁′": it is in the previous row under another name.
bool isTakenOver(const QString &symbols)
{
    const QString computed = symbols.sliced(symbols.lastIndexOf(u' ') + 1);
    return computed.endsWith(u'′') && symbols == assignedIn(symbols) + u" ← "_s + computed;
}

/// A count of spans, which the question itself names.
bool isPlace(const std::vector<NumberDescription> &numbers, const QString &title)
{
    return std::ranges::any_of(numbers, [&title](const NumberDescription &number) {
        return number.title == title && number.group == NumberGroup::Position;
    });
}

/// Whether it has not changed since an earlier span, from which it could be copied.
bool isRepeated(const std::vector<NumberDescription> &numbers, const std::vector<bool> &constant,
                const QString &title)
{
    for (std::size_t i = 0; i < std::min(numbers.size(), constant.size()); ++i) {
        if (constant[i] && numbers[i].title == title)
            return true;
    }
    return false;
}

/// The count of the span's pixels, which is told without a formula: it follows from the bounds
/// before it, and from the frame where that cuts the span off.
void addPixelCount(std::vector<Prediction> &predictions,
                   const std::vector<NumberDescription> &numbers, const ScanTrace &trace,
                   std::size_t span)
{
    const auto count = std::ranges::find(numbers, "pixels", &NumberDescription::id);
    const auto isBound = [](const Prediction &each) { return isRounding(each.rule); };
    const auto first = std::ranges::find_if(predictions, isBound);
    const auto last
        = first == predictions.end() ? first : std::find_if(first + 1, predictions.end(), isBound);
    if (count == numbers.end() || last == predictions.end())
        return;
    const auto cellOf = [&](std::size_t of) {
        return trace.span(of).cells[std::size_t(count - numbers.begin())];
    };
    Prediction asked = *last;
    asked.title = count->title;
    asked.words = u"the number of pixels, %1"_s.arg(count->title);
    asked.value = cellOf(span);
    asked.exact = {};
    asked.earlier = trace.beginsPart(span) ? Quantity() : cellOf(span - 1);
    asked.rule = u"%1 = %2 − %3 + 1"_s.arg(count->title, last->title, first->title);
    asked.reason = u"%1 = %2 − %3 + 1"_s.arg(asked.rule, term(last->value), term(first->value));
    const double whole = last->value.toDouble() - first->value.toDouble() + 1;
    if (asked.value.toDouble() != whole) {
        asked.rule = u"%1 = those of %2 … %3 that are in the frame"_s.arg(
            count->title, first->title, last->title);
        asked.reason = asked.rule;
    }
    predictions.insert(last + 1, asked);
}

const FormulaLine *lineOf(const Explanation &explanation, const FormulaLine &like)
{
    const auto found = std::ranges::find_if(explanation.lines, [&](const FormulaLine &line) {
        return line.subject == like.subject && assignedIn(line.symbols) == assignedIn(like.symbols);
    });
    return found != explanation.lines.end() ? &*found : nullptr;
}

/// A number named in words goes by its symbol: "⌈y_B⌉", not "first row".
QString titleOf(const QString &symbols)
{
    const QString assigned = assignedIn(symbols);
    return isRounding(symbols) && assigned.contains(u' ')
        ? symbols.sliced(assigned.size() + u" = "_s.size())
        : assigned;
}

/// The formula with its numbers, which may be the value already: y_B ← y₀ = 4.
QString reasonOf(const FormulaLine &line)
{
    return line.substituted == term(line.used) ? line.symbols
                                               : line.symbols + u" = "_s + line.substituted;
}

/// Reads a decimal comma as a point; several commas are no decimal.
QString withPoint(QString typed)
{
    return typed.count(u',') == 1 ? typed.replace(u',', u'.') : typed;
}

/// How many digits follow the point; 0 if it is not a decimal.
int placesOf(const QString &typed)
{
    const qsizetype point = typed.indexOf(u'.');
    return point < 0 || typed.contains(u'/') ? 0 : int(typed.size() - point - 1);
}

bool isSame(double typed, double value, double error = readingError)
{
    return std::abs(typed - value) <= error * std::max(1.0, std::abs(value));
}

/// Whether a fraction is the number that the kernel computes, to the kernel's precision, or the one
/// that it would compute without rounding.
bool isFractionOf(double typed, const Prediction &prediction)
{
    const double error
        = prediction.value.kind() == Quantity::Kind::Float32 ? float32Error : readingError;
    return isSame(typed, prediction.value.toDouble(), error)
        || (!prediction.exact.isNone() && isSame(typed, prediction.exact.toDouble()));
}

bool isRounded(double typed, double value, int places)
{
    const double half = 0.5 * std::pow(10.0, -places);
    return std::abs(typed - value) <= half + readingError * std::max(1.0, std::abs(value));
}

/// Whether the value was truncated after its last place.
bool isCutOff(double typed, double value, int places)
{
    const double scale = std::pow(10.0, places);
    return isSame(typed, std::trunc(value * scale) / scale);
}

} // namespace

bool isRounding(const QString &rule)
{
    const QString computed = rule.sliced(assignedIn(rule).size());
    return computed.startsWith(u" = ⌈"_s) || computed.startsWith(u" = ⌊"_s);
}

bool asksForWhole(const Prediction &prediction)
{
    if (isRounding(prediction.rule))
        return true;
    const auto isBroken = [](QChar sign) { return sign == u'/' || sign == u'.'; };
    return prediction.value.isInteger() && std::ranges::none_of(prediction.reason, isBroken);
}

std::vector<Prediction> predictionsAfter(const TracedScene &traced, std::size_t position)
{
    const ScanTrace &trace = *traced.trace;
    std::size_t index = position;
    while (index < trace.stepCount() && trace.stepAt(index).kind != StepKind::Span)
        ++index;
    if (index >= trace.stepCount())
        return {};
    const std::size_t span = trace.stepAt(index).span;
    const Explanation next = explainStep(traced, index);
    std::optional<Explanation> before;
    if (!trace.beginsPart(span))
        before = explainStep(traced, trace.indexOfSpan(span - 1));
    const std::vector<NumberDescription> numbers = trace.spanWords(span).numbers;
    const std::vector<bool> constant = constantNumbersBefore(traced, span);
    std::vector<Prediction> predictions;
    for (const FormulaLine &line : next.lines) {
        const QString title = titleOf(line.symbols);
        if (isPlace(numbers, title) || isTakenOver(line.symbols))
            continue; // the question itself, or the step before, reveals it
        const FormulaLine *earlier = before ? lineOf(*before, line) : nullptr;
        predictions.push_back({next.heading, title, askedFor(line.symbols), line.used,
                               earlier ? earlier->used : Quantity(), line.symbols, reasonOf(line),
                               line.exact, index, isRepeated(numbers, constant, title)});
    }
    addPixelCount(predictions, numbers, trace, span);
    return predictions;
}

Guess judge(const Prediction &prediction, const QString &typed)
{
    const QString text = withPoint(typed.trimmed().replace(u'−', u'-'));
    const auto read = parseReal(text, coordinateFormat);
    if (!read)
        return Guess::Unread;
    const double value = prediction.value.toDouble();
    const int places = placesOf(text);
    const bool isWhole = isSame(*read, std::round(*read));
    if (isSame(*read, value) || (places >= leastPlaces && isRounded(*read, value, places))
        || (text.contains(u'/') && isFractionOf(*read, prediction)))
        return Guess::Right;
    if (!prediction.earlier.isNone() && isSame(*read, prediction.earlier.toDouble()))
        return Guess::Earlier;
    if (isSame(*read, -value))
        return Guess::OtherSign;
    if (isWhole && !prediction.value.isInteger() && std::abs(*read - value) < 1)
        return *read > value ? Guess::RoundedUp : Guess::RoundedDown;
    if (!isWhole && isRounding(prediction.rule) && std::abs(*read - value) < 1)
        return Guess::Unrounded;
    if (prediction.value.isInteger() && std::abs(*read - value) == 1)
        return Guess::OneOff;
    if (places > 0 && (isRounded(*read, value, places) || isCutOff(*read, value, places)))
        return Guess::Near;
    return Guess::Wrong;
}

} // namespace pixelplumb
