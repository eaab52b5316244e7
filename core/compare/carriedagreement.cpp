// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/carriedagreement.h"

#include "core/runs/explain/carriednumbers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace pixelplumb {

namespace {

/// Primitive, x and y of a sample.
using SamplePlace = std::tuple<std::size_t, std::int64_t, std::int64_t>;

/// The carried values that a run has computed.
struct CarriedSamples {
    std::vector<QString> titles;
    std::map<SamplePlace, std::vector<Quantity>> values; ///< in the order of `titles`
};

CarriedSamples samplesOf(const TracedScene *traced)
{
    CarriedSamples carried;
    if (!traced)
        return carried;
    const ScanTrace &trace = *traced->trace;
    for (std::size_t span = 0; span < trace.spanCount(); ++span) {
        const std::size_t primitive = trace.primitiveOf(span);
        const std::vector<std::size_t> numbers = carriedNumbers(*traced, primitive);
        if (numbers.empty())
            continue;
        if (carried.titles.empty()) {
            for (const std::size_t number : numbers)
                carried.titles.push_back(trace.numbers().sample[number].title);
        }
        for (const SampleRecord &sample : trace.samples(span)) {
            if (sample.fate != SampleFate::Written)
                continue;
            std::vector<Quantity> &values = carried.values[{primitive, sample.x, sample.y}];
            values.clear();
            for (const std::size_t number : numbers)
                values.push_back(sample.cells[number]);
        }
    }
    return carried;
}

void count(CarriedAgreement &agreement, const SamplePlace &place, double distance)
{
    ++agreement.samples;
    agreement.differing += distance != 0 ? 1 : 0;
    if (distance > agreement.largest)
        std::tie(agreement.largest, agreement.x, agreement.y)
            = std::tuple(distance, std::get<1>(place), std::get<2>(place));
}

void appendPair(std::vector<CarriedAgreement> &agreements, const CarriedAgreement &pair,
                const CarriedSamples &ours, const CarriedSamples &theirs)
{
    for (std::size_t i = 0; i < ours.titles.size(); ++i) {
        const auto same = std::ranges::find(theirs.titles, ours.titles[i]);
        if (same == theirs.titles.end())
            continue;
        const auto j = std::size_t(same - theirs.titles.begin());
        CarriedAgreement &agreement = agreements.emplace_back(pair);
        agreement.title = ours.titles[i];
        for (const auto &[place, values] : ours.values) {
            const auto other = theirs.values.find(place);
            if (other != theirs.values.end() && !values[i].isNone() && !other->second[j].isNone())
                count(agreement, place, std::abs(errorOf(values[i], other->second[j])));
        }
    }
}

} // namespace

std::vector<CarriedAgreement> carriedAgreements(
    const std::vector<std::shared_ptr<const TracedScene>> &runs)
{
    std::vector<CarriedSamples> carried;
    carried.reserve(runs.size());
    for (const std::shared_ptr<const TracedScene> &run : runs)
        carried.push_back(samplesOf(run.get()));
    std::vector<CarriedAgreement> agreements;
    for (std::size_t first = 0; first < runs.size(); ++first) {
        for (std::size_t second = first + 1; second < runs.size(); ++second)
            appendPair(agreements, {.first = first, .second = second}, carried[first],
                       carried[second]);
    }
    return agreements;
}

QString textOf(const CarriedAgreement &agreement)
{
    if (agreement.differing == 0)
        return u"%1: the same at %2 samples"_s.arg(agreement.title,
                                                   QString::number(agreement.samples));
    return u"%1: %2 of %3 samples differ, by up to %4 at (%5, %6)"_s.arg(
        agreement.title, QString::number(agreement.differing), QString::number(agreement.samples),
        QString::number(agreement.largest, 'g', 3), QString::number(agreement.x),
        QString::number(agreement.y));
}

} // namespace pixelplumb
