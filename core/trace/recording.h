// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/currentstep.h"
#include "core/trace/listener.h"
#include "core/trace/numberrow.h"
#include "core/trace/stepwords.h"
#include "core/trace/tracerecords.h"

#include <concepts>
#include <memory>
#include <type_traits>

/// How a kernel's numbers become records. A recording names
///   SetUp, Span, Sample    the kernel's numbers, as its observers receive them;
///   setUpNumbers(), spanNumbers(), sampleNumbers()
///                          the tables of NumberRows by which they are read and described;
///   placeOf(span)          where the span lies;
///   record(…)              fills what a SetUpRecord, SpanRecord or SampleRecord holds besides its
///                          cells;
///   isClamped(sample)      whether a level left 0 … 255.
/// It may name more:
///   walk(setUp, span, settings, observer)
///                          calls the kernel's own loop again for one span, in SpanPixels; where
///                          there is no such function the samples themselves are kept;
///   record(currentSpan, spanRecord), record(currentSample, sampleRecord)
///                          fill what a record takes from the set-up, or from span and set-up;
///   stateOf(currentStep)   what the rows read instead of the step itself;
///   tell(words, state)     adds the words of a step that only this family has.
namespace pixelplumb {

/// The tables of a recording, or those of a scope where it has one.
template <class R>
struct TablesOf {
    std::decay_t<decltype(R::setUpNumbers())> setUp;
    std::decay_t<decltype(R::spanNumbers())> span;
    std::decay_t<decltype(R::sampleNumbers())> sample;

    template <class... Scope>
    static std::shared_ptr<const TablesOf> of(const Scope &...scope)
    {
        return std::make_shared<const TablesOf>(TablesOf{
            R::setUpNumbers(scope...), R::spanNumbers(scope...), R::sampleNumbers(scope...)});
    }
    /// The tables shared by every run.
    static const std::shared_ptr<const TablesOf> &common()
    {
        static const std::shared_ptr<const TablesOf> tables = of();
        return tables;
    }
};

template <class R>
using CurrentSetUpOf = CurrentSetUp<typename R::SetUp>;
template <class R>
using CurrentSpanOf = CurrentSpan<typename R::SetUp, typename R::Span>;
template <class R>
using CurrentSampleOf = CurrentSample<typename R::SetUp, typename R::Span, typename R::Sample>;

template <class R>
concept Recording = requires(const typename R::SetUp &setUp, const typename R::Span &span,
                             const typename R::Sample &sample, SetUpRecord &setUpRecord,
                             SpanRecord &spanRecord, SampleRecord &sampleRecord)
{
    R::setUpNumbers();
    R::spanNumbers();
    R::sampleNumbers();
    R::record(setUp, setUpRecord);
    R::record(span, spanRecord);
    R::record(sample, sampleRecord);
    {
        R::placeOf(span)
        } -> std::same_as<SpanPlace>;
    {
        R::isClamped(sample)
        } -> std::same_as<bool>;
};

template <class R>
using ObserverOf = AnnouncingObserver<typename R::SetUp, typename R::Span, typename R::Sample>;

/// Whether a span's samples can be walked again.
template <class R>
inline constexpr bool canWalkAgain
    = requires(const typename R::SetUp &setUp, const typename R::Span &span,
               const ScanSettings &settings, ObserverOf<R> observer)
{
    R::walk(setUp, span, settings, observer);
};

/// The state that a recording's rows read at a step.
template <class R, class CurrentStep>
decltype(auto) stateOf(const CurrentStep &step)
{
    if constexpr (requires { R::stateOf(step); })
        return R::stateOf(step);
    else
        return CurrentStep(step);
}

/// The words of a step whose numbers are in a table.
template <class R, class Table, class State>
StepWords wordsOf(const Table &table, const State &state)
{
    StepWords words;
    words.numbers = descriptionsIn(table, state);
    if constexpr (requires { R::tell(words, state); })
        R::tell(words, state);
    for (QString *text : {&words.heading, &words.sentence, &words.event})
        *text = withMinus(*text);
    return words;
}

} // namespace pixelplumb
