// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/tracediff.h"

#include "core/frame/framebuffer.h"
#include "core/grade/diagnose/rightlines.h"
#include "core/grade/diagnose/timesdrawn.h"
#include "core/methods/words/formulatext.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pixelplumb {

namespace {

/// Where a number comes from that is none, or infinite; empty for others.
QString originOf(double number)
{
    if (std::isnan(number))
        return u" (no number: 0 was divided by 0, or it is computed from such a one)"_s;
    return std::isinf(number) ? u" (something was divided by 0, or grew without end)"_s : QString();
}

QString textOf(const Place &place)
{
    const auto &[axis, x, y] = place;
    if (!axis)
        return u"pixel (%1, %2)"_s.arg(x).arg(y);
    return *axis == SpanAxis::Column ? u"column %1"_s.arg(x) : u"row %1"_s.arg(y);
}

QString titleOf(std::optional<SpanAxis> axis, std::size_t number)
{
    const QStringList titles = !axis ? QStringList{u"R"_s, u"G"_s, u"B"_s}
        : *axis == SpanAxis::Column  ? QStringList{u"y_B"_s, u"y_T"_s}
                                     : QStringList{u"x_L"_s, u"x_R"_s};
    return titles[qsizetype(number)];
}

/// Whether a printed number is close enough.
bool isRight(const WrittenNumber &is, const Quantity &should, double drift)
{
    if (is.text.contains(u'/'))
        return errorOf(is.value, should) == 0;
    // Allows for the last bits of the doubles compared here, so that 0.05 is not above 0.05.
    return std::abs(errorOf(is.value, should)) <= (is.halfUnit + drift) * (1 + 1e-9);
}

int byteOf(double level, ByteRounding rounding)
{
    const double byte = std::floor(rounding == ByteRounding::Nearest ? level + 0.5 : level);
    return int(std::clamp(byte, 0.0, 255.0));
}

/// Matches a program's lines with the right ones.
class TraceMatcher {
public:
    TraceMatcher(const ProgramTrace &trace, std::vector<RightLine> right, ByteRounding rounding,
                 TraceExtent extent)
        : m_trace(trace)
        , m_right(std::move(right))
        , m_rounding(rounding)
        , m_extent(extent)
    {
        for (std::size_t i = 0; i < m_right.size(); ++i) {
            m_places[{m_right[i].place, std::nullopt}].push_back(i);
            m_places[{m_right[i].place, m_right[i].primitive}].push_back(i);
            m_hasSeveral = m_hasSeveral || m_right[i].primitive != m_right.front().primitive;
        }
    }

    /// The text, and the right run's step.
    std::optional<std::pair<QString, std::size_t>> firstDifference()
    {
        match();
        std::size_t next = 0; // the first right line not yet passed
        for (std::size_t i = 0; i < m_matches.size(); ++i) {
            const auto &matched = m_matches[i];
            if (!matched)
                return std::pair(unexpectedText(i), stepNear(next));
            // Optional lines come after the others, wherever the program prints them.
            for (; m_right[*matched].isAskedFor && next <= *matched; ++next) {
                if (isMissing(next))
                    return missing(next);
            }
            if (const QString text = numbersText(m_trace.lines[i], m_right[*matched]);
                !text.isEmpty())
                return std::pair(text, m_right[*matched].step);
        }
        for (; next < m_right.size(); ++next) {
            if (isMissing(next))
                return missing(next);
        }
        return m_extent == TraceExtent::Whole ? orderDifference() : std::nullopt;
    }

private:
    using Key = std::pair<Place, std::optional<std::size_t>>;

    static Key keyOf(const WrittenLine &line)
    {
        return {Place{line.axis, line.x, line.y}, line.triangle};
    }

    void match()
    {
        m_isMatched.assign(m_right.size(), false);
        m_matches.reserve(m_trace.lines.size());
        for (const WrittenLine &line : m_trace.lines) {
            m_matches.push_back(counterpartOf(line));
            if (m_matches.back())
                m_isMatched[*m_matches.back()] = true;
        }
    }

    /// The first unmatched right line at this place; where some are optional, one with the same
    /// numbers, required ones first.
    std::optional<std::size_t> counterpartOf(const WrittenLine &line) const
    {
        const auto found = m_places.find(keyOf(line));
        if (found == m_places.end())
            return std::nullopt;
        std::vector<std::size_t> open;
        std::ranges::copy_if(found->second, std::back_inserter(open),
                             [this](std::size_t right) { return !m_isMatched[right]; });
        if (open.empty())
            return std::nullopt;
        const auto isAskedFor = [this](std::size_t right) { return m_right[right].isAskedFor; };
        if (std::ranges::all_of(open, isAskedFor))
            return open.front();
        std::ranges::stable_sort(open, std::ranges::greater(), isAskedFor);
        const auto fitting = std::ranges::find_if(
            open, [&](std::size_t right) { return numbersText(line, m_right[right]).isEmpty(); });
        return fitting != open.end() ? *fitting : open.front();
    }

    bool isMissing(std::size_t right) const
    {
        return m_extent == TraceExtent::Whole && m_right[right].isAskedFor && !m_isMatched[right];
    }
    std::pair<QString, std::size_t> missing(std::size_t right) const
    {
        return {textOf(m_right[right]) + u" is missing"_s, m_right[right].step};
    }
    std::size_t stepNear(std::size_t right) const
    {
        return m_right.empty() ? 0 : m_right[std::min(right, m_right.size() - 1)].step;
    }

    /// "column 12"; with several triangles, or a triangle that does not exist, "triangle 1, column
    /// 12".
    QString textOf(const Place &place, const std::optional<std::size_t> &triangle) const
    {
        const QString text = pixelplumb::textOf(place);
        const bool isOnlyOne
            = !m_hasSeveral && !m_right.empty() && triangle == m_right.front().primitive;
        return triangle && !isOnlyOne ? u"triangle %1, %2"_s.arg(*triangle).arg(text) : text;
    }
    QString textOf(const RightLine &line) const { return textOf(line.place, line.primitive); }

    QString unexpectedText(std::size_t line) const
    {
        const Key key = keyOf(m_trace.lines[line]);
        const auto found = m_places.find(key);
        if (found == m_places.end())
            return textOf(key.first, key.second) + u" is there, should not be"_s;
        const std::size_t times = found->second.size();
        return textOf(key.first, key.second)
            + (times == 1 ? u" comes twice, should come once"_s
                          : u" comes once more, should come %1 times"_s.arg(times));
    }

    QString numbersText(const WrittenLine &line, const RightLine &right) const
    {
        const std::vector<WrittenNumber> numbers = m_trace.numbersOf(line);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const WrittenNumber &is = numbers[i];
            const Quantity &number = right.numbers[i];
            const bool isByte = !line.axis && is.isWhole;
            if (isByte ? isRightByte(is, number, right.drift) : isRight(is, number, right.drift))
                continue;
            const Quantity should
                = isByte ? Quantity::integer(byteOf(number.toDouble(), m_rounding)) : number;
            return u"%1, %2: %3%4, should be %5"_s.arg(textOf(right), titleOf(line.axis, i),
                                                       is.text, originOf(is.value.toDouble()),
                                                       term(should));
        }
        return {};
    }

    /// An error in the level may carry it past the middle between two bytes.
    bool isRightByte(const WrittenNumber &is, const Quantity &level, double drift) const
    {
        const double byte = is.value.toDouble();
        return byte >= byteOf(level.toDouble() - drift, m_rounding)
            && byte <= byteOf(level.toDouble() + drift, m_rounding);
    }

    /// Where the program reverses its direction in a triangle, whichever end it began at, or goes
    /// back among triangles.
    std::optional<std::pair<QString, std::size_t>> orderDifference() const
    {
        constexpr int forward = 1;
        const RightLine *before = nullptr;
        int direction = 0; // of the triangle, given by its first two lines
        for (const auto &match : m_matches) {
            const RightLine &after = m_right[*match];
            if (!std::get<0>(after.place) || !after.isAskedFor)
                continue;
            const RightLine *last = std::exchange(before, &after);
            if (!last)
                continue;
            const int step = last < &after ? forward : -forward;
            const bool isSameTriangle = last->primitive == after.primitive;
            if (!isSameTriangle)
                direction = 0;
            else if (direction == 0)
                direction = step;
            if (step != (isSameTriangle ? direction : forward))
                return std::pair(
                    u"the numbers are right, the order is another: %1 "
                    "comes after %2, should come before it"_s.arg(textOf(after), textOf(*last)),
                    after.step);
        }
        return std::nullopt;
    }

    const ProgramTrace &m_trace;
    std::vector<RightLine> m_right;
    ByteRounding m_rounding;
    TraceExtent m_extent = TraceExtent::Whole;
    bool m_hasSeveral = false; ///< triangles
    std::map<Key, std::vector<std::size_t>> m_places; ///< indices of right lines, ascending
    std::vector<std::optional<std::size_t>> m_matches; ///< by the program's lines
    std::vector<bool> m_isMatched; ///< by right lines
};

/// The error of a triangle that does not exist, if one is named; its lines are reported separately.
std::optional<std::pair<QString, std::size_t>> unknownTriangle(const ProgramTrace &trace,
                                                               const TracedScene &run)
{
    const std::size_t count = run.primitives.size();
    if (!trace.lastTriangle || *trace.lastTriangle < count)
        return std::nullopt;
    return std::pair(
        u"triangle %1 is named, the scene has %2, counted from 0"_s.arg(*trace.lastTriangle)
            .arg(count),
        std::size_t(0));
}

} // namespace

Result<std::optional<TraceDifference>> traceDifferenceOf(const Scene &scene,
                                                         const ProgramTrace &trace,
                                                         const Margin &margin, TraceExtent extent)
{
    const LineKinds &kinds = trace.kinds;
    const InputError noRun{{},
                           u"no exact run of this scene has such lines"_s,
                           u"column lines, or row lines, of triangles"_s};
    if (kinds.hasColumns && kinds.hasRows)
        return InputError{{}, u"a trace has columns and rows"_s, u"one of the two"_s};
    const auto run = scene.hasTriangles() ? rightRunOf(scene, kinds) : nullptr;
    if (!run)
        return noRun;
    TraceMatcher matcher(trace, rightLinesOf(*run, kinds, margin), scene.settings.rounding, extent);
    auto difference = matcher.firstDifference();
    if (!difference)
        difference = unknownTriangle(trace, *run);
    const bool isOnce = margin.leeway == Leeway::Once && extent == TraceExtent::Whole;
    const auto other = !difference && isOnce && kinds.hasPixels ? notDrawnOnce(trace, *run, margin)
                                                                : std::nullopt;
    if (other)
        difference = std::pair(*other, std::size_t(0));
    if (!difference)
        return std::optional<TraceDifference>();
    return std::optional(TraceDifference{difference->first, run->scene, difference->second});
}

} // namespace pixelplumb
