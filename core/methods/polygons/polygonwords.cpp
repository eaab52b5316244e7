// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygons/polygonwords.h"

#include "core/methods/words/formulatext.h"

#include <QStringList>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::size_t namedEdges = 6;

QString timesText(std::int64_t count) { return count == 1 ? u"once"_s : u"%1 times"_s.arg(count); }

/// "2, 5 and 7"; only the first items of a long list.
QString listText(QStringList parts, std::size_t size)
{
    if (std::size_t(parts.size()) < size)
        return parts.join(u", "_s) + u", …"_s;
    if (parts.size() < 2)
        return parts.join(QString());
    const QString last = parts.takeLast();
    return parts.join(u", "_s) + u" and "_s + last;
}

QString edgesText(const std::vector<std::size_t> &edges)
{
    QStringList numbers;
    for (std::size_t i = 0; i < std::min(edges.size(), namedEdges); ++i)
        numbers.append(QString::number(edges[i]));
    return (edges.size() == 1 ? u"at the edge "_s : u"at the edges "_s)
        + listText(numbers, edges.size());
}

QString verdictText(const PolygonSampleState &sample)
{
    if (sample.fill == ShapeFill::NonZero)
        return u", %1 downward, %2 upward: winding number %3, %4."_s.arg(sample.downward)
            .arg(sample.upward)
            .arg(term(Quantity::integer(sample.winding)),
                 sample.isInside ? u"inside"_s : u"outside"_s);
    return sample.isInside ? u": an odd number, inside."_s : u": an even number, outside."_s;
}

} // namespace

void tellPolygon(StepWords &words, const PolygonSetUp &setUp)
{
    if (setUp.pieceCount > 0) {
        if (setUp.crossingCount > 0)
            words.sentence
                = u"Where edges cross, at %1, triangles have corners that were moved "
                  "to the nearest multiple of 1/256 px, by at most %2 px: a sample "
                  "that close to an edge may be wrong."_s
                      .arg(setUp.crossingCount == 1 ? u"1 point"_s
                                                    : u"%1 points"_s.arg(setUp.crossingCount))
                      .arg(setUp.largestMove, 0, 'g', 3);
        return;
    }
    words.sentence = setUp.fill == ShapeFill::NonZero
        ? u"Non-zero decides: a sample is inside where its winding number w, the "
          "downward crossings at it or to its left minus the upward ones, is not 0."_s
        : u"Even-odd decides: a sample is inside where the parity p of the crossings "
          "at it or to its left is 1."_s;
    if (setUp.curveCount > 0)
        words.sentence.prepend(
            u"The %1 Bézier pieces became %2 edges: chords that leave their curve by "
            "1/32 px at most. "_s.arg(setUp.curveCount)
                .arg(setUp.edgeCount));
}

void tellPolygon(StepWords &words, const PolygonRowState &row)
{
    QStringList places;
    for (const auto &crossing : row.crossings)
        places.append(term(crossing.x));
    const QString meets = u"The row crosses %1 edges, at x = %2."_s.arg(
        QString::number(row.crossingCount), listText(places, row.crossingCount));
    if (row.drawnSamples() == 0) {
        words.sentence = meets
            + u" No sample of the frame lies at or after the first of them and "
              "before the last."_s;
        return;
    }
    const QString inside = row.fill == ShapeFill::NonZero
        ? u"where downward and upward edges at it or to its left differ in number"_s
        : u"where an odd number of edges is at it or to its left"_s;
    words.sentence = meets
        + u" In columns %1 to %2 a sample is inside %3."_s.arg(row.firstDrawn)
              .arg(row.endDrawn - 1)
              .arg(inside);
}

void tellPolygon(StepWords &words, const PolygonSampleState &sample)
{
    const QString ray = u"the ray from here to the left meets the contours %1, %2"_s.arg(
        timesText(sample.crossings), edgesText(sample.edges));
    words.sentence
        = (sample.isInside ? u'T' + ray.sliced(1) : u"Refused: "_s + ray) + verdictText(sample);
}

} // namespace pixelplumb
