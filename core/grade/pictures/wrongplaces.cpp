// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/pictures/wrongplaces.h"

#include "core/frame/framebuffer.h"

#include <algorithm>
#include <functional>

namespace pixelplumb {

namespace {

struct PicturePlace {
    int x = 0, line = 0; ///< of the picture, from its top left pixel on
};

/// Something that may be true of wrong pixels.
struct Whereabouts {
    const char *text;
    std::function<bool(const PicturePlace &place)> holds;
};

/// The covered pixels of the right picture, as seen from others.
class CoveredPixels {
public:
    explicit CoveredPixels(const Picture &picture)
        : m_picture(picture)
    {
    }

    /// Whether any pixel that way is covered.
    bool goesOn(PicturePlace place, int right, int down) const
    {
        do {
            place.x += right;
            place.line += down;
        } while (m_picture.contains(place.x, place.line) && !isCovered(place));
        return m_picture.contains(place.x, place.line);
    }

private:
    bool isCovered(const PicturePlace &place) const
    {
        return m_picture.covered[m_picture.placeOf(place.x, place.line)] != 0;
    }

    const Picture &m_picture;
};

std::vector<PicturePlace> placesOf(const PictureDiff &diff, Difference verdict)
{
    std::vector<PicturePlace> places;
    for (int line = 0; line < diff.height; ++line) {
        for (int x = 0; x < diff.width; ++x) {
            const auto place = std::size_t(line) * std::size_t(diff.width) + std::size_t(x);
            if (diff.verdicts[place] == verdict)
                places.push_back({x, line});
        }
    }
    return places;
}

/// The sides on which the shape does not go on.
std::vector<Whereabouts> sidesOf(const CoveredPixels &shape, Difference verdict)
{
    const bool isMissing = verdict == Difference::Missing;
    const auto beyond = [&shape](int right, int down) {
        return [&shape, right, down](const PicturePlace &place) {
            return !shape.goesOn(place, right, down) && shape.goesOn(place, -right, -down);
        };
    };
    return {
        {isMissing ? "at the right ends of their rows" : "right of what their rows should have",
         beyond(1, 0)},
        {isMissing ? "at the left ends of their rows" : "left of what their rows should have",
         beyond(-1, 0)},
        {isMissing ? "at the upper ends of their columns" : "above what their columns should have",
         beyond(0, -1)},
        {isMissing ? "at the lower ends of their columns" : "below what their columns should have",
         beyond(0, 1)}};
}

/// "column 12", "columns 3 to 40".
QString rangeText(const char *one, std::int64_t first, std::int64_t last)
{
    const QString name = QString::fromLatin1(one);
    return first == last
        ? u"%1 %2"_s.arg(name, QString::number(first))
        : u"%1s %2 to %3"_s.arg(name, QString::number(first), QString::number(last));
}

QString boxText(const std::vector<PicturePlace> &places, const FrameSpec &frame)
{
    const auto [left, right] = std::ranges::minmax_element(places, {}, &PicturePlace::x);
    const auto [top, bottom] = std::ranges::minmax_element(places, {}, &PicturePlace::line);
    const auto [least, most]
        = std::minmax({rowOfPictureLine(frame, top->line), rowOfPictureLine(frame, bottom->line)});
    const QString columns
        = rangeText("column", frame.firstColumn + left->x, frame.firstColumn + right->x);
    const QString rows = rangeText("row", least, most);
    if (left->x == right->x || top->line == bottom->line)
        return left->x == right->x ? columns + u", "_s + rows : rows + u", "_s + columns;
    return columns + u" and "_s + rows;
}

/// Which of the statements holds for most of the places: for all, or for nine tenths.
QString sideText(const std::vector<PicturePlace> &places, const std::vector<Whereabouts> &sides)
{
    std::ptrdiff_t most = 0;
    const Whereabouts *best = nullptr;
    for (const Whereabouts &side : sides) {
        const auto count = std::ranges::count_if(places, side.holds);
        if (count > most) {
            most = count;
            best = &side;
        }
    }
    const auto all = std::ptrdiff_t(places.size());
    if (!best || 10 * most < 9 * all)
        return {};
    const QString text = QString::fromLatin1(best->text);
    return most == all ? u"all "_s + text : u"%1 of them "_s.arg(most) + text;
}

} // namespace

QStringList wrongPlaces(const PictureDiff &diff, const Picture &expected, const FrameSpec &frame)
{
    const CoveredPixels shape(expected);
    QStringList sentences;
    for (const auto &[verdict, what] :
         {std::pair(Difference::Missing, "missing"), std::pair(Difference::Extra, "extra"),
          std::pair(Difference::Colour, "of another colour")}) {
        const std::vector<PicturePlace> places = placesOf(diff, verdict);
        if (places.empty())
            continue;
        const QString side
            = verdict == Difference::Colour ? QString() : sideText(places, sidesOf(shape, verdict));
        const QString count
            = places.size() == 1 ? u"1 pixel is"_s : u"%1 pixels are"_s.arg(places.size());
        sentences += u"%1 %2: %3%4"_s.arg(count, QString::fromLatin1(what),
                                          side.isEmpty() ? QString() : side + u", in "_s,
                                          boxText(places, frame));
    }
    return sentences;
}

} // namespace pixelplumb
