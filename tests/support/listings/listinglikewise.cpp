// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listings/listinglanguage.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <vector>

namespace pixelplumb {

namespace {

const QString likewise = u" likewise"_s;

/// Replaces one of three names by the next one: "bc" → "ca".
struct Cycle {
    std::array<QString, 3> each;
    QString before, after; ///< what must surround the name; an empty `after` means the name's end

    qsizetype stepAt(const QString &text, qsizetype place, QString &result) const
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const QString whole = before + each[i] + after;
            if (!QStringView(text).sliced(place).startsWith(whole))
                continue;
            const qsizetype end = place + whole.size();
            const bool ends = !after.isEmpty() || end == text.size() || !belongsToName(text[end]);
            if (!before.isEmpty() && !ends)
                continue;
            result += before + each[(i + 1) % 3] + after;
            return whole.size();
        }
        return 0;
    }
};

QString turned(const QString &text, const std::vector<Cycle> &cycles)
{
    QString result;
    for (qsizetype place = 0; place < text.size();) {
        qsizetype taken = 0;
        for (const Cycle &cycle : cycles) {
            if ((taken = cycle.stepAt(text, place, result)) > 0)
                break;
        }
        if (taken == 0)
            result += text[place];
        place += std::max<qsizetype>(taken, 1);
    }
    return result;
}

/// The text with the next edge, its vertices and the weight of the opposite vertex.
QString nextEdge(const QString &text)
{
    const QString none, bar = u"_"_s, open = u"("_s, close = u")"_s;
    return turned(text,
                  {{{u"bc"_s, u"ca"_s, u"ab"_s}, bar, none},
                   {{u"a"_s, u"b"_s, u"c"_s}, bar, none},
                   {{u"A"_s, u"B"_s, u"C"_s}, bar, none},
                   {{u"a"_s, u"b"_s, u"c"_s}, open, close},
                   {{u"₀"_s, u"₁"_s, u"₂"_s}, none, none},
                   {{u"α"_s, u"β"_s, u"γ"_s}, none, none}});
}

/// Whether a name starts here, whatever change (Δ or δ) it may be of.
bool startsName(const QString &text, qsizetype place)
{
    const QChar before = place == 0 ? QChar(u' ') : text[place - 1];
    return before == u'Δ' || before == u'δ' || !belongsToName(before);
}

/// What is done to a coordinate along an edge, done to a value: y₀₂ → R₀₂, m₀₂ → δR₀₂. The
/// coordinate is the first one that the text names. Conditions stay.
QString coordinateAs(const QString &value, const QString &text)
{
    static const QRegularExpression firstCoordinate(u"[xy]"_s);
    const qsizetype first = text.indexOf(firstCoordinate);
    if (first < 0)
        return text;
    const QChar coordinate = text[first];
    QString result;
    bool isCondition = false;
    for (qsizetype place = 0; place < text.size(); ++place) {
        const QStringView rest = QStringView(text).sliced(place);
        isCondition = rest.startsWith(u" if "_s) || (isCondition && !rest.startsWith(u", else "_s));
        const bool isTurned
            = !isCondition && startsName(text, place) && rest.size() > 1 && belongsToName(rest[1]);
        if (isTurned && rest[0] == u'm')
            result += u'δ' + value;
        else
            result += isTurned && rest[0] == coordinate ? value : QString(rest[0]);
    }
    return result;
}

/// The text with the next channel: R, R_a, R₀, ΔR_x; R after a coordinate.
QString nextChannel(const QString &text)
{
    if (u"xym"_s.contains(text.front()))
        return coordinateAs(u"R"_s, text);
    const QString letters = u"RGB"_s;
    QString result = text;
    for (qsizetype place = 0; place < text.size(); ++place) {
        const qsizetype channel = letters.indexOf(text[place]);
        if (channel >= 0 && startsName(text, place))
            result[place] = letters[(channel + 1) % 3];
    }
    return result;
}

/// Whether a name of the text begins with these letters.
bool hasName(const QString &text, const QString &letters)
{
    qsizetype place = text.indexOf(letters);
    while (place >= 0 && !startsName(text, place))
        place = text.indexOf(letters, place + 1);
    return place >= 0;
}

} // namespace

QStringList spelledOut(const QString &text, const QStringList &carried)
{
    QStringList parts;
    for (const QString &part : text.split(u"; "_s)) {
        if (!part.endsWith(likewise)) {
            parts.append(part);
            continue;
        }
        if (parts.isEmpty())
            throw ListingFault(u"like what: "_s + text);
        const QString pattern = parts.constLast();
        if (part.contains(u"each carried value"_s)) {
            for (const QString &value : carried)
                parts.append(coordinateAs(value, pattern));
            continue;
        }
        const QStringList names
            = part.chopped(likewise.size()).replace(u" and "_s, u", "_s).split(u", "_s);
        QString edge = pattern, channel = pattern;
        for (const QString &name : names) {
            edge = nextEdge(edge);
            channel = nextChannel(channel);
            const bool isEdge = edge != pattern && hasName(edge, name);
            if (!isEdge && (channel == pattern || !hasName(channel, name)))
                throw ListingFault(u"no “%1” in: %2"_s.arg(name, text));
            parts.append(isEdge ? edge : channel);
        }
    }
    return parts;
}

} // namespace pixelplumb
