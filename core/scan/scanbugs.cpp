// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scan/scanbugs.h"

#include <algorithm>
#include <bit>

namespace pixelplumb {

namespace {

using Bytes = std::array<std::uint8_t, sizeof(ScanBugs)>;

/// Where a setting's byte stands.
template <auto member>
constexpr std::size_t placeOf()
{
    ScanBugs bugs;
    bugs.*member = std::bit_cast<std::decay_t<decltype(bugs.*member)>>(std::uint8_t(1));
    const auto bytes = std::bit_cast<Bytes>(bugs);
    std::size_t place = 0;
    while (bytes[place] == 0)
        ++place;
    return place;
}

using enum SettingPart;
constexpr std::uint8_t never = ScanSetting::never;

constexpr std::array allSettings = {
    ScanSetting{"order", placeOf<&ScanBugs::order>(), Edges, 1},
    ScanSetting{"vertices", placeOf<&ScanBugs::vertices>(), Edges, 3, 3},
    ScanSetting{"vertex-colours", placeOf<&ScanBugs::vertexColours>(), Edges, 1},
    ScanSetting{"edge-changes", placeOf<&ScanBugs::edgeChanges>(), Edge, 1, never, true},
    ScanSetting{"divided", placeOf<&ScanBugs::divided>(), Edges, 1},
    ScanSetting{"departing", placeOf<&ScanBugs::departing>(), Edges, 1},
    ScanSetting{"slope-form", placeOf<&ScanBugs::slopeForm>(), Edge, 1},
    ScanSetting{"slopes", placeOf<&ScanBugs::slopes>(), Edge, 1},
    ScanSetting{"edge-colours", placeOf<&ScanBugs::edgeColours>(), Edge, 1},
    ScanSetting{"pre-steps", placeOf<&ScanBugs::preSteps>(), Sample},
    ScanSetting{"steps", placeOf<&ScanBugs::steps>(), Sample},
    ScanSetting{"run-ends", placeOf<&ScanBugs::runEnds>(), Edge, 1},
    ScanSetting{"edge-places", placeOf<&ScanBugs::edgePlaces>(), Edge, 1, 1},
    ScanSetting{"edge-levels", placeOf<&ScanBugs::edgeLevels>(), Edge, 1, 1},
    ScanSetting{"bounds", placeOf<&ScanBugs::bounds>(), Span},
    ScanSetting{"levels", placeOf<&ScanBugs::levels>(), Sample},
    ScanSetting{"place-pre-step", placeOf<&ScanBugs::placePreStep>(), Edge, 1},
    ScanSetting{"edge-colour-pre-step", placeOf<&ScanBugs::edgeColourPreStep>(), Edge, 1},
    ScanSetting{"span-pre-step", placeOf<&ScanBugs::spanPreStep>(), Sample},
    ScanSetting{"edge-storing", placeOf<&ScanBugs::edgeStoring>(), Edge, 1},
    ScanSetting{"span-storing", placeOf<&ScanBugs::spanStoring>(), Sample},
    ScanSetting{"without-edge-pre-step", placeOf<&ScanBugs::withoutEdgePreStep>(), Edge, 1, never,
                true},
    ScanSetting{"without-span-pre-step", placeOf<&ScanBugs::withoutSpanPreStep>(), Sample, never,
                never, true},
    ScanSetting{"unstepped-along-edges", placeOf<&ScanBugs::unsteppedAlongEdges>(), Edge, 1, 1,
                true},
    ScanSetting{"unstepped-along-spans", placeOf<&ScanBugs::unsteppedAlongSpans>(), Sample, never,
                never, true},
    ScanSetting{"rates-along-edges-of", placeOf<&ScanBugs::ratesAlongEdgesOf>(), Edge, 1},
    ScanSetting{"steps-along-edges-of", placeOf<&ScanBugs::stepsAlongEdgesOf>(), Edge, 1, 1},
    ScanSetting{"rates-along-spans-of", placeOf<&ScanBugs::ratesAlongSpansOf>(), Sample},
    ScanSetting{"steps-along-spans-of", placeOf<&ScanBugs::stepsAlongSpansOf>(), Sample},
    ScanSetting{"edge-colour-divisor", placeOf<&ScanBugs::edgeColourDivisor>(), Edge, 1},
    ScanSetting{"edge-colour-sign", placeOf<&ScanBugs::edgeColourSign>(), Edge, 1},
    ScanSetting{"place-stepping", placeOf<&ScanBugs::placeStepping>(), Edges, 1},
    ScanSetting{"edge-colour-stepping", placeOf<&ScanBugs::edgeColourStepping>(), Edges, 1},
    ScanSetting{"span-stepping", placeOf<&ScanBugs::spanStepping>(), Sample},
    ScanSetting{"empty-spans", placeOf<&ScanBugs::emptySpans>(), Span, 1, 1},
    ScanSetting{"short-places-behind", placeOf<&ScanBugs::shortPlacesBehind>(), Edges, 1, 1},
    ScanSetting{"short-colours-behind", placeOf<&ScanBugs::shortColoursBehind>(), Edges, 1, 1},
    ScanSetting{"first-slope", placeOf<&ScanBugs::firstSlope>(), Edges, 1},
    ScanSetting{"first-colour-rates", placeOf<&ScanBugs::firstColourRates>(), Edges, 1},
    ScanSetting{"second-slope", placeOf<&ScanBugs::secondSlope>(), Edges, 1},
    ScanSetting{"second-colour-rates", placeOf<&ScanBugs::secondColourRates>(), Edges, 1},
    ScanSetting{"long-slope", placeOf<&ScanBugs::longSlope>(), Edges, 1},
    ScanSetting{"long-colour-rates", placeOf<&ScanBugs::longColourRates>(), Edges, 1},
    ScanSetting{"slopes-of", placeOf<&ScanBugs::slopesOf>(), Edges, 1},
    ScanSetting{"long-places-before", placeOf<&ScanBugs::longPlacesBefore>(), Edges, 1, 1},
    ScanSetting{"long-colours-before", placeOf<&ScanBugs::longColoursBefore>(), Edges, 1, 1},
    ScanSetting{"long-places-behind", placeOf<&ScanBugs::longPlacesBehind>(), Edges, 1, 1},
    ScanSetting{"long-colours-behind", placeOf<&ScanBugs::longColoursBehind>(), Edges, 1, 1},
    ScanSetting{"flat-end", placeOf<&ScanBugs::flatEnd>(), Edges, never, 2},
    ScanSetting{"middle-span", placeOf<&ScanBugs::middleSpan>(), Edges, 1, 1},
    ScanSetting{"upper-edge", placeOf<&ScanBugs::upperEdge>(), Span, 5},
    ScanSetting{"spans", placeOf<&ScanBugs::spans>(), Edges, 1},
    ScanSetting{"least-span", placeOf<&ScanBugs::leastSpan>(), End, 3},
    ScanSetting{"greatest-span", placeOf<&ScanBugs::greatestSpan>(), End, 3},
    ScanSetting{"first", placeOf<&ScanBugs::first>(), End},
    ScanSetting{"last", placeOf<&ScanBugs::last>(), End},
    ScanSetting{"extra-before", placeOf<&ScanBugs::extraBefore>(), End},
    ScanSetting{"extra-behind", placeOf<&ScanBugs::extraBehind>(), End},
    ScanSetting{"divisor", placeOf<&ScanBugs::divisor>(), Span},
    ScanSetting{"lower-colours", placeOf<&ScanBugs::lowerColours>(), Span},
    ScanSetting{"span-colours", placeOf<&ScanBugs::spanColours>(), Span},
    ScanSetting{"span-start", placeOf<&ScanBugs::spanStart>(), Span, 1, 1},
    ScanSetting{"overflow", placeOf<&ScanBugs::overflow>(), Sample},
};
static_assert(allSettings.size() == sizeof(ScanBugs), "each setting is a byte and has a row");

/// Whether one of the settings has at least the value from which something is so.
bool hasValueFrom(std::uint8_t ScanSetting::*from, const ScanBugs &bugs)
{
    return std::ranges::any_of(allSettings, [&](const ScanSetting &setting) {
        return setting.*from != never && valueOf(setting, bugs) >= setting.*from;
    });
}

bool storesAlongEdges(const ScanBugs &bugs)
{
    return bugs.edgePlaces != Truncation::All || bugs.edgeLevels != Truncation::All;
}

/// Whether merging would spread a mistake to what the other program does right.
bool spreads(const ScanBugs &one, const ScanBugs &other)
{
    const bool toEdges = one.departing != other.departing && one.withRightEdges() != one
        && other.withRightEdges() != other;
    const bool toFirstValues
        = one.edgeStoring != other.edgeStoring && storesAlongEdges(one) && storesAlongEdges(other);
    const bool toEnd = one.order != other.order && one.hasOrder() && other.hasOrder();
    return toEdges || toFirstValues || toEnd;
}

} // namespace

bool ScanBugs::remembers() const { return hasValueFrom(&ScanSetting::remembersFrom, *this); }
bool ScanBugs::hasOrder() const { return hasValueFrom(&ScanSetting::ordersFrom, *this); }

ScanBugs ScanBugs::withRightEdges() const
{
    ScanBugs bugs = *this;
    for (const ScanSetting &setting : allSettings) {
        if (setting.part == SettingPart::Edge)
            setValue(setting, 0, bugs);
    }
    return bugs;
}

std::span<const ScanSetting> scanSettings() { return allSettings; }

std::uint8_t valueOf(const ScanSetting &setting, const ScanBugs &bugs)
{
    return std::bit_cast<Bytes>(bugs)[setting.place];
}

void setValue(const ScanSetting &setting, std::uint8_t value, ScanBugs &bugs)
{
    auto bytes = std::bit_cast<Bytes>(bugs);
    bytes[setting.place] = value;
    bugs = std::bit_cast<ScanBugs>(bytes);
}

std::optional<ScanBugs> together(const ScanBugs &one, const ScanBugs &other)
{
    if (spreads(one, other))
        return std::nullopt;
    const auto first = std::bit_cast<Bytes>(one);
    const auto second = std::bit_cast<Bytes>(other);
    Bytes sum = {};
    for (const ScanSetting &setting : allSettings) {
        const std::size_t place = setting.place;
        const bool isOrder = place == placeOf<&ScanBugs::order>();
        const bool isContradiction = setting.isSet
            ? (first[place] & second[place]) != 0
            : first[place] != 0 && second[place] != 0 && !isOrder;
        if (isContradiction)
            return std::nullopt;
        sum[place] = first[place] | second[place];
    }
    const auto both = std::bit_cast<ScanBugs>(sum);
    if (both.edgeChanges.contains(edgechange::divisorMinusOne
                                  | edgechange::divisorPlusOne)) // they cancel each other
        return std::nullopt;
    return both;
}

} // namespace pixelplumb
