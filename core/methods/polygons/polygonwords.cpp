// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygons/polygonwords.h"

#include "core/methods/words/formulatext.h"

#include <QStringList>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::size_t namedEdges = 6;

QString timesText(std::int64_t count)
{
    return count == 1 ? QStringLiteral("once") : QStringLiteral("%1 times").arg(count);
}

/// "2, 5 and 7"; only the first items of a long list.
QString listText(QStringList parts, std::size_t size)
{
    if (std::size_t(parts.size()) < size)
        return parts.join(QStringLiteral(", ")) + QStringLiteral(", …");
    if (parts.size() < 2)
        return parts.join(QString());
    const QString last = parts.takeLast();
    return parts.join(QStringLiteral(", ")) + QStringLiteral(" and ") + last;
}

QString edgesText(const std::vector<std::size_t> &edges)
{
    QStringList numbers;
    for (std::size_t i = 0; i < std::min(edges.size(), namedEdges); ++i)
        numbers.append(QString::number(edges[i]));
    return (edges.size() == 1 ? QStringLiteral("at the edge ") : QStringLiteral("at the edges "))
        + listText(numbers, edges.size());
}

QString verdictText(const PolygonSampleState &sample)
{
    if (sample.fill == ShapeFill::NonZero)
        return QStringLiteral(", %1 downward, %2 upward: winding number %3, %4.")
            .arg(sample.downward)
            .arg(sample.upward)
            .arg(term(Quantity::integer(sample.winding)),
                 sample.isInside ? QStringLiteral("inside") : QStringLiteral("outside"));
    return sample.isInside ? QStringLiteral(": an odd number, inside.")
                           : QStringLiteral(": an even number, outside.");
}

} // namespace

void tellPolygon(StepWords &words, const PolygonSetUp &setUp)
{
    if (setUp.pieceCount > 0) {
        if (setUp.crossingCount > 0)
            words.sentence
                = QStringLiteral("Where edges cross, at %1, triangles have corners that were moved "
                                 "to the nearest multiple of 1/256 px, by at most %2 px: a sample "
                                 "that close to an edge may be wrong.")
                      .arg(setUp.crossingCount == 1
                               ? QStringLiteral("1 point")
                               : QStringLiteral("%1 points").arg(setUp.crossingCount))
                      .arg(setUp.largestMove, 0, 'g', 3);
        return;
    }
    words.sentence = setUp.fill == ShapeFill::NonZero
        ? QStringLiteral("Non-zero decides: a sample is inside where its winding number w, the "
                         "downward crossings at it or to its left minus the upward ones, is not 0.")
        : QStringLiteral("Even-odd decides: a sample is inside where the parity p of the crossings "
                         "at it or to its left is 1.");
    if (setUp.curveCount > 0)
        words.sentence.prepend(
            QStringLiteral("The %1 Bézier pieces became %2 edges: chords that leave their curve by "
                           "1/32 px at most. ")
                .arg(setUp.curveCount)
                .arg(setUp.edgeCount));
}

void tellPolygon(StepWords &words, const PolygonRowState &row)
{
    QStringList places;
    for (const auto &crossing : row.crossings)
        places.append(term(crossing.x));
    const QString meets
        = QStringLiteral("The row crosses %1 edges, at x = %2.")
              .arg(QString::number(row.crossingCount), listText(places, row.crossingCount));
    if (row.drawnSamples() == 0) {
        words.sentence = meets
            + QStringLiteral(" No sample of the frame lies at or after the first of them and "
                             "before the last.");
        return;
    }
    const QString inside = row.fill == ShapeFill::NonZero
        ? QStringLiteral("where downward and upward edges at it or to its left differ in number")
        : QStringLiteral("where an odd number of edges is at it or to its left");
    words.sentence = meets
        + QStringLiteral(" In columns %1 to %2 a sample is inside %3.")
              .arg(row.firstDrawn)
              .arg(row.endDrawn - 1)
              .arg(inside);
}

void tellPolygon(StepWords &words, const PolygonSampleState &sample)
{
    const QString ray = QStringLiteral("the ray from here to the left meets the contours %1, %2")
                            .arg(timesText(sample.crossings), edgesText(sample.edges));
    words.sentence = (sample.isInside ? u'T' + ray.sliced(1) : QStringLiteral("Refused: ") + ray)
        + verdictText(sample);
}

} // namespace pixelplumb
