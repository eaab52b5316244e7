// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listings/listingrun.h"

#include <QRegularExpression>

#include <algorithm>
#include <utility>

namespace pixelplumb {

namespace {

QString withoutRemark(const QString &line) { return line.section(u" — "_s, 0, 0); }

ListingState::Asked askedBy(const QString &line)
{
    return line.section(u" — "_s, 1).contains(u"exact"_s) ? ListingState::Asked::Exact
                                                          : ListingState::Asked::AsComputed;
}

} // namespace

void ListingRun::computeIn(Arithmetic arithmetic)
{
    const bool isAnyExact = std::ranges::any_of(m_code, [](const PseudocodeLine &line) {
        return askedBy(line.text) == ListingState::Asked::Exact;
    });
    m_state.computeIn(arithmetic,
                      isAnyExact ? ListingState::Asked::Exact : ListingState::Asked::AsComputed);
}

void ListingRun::run() { runBlock(0, m_code.size()); }

/// One past the lines below a line that are nested in it.
std::size_t ListingRun::endOfBlock(std::size_t line) const
{
    std::size_t end = line + 1;
    while (end < m_code.size() && m_code[end].depth > m_code[line].depth)
        ++end;
    return end;
}

void ListingRun::runBlock(std::size_t first, std::size_t end)
{
    for (std::size_t line = first; line < end && !m_state.leaves(); line = endOfBlock(line))
        runLine(line);
}

void ListingRun::runLine(std::size_t line)
{
    const QString &listed = m_code[line].text;
    if (listed.startsWith(u"if no"_s)) // "sample is to be drawn: done", where none would be
        return;
    const QString text = m_state.meant(withoutRemark(listed));
    m_state.ask(askedBy(listed));
    if (runLoop(line, text) || runCase(line, text) || setBox(text))
        return;
    m_ran.push_back(line);
    m_state.run(text);
}

/// One round of a loop.
void ListingRun::runRound(std::size_t line)
{
    m_hasCase = false;
    m_ran.clear();
    runBlock(line + 1, endOfBlock(line));
    if (const auto place = m_state.takeWritten())
        m_linesOfPixels[*place] = m_ran;
    m_state.takesLeave();
}

/// False if the line is no loop.
bool ListingRun::runLoop(std::size_t line, const QString &text)
{
    const QString during = u"while "_s;
    if (text.startsWith(during)) {
        const QString statements = text.section(u':', 1).trimmed();
        while (m_state.holds(text.sliced(during.size()).section(u':', 0, 0))) {
            if (statements.isEmpty())
                runRound(line);
            else
                m_state.run(statements);
        }
        return true;
    }
    return text.startsWith(u"for each "_s) && !text.startsWith(u"for each carried "_s)
        && (runBox(line, text) || runColumns(line, text) || runEdges(line, text)
            || runArcs(line, text) || runTriangles(line, text) || runMetItems(text)
            || runItems(line, text) || runRange(line, text));
}

/// False if the line is no box.
bool ListingRun::setBox(const QString &text)
{
    static const QRegularExpression ofBox(
        u"^box ← (?:the whole frame|x from (.+) to (.+), y likewise, clipped to the frame)$"_s),
        coordinate(u"x(?=[₀-₂_])"_s);
    if (!text.startsWith(u"box ← "_s))
        return false;
    const auto match = ofBox.match(text);
    if (!match.hasMatch())
        throw ListingFault(u"no box: "_s + text);
    m_box = m_frame;
    const auto clip = [&](const QString &axis, std::int64_t &first, std::int64_t &end) {
        const auto valueOf = [&](int part) {
            return m_state.valueOf(match.captured(part).replace(coordinate, axis))
                .convert_to<std::int64_t>();
        };
        if (!match.captured(1).isEmpty()) {
            first = std::max(first, valueOf(1));
            end = std::min(end, valueOf(2) + 1);
        }
        m_state.set(axis + u"_min"_s, first);
    };
    clip(u"x"_s, m_box.firstX, m_box.endX);
    clip(u"y"_s, m_box.firstY, m_box.endY);
    return true;
}

bool ListingRun::runBox(std::size_t line, const QString &text)
{
    static const QRegularExpression ofBox(u"^for each (x|y) of the box:$"_s);
    const auto match = ofBox.match(text);
    if (!match.hasMatch())
        return false;
    const bool isX = match.captured(1) == u"x"_s;
    const std::int64_t end = isX ? m_box.endX : m_box.endY;
    for (std::int64_t at = isX ? m_box.firstX : m_box.firstY; at < end; ++at) {
        m_state.set(match.captured(1), Number(at));
        runRound(line);
    }
    return true;
}

bool ListingRun::runRange(std::size_t line, const QString &text)
{
    static const QRegularExpression ofRange(
        u"^for each (?:\\w+ )?(\\S+)(?: = i/(\\S+))?( of the frame)? from (.+?)( "
        "down)? to (.+):$"_s,
        QRegularExpression::UseUnicodePropertiesOption);
    const auto match = ofRange.match(text);
    if (!match.hasMatch())
        return false;
    const Number size
        = match.captured(2).isEmpty() ? Number(1) : Number(1) / m_state.valueOf(match.captured(2));
    const bool isDown = !match.captured(5).isEmpty();
    const Number step = isDown ? Number(-size) : size;
    Number first = m_state.valueOf(match.captured(4)), last = m_state.valueOf(match.captured(6));
    if (!match.captured(3).isEmpty()) {
        m_state.set(match.captured(1) + u"_first"_s, first);
        const auto [least, greatest] = m_state.frameAlong(match.captured(1));
        first = isDown ? std::min(first, Number(greatest)) : std::max(first, Number(least));
        last = isDown ? std::max(last, Number(least)) : std::min(last, Number(greatest));
    }
    const bool wasFirst = std::exchange(m_isFirst, true);
    const ListingNames known
        = text.startsWith(u"for each sample "_s) ? m_state.names() : ListingNames();
    for (Number at = first; isDown ? at >= last : at <= last; at += step) {
        m_state.set(match.captured(1), at);
        if (!match.captured(2).isEmpty())
            m_state.set(u"i"_s, Number(at / size));
        runRound(line);
        m_state.keepOnly(known);
        m_isFirst = false;
    }
    m_isFirst = wasFirst;
    return true;
}

/// The columns for which there is a smallest y.
bool ListingRun::runColumns(std::size_t line, const QString &text)
{
    if (text != u"for each column x of the outline:"_s)
        return false;
    for (const Number &column : m_state.indicesOf(u"y_low"_s)) {
        m_state.set(u"x"_s, column);
        runRound(line);
    }
    return true;
}

bool ListingRun::runEdges(std::size_t line, const QString &text)
{
    static const QRegularExpression ofEdges(u"^for each edge L_ij of ([^:]+):(?: (.+))?$"_s);
    static const QRegularExpression ofValues(u"^for each value v of ([^:]+): (.+)$"_s),
        value(u"(?<![A-Za-z])v(?![A-Za-z])"_s);
    if (const auto match = ofValues.match(text); match.hasMatch()) {
        for (const QString &letter : match.captured(1).split(u", "_s))
            m_state.run(match.captured(2).replace(value, letter));
        return true;
    }
    const auto match = ofEdges.match(text);
    if (!match.hasMatch())
        return false;
    for (const QString &edge : match.captured(1).split(u", "_s)) {
        m_state.setEdge(edge.sliced(1));
        if (match.captured(2).isEmpty())
            runRound(line);
        else
            m_state.run(m_state.meant(match.captured(2)));
    }
    m_state.setEdge({});
    return true;
}

bool ListingRun::runArcs(std::size_t line, const QString &text)
{
    static const QRegularExpression ofArcs(
        u"^for each arc \\((.+)\\) of \\((.+)\\) and, if (.+), \\((.+)\\):$"_s);
    const auto match = ofArcs.match(text);
    if (!match.hasMatch())
        return false;
    const bool hasSecond = m_state.holds(match.captured(3));
    for (const int arc : {2, 4}) {
        if (arc == 4 && !hasSecond)
            break;
        m_state.run(match.captured(1) + assigns + match.captured(arc));
        runRound(line);
    }
    return true;
}

/// False if the line is no case.
bool ListingRun::runCase(std::size_t line, const QString &text)
{
    const QString first = u"the first:"_s, begins = u"where it begins: "_s, otherwise = u"else:"_s,
                  ifElse = u"else if "_s, onlyIf = u"if "_s;
    bool isTaken = false;
    if (text.startsWith(first))
        isTaken = m_isFirst;
    else if (text.startsWith(begins))
        isTaken = !m_state.knows(
            text.sliced(begins.size()).section(assigns, 0, 0).section(u", "_s, 0, 0));
    else if (text.startsWith(otherwise))
        isTaken = !m_hasCase;
    else if (text.startsWith(ifElse))
        isTaken = !m_hasCase && m_state.holds(text.sliced(ifElse.size()).section(u':', 0, 0));
    else if (text.startsWith(onlyIf))
        isTaken = m_state.holds(text.sliced(onlyIf.size()).section(u':', 0, 0));
    else
        return false;
    if (isTaken)
        m_ran.push_back(line);
    const bool hadCase = m_hasCase && text.startsWith(u'e');
    const QString statements = text.section(u':', 1).trimmed();
    if (isTaken && !statements.isEmpty())
        m_state.run(statements);
    if (isTaken)
        runBlock(line + 1, endOfBlock(line));
    m_hasCase = isTaken || hadCase;
    return true;
}

} // namespace pixelplumb
