// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/runformulas.h"

#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

class FoundFormulas {
public:
    explicit FoundFormulas(std::size_t numbers)
        : m_found(numbers)
        , m_hasOthers(numbers)
    {
    }

    void add(const std::vector<NumberDescription> &numbers, const std::vector<Quantity> &cells,
             FormulaStart start)
    {
        for (std::size_t i = 0; i < std::min(numbers.size(), cells.size()); ++i) {
            const QString formula = formulaInForce(numbers[i], cells[i], start);
            if (!formula.isEmpty() && !m_found[i].contains(formula))
                m_found[i].append(formula);
            if (formula.isEmpty() && !cells[i].isNone())
                m_hasOthers[i] = true;
        }
    }
    /// Of a value that no formula gives.
    void addUntold(std::size_t number) { m_hasOthers[number] = true; }
    QStringList texts() const
    {
        QStringList texts;
        for (std::size_t i = 0; i < m_found.size(); ++i) {
            texts.append(m_found[i].join(u"; "_s));
            if (m_hasOthers[i] && !m_found[i].isEmpty())
                texts.back() += u"; other values by no formula of this list"_s;
        }
        return texts;
    }

private:
    std::vector<QStringList> m_found; ///< by number
    std::vector<bool> m_hasOthers; ///< values that a step has without a formula
};

/// The channel of each number that is a level.
std::vector<std::pair<std::size_t, std::size_t>> levelsAmong(
    const std::vector<NumberDescription> &numbers)
{
    std::vector<std::pair<std::size_t, std::size_t>> levels; // number, channel
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto channel = std::ranges::find(channelLetters, numbers[i].id);
        if (channel != channelLetters.end())
            levels.emplace_back(i, std::size_t(channel - channelLetters.begin()));
    }
    return levels;
}

/// Asks before any of them is written.
bool goesOnBefore(const ProgressListener &progress, std::size_t spans)
{
    return goesOn(progress, {JobPhase::Writing, 0, std::int64_t(spans)});
}

} // namespace

QStringList setUpFormulas(const TracedScene &traced)
{
    const ScanTrace &trace = *traced.trace;
    FoundFormulas found(trace.numbers().setUp.size());
    for (std::size_t primitive = 0; primitive < trace.primitiveCount(); ++primitive) {
        const SetUpRecord record = trace.setUp(primitive);
        if (!record.rejection)
            found.add(trace.setUpWords(primitive).numbers, record.cells, FormulaStart::Fresh);
    }
    return found.texts();
}

QStringList spanFormulas(const TracedScene &traced, const ProgressListener &progress)
{
    const ScanTrace &trace = *traced.trace;
    FoundFormulas found(trace.numbers().span.size());
    for (std::size_t span = 0;
         span < trace.spanCount() && goesOnBefore(progress, trace.spanCount()); ++span)
        found.add(trace.spanWords(span).numbers, trace.span(span).cells, startOfSpan(trace, span));
    return found.texts();
}

QStringList sampleFormulas(const TracedScene &traced, const ProgressListener &progress)
{
    const ScanTrace &trace = *traced.trace;
    FoundFormulas found(trace.numbers().sample.size());
    const auto levels = levelsAmong(trace.numbers().sample);
    for (std::size_t span = 0;
         span < trace.spanCount() && goesOnBefore(progress, trace.spanCount()); ++span) {
        const std::vector<SampleRecord> samples = trace.samples(span);
        const auto numbers = trace.sampleNumbers(span);
        const std::size_t visited
            = std::min(trace.endSampleOf(span) - trace.firstSampleOf(span), samples.size());
        for (std::size_t place = 0; place < visited; ++place) {
            found.add(numbers[place], samples[place].cells, startOfSample(place));
            // Levels are told where a run has no such numbers, too.
            for (const auto &[number, channel] : levels) {
                const auto &cells = samples[place].cells;
                const bool hasCell = number < cells.size() && !cells[number].isNone();
                if (!hasCell && !samples[place].colour[channel].isNone())
                    found.addUntold(number);
            }
        }
    }
    return found.texts();
}

} // namespace pixelplumb
