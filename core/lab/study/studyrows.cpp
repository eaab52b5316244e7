// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/study.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr double fairTimesStraight = 1.3;
constexpr int enoughRounds = 5;
constexpr double wideSpread = 0.2; ///< of the middle half, relative to the median

template <class Items, class Is>
auto firstOf(const Items &items, const Is &is)
{
    const auto found = std::ranges::find_if(items, is);
    return found == items.end() ? nullptr : &*found;
}

QString sentence(const QString &text, std::int64_t count, std::int64_t of)
{
    return text.arg(count).arg(of);
}

} // namespace

QString nameOf(LabOutcome outcome)
{
    switch (outcome) {
    case LabOutcome::Pending:
        return u"pending"_s;
    case LabOutcome::Measured:
        return u"measured"_s;
    case LabOutcome::Refused:
        return u"refused"_s;
    case LabOutcome::TookTooLong:
        return u"took-too-long"_s;
    case LabOutcome::Failed:
        return u"failed"_s;
    }
    return {};
}

std::optional<double> LabRow::missesStraight() const
{
    if (!cost || !cost->timesStraight || cost->timesStraight->median <= fairTimesStraight)
        return std::nullopt;
    return cost->timesStraight->median;
}

const LabRow *Study::row(const QString &ofContender, const QString &ofFamily) const
{
    return firstOf(rows, [&](const LabRow &each) {
        return each.contender == ofContender && each.family == ofFamily;
    });
}

const StudyContender *Study::contender(const QString &id) const
{
    return firstOf(contenders, [&](const StudyContender &each) { return each.id == id; });
}

const StudyFamily *Study::family(const QString &id) const
{
    return firstOf(families, [&](const StudyFamily &each) { return each.id == id; });
}

std::int64_t StudyFamily::timedSpans(const QString &contender) const
{
    const auto named = labContenderNamed(contender);
    return named && named->spanAxis() == SpanAxis::Row ? timedRows : timedColumns;
}

LabRow LabRow::withoutTimes() const
{
    LabRow row = *this;
    row.cost.reset();
    row.remark.clear();
    return row;
}

std::optional<double> Study::perPixel(const LabRow &row) const
{
    const StudyFamily *drawn = family(row.family);
    if (!drawn || drawn->timedPixels == 0 || !row.cost || row.cost->rounds == 0)
        return std::nullopt;
    return row.cost->perDraw.median / double(drawn->timedPixels);
}

QStringList warningsOf(const Study &study)
{
    QStringList warnings = warningsOf(study.conditions);
    if (!study.isComplete)
        warnings << u"The study was ended before all was measured."_s;
    std::int64_t timed = 0, wide = 0, missing = 0, vouched = 0;
    for (const LabRow &row : study.rows) {
        if (!row.cost || row.cost->rounds == 0)
            continue;
        ++timed;
        const Spread &spread = row.cost->perDraw;
        wide += spread.upper - spread.lower > wideSpread * spread.median ? 1 : 0;
        vouched += row.cost->timesStraight ? 1 : 0;
        missing += row.missesStraight() ? 1 : 0;
    }
    if (timed > 0 && study.rounds == 0)
        warnings << u"Not everyone was timed; who was, was timed once or a few times."_s;
    else if (timed > 0 && study.rounds < enoughRounds)
        warnings << u"Only %1 rounds were timed; medians of fewer than %2 say little."_s
                        .arg(study.rounds)
                        .arg(enoughRounds);
    if (wide > 0)
        warnings << sentence("In %1 of %2 rows the middle half of the times spans more than a "
                             "fifth of their median.",
                             wide, timed);
    if (missing > 0)
        warnings << sentence("%1 of %2 rows that have a straight loop take more than 1.3 of its "
                             "time: what they cost is partly the kernel's own.",
                             missing, vouched);
    return warnings;
}

} // namespace pixelplumb
