// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/affinemap.h"

#include "core/geometry/triangle.h"
#include "core/layers/cellnumber.h"
#include "core/number/widequantity.h"

#include <QPointF>
#include <QRectF>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

// The default images' box as a share of the frame's, along the side where the share is larger.
constexpr double leastShare = 0.3;
constexpr double largestShare = 0.55;
constexpr double margin = 1.5; ///< px from the frame's border

using Places = std::array<QPointF, 3>;

BigRational crossProduct(const RationalPoint &origin, const RationalPoint &a,
                         const RationalPoint &b)
{
    return (a.x - origin.x) * (b.y - origin.y) - (b.x - origin.x) * (a.y - origin.y);
}

QRectF boxOf(const Places &places)
{
    const auto [left, right] = std::ranges::minmax(places, {}, &QPointF::x);
    const auto [low, high] = std::ranges::minmax(places, {}, &QPointF::y);
    return {QPointF(left.x(), low.y()), QPointF(right.x(), high.y())};
}

/// Rotated by 45° and sheared, around the origin.
QPointF turned(const QPointF &place)
{
    return {0.5 * place.x() - 0.75 * place.y(), 0.5 * place.x() + 0.25 * place.y()};
}

/// Where a box of this size can be in the frame so that it is farthest from a place.
QPointF farthestCentre(const QRectF &frame, const QSizeF &size, const QPointF &place)
{
    const double x = std::max(0.0, frame.width() - size.width()) / 2;
    const double y = std::max(0.0, frame.height() - size.height()) / 2;
    QPointF farthest = frame.center();
    for (const QPointF &way : {QPointF(x, -y), QPointF(x, 0), QPointF(x, y), QPointF(0, y),
                               QPointF(0, -y), QPointF(-x, y), QPointF(-x, 0), QPointF(-x, -y)}) {
        const QPointF before = farthest - place;
        const QPointF after = frame.center() + way - place;
        if (std::hypot(after.x(), after.y()) > std::hypot(before.x(), before.y()) + 1e-9)
            farthest = frame.center() + way;
    }
    return farthest;
}

Corners onLattice(const Places &places, Lattice step)
{
    Corners corners;
    std::ranges::transform(places, corners.begin(), [step](const QPointF &place) {
        const double units = double(unitsPerPixel) / double(step);
        return LatticePoint{Lattice(std::llround(place.x() * units)) * step,
                            Lattice(std::llround(place.y() * units)) * step};
    });
    return corners;
}

Int128 doubledArea(const Corners &corners)
{
    return doubledArea(corners[0], corners[1], corners[2]);
}

/// Sheared by whole numbers, which preserves the smallest area.
Corners sheared(const Corners &corners)
{
    Corners images;
    std::ranges::transform(corners, images.begin(), [&corners](const LatticePoint &corner) {
        const Lattice x = corner.x - corners[0].x;
        const Lattice y = corner.y - corners[0].y;
        return LatticePoint{corners[0].x + x - y, corners[0].y + x};
    });
    return images;
}

/// How the numbers of a sentence are shown: if one of their fractions is longer than this, in
/// characters, all are rounded to this many places.
struct NumberStyle {
    qsizetype longestFraction;
    int places;
};
constexpr NumberStyle compared = {13, 6}; ///< weights and coefficients
constexpr NumberStyle beside = {9, 3}; ///< places and areas

Quantity quantityOf(const BigRational &number)
{
    return quotientOf(numerator(number), denominator(number));
}

/// "−3/7"; empty if it is longer than the style allows.
QString fractionOf(const BigRational &number, const NumberStyle &style)
{
    const Quantity quantity = quantityOf(number);
    if (!quantity.isRational())
        return {};
    QString fraction = toText(quantity.numerator());
    if (quantity.denominator() != 1)
        fraction += u'/' + toText(quantity.denominator());
    return fraction.size() <= style.longestFraction ? withMinus(fraction) : QString();
}

/// The numbers of one sentence, which are all exact or all rounded.
class ShownNumbers {
public:
    ShownNumbers(std::initializer_list<BigRational> numbers, const NumberStyle &style)
    {
        for (const BigRational &number : numbers)
            m_texts += fractionOf(number, style);
        m_isRounded = m_texts.contains(QString());
        if (!m_isRounded)
            return;
        m_texts.clear();
        for (const BigRational &number : numbers)
            m_texts += withMinus(toDecimal(quantityOf(number), style.places));
    }

    const QString &operator[](qsizetype i) const { return m_texts[i]; }
    /// "≈ " before a rounded number.
    QString mark() const { return m_isRounded ? u"≈ "_s : QString(); }
    /// Between a name and its number.
    QString equals() const { return m_isRounded ? u"≈"_s : u"="_s; }

private:
    QStringList m_texts;
    bool m_isRounded = false;
};

QChar signOf(const BigRational &number) { return number < 0 ? QChar(0x2212) : u'+'; }

} // namespace

RationalPoint rationalPoint(const LatticePoint &point)
{
    return {BigRational(point.x, unitsPerPixel), BigRational(point.y, unitsPerPixel)};
}

RationalPoint AffineMap::of(const RationalPoint &point) const
{
    return {xx * point.x + xy * point.y + shift.x, yx * point.x + yy * point.y + shift.y};
}

AffineMap affineMapOf(const Corners &corners, const Corners &images)
{
    const RationalPoint origin = rationalPoint(corners[0]);
    const RationalPoint a = rationalPoint(corners[1]);
    const RationalPoint b = rationalPoint(corners[2]);
    const RationalPoint image = rationalPoint(images[0]);
    const RationalPoint imageA = rationalPoint(images[1]);
    const RationalPoint imageB = rationalPoint(images[2]);
    // Maps the two edges from the first corner to those of the image; Cramer's rule.
    const BigRational whole = crossProduct(origin, a, b);
    const auto rates = [&](const BigRational &first, const BigRational &second) {
        return RationalPoint{(first * (b.y - origin.y) - second * (a.y - origin.y)) / whole,
                             (second * (a.x - origin.x) - first * (b.x - origin.x)) / whole};
    };
    const RationalPoint x = rates(imageA.x - image.x, imageB.x - image.x);
    const RationalPoint y = rates(imageA.y - image.y, imageB.y - image.y);
    return {x.x,
            x.y,
            y.x,
            y.y,
            {image.x - x.x * origin.x - x.y * origin.y, image.y - y.x * origin.x - y.y * origin.y}};
}

PointAreas pointAreas(const Corners &corners, const RationalPoint &point)
{
    const RationalPoint a = rationalPoint(corners[0]);
    const RationalPoint b = rationalPoint(corners[1]);
    const RationalPoint c = rationalPoint(corners[2]);
    return {{crossProduct(point, b, c), crossProduct(point, c, a), crossProduct(point, a, b)},
            crossProduct(a, b, c)};
}

Corners defaultImages(const Corners &corners, const FrameSpec &frame)
{
    const double offset = double(sampleOffset(frame)) / unitsPerPixel - 0.5;
    const QRectF room
        = QRectF(frame.firstColumn + offset, frame.firstRow + offset, frame.width, frame.height)
              .adjusted(margin, margin, -margin, -margin);
    Places places;
    QPointF middle;
    for (const LatticePoint &corner : corners)
        middle += QPointF(double(corner.x), double(corner.y)) / (3 * double(unitsPerPixel));
    std::ranges::transform(corners, places.begin(), [](const LatticePoint &corner) {
        return turned(QPointF(double(corner.x), double(corner.y)) / double(unitsPerPixel));
    });
    const QRectF box = boxOf(places);
    const double share = std::max({box.width() / frame.width, box.height() / frame.height, 1e-12});
    const double scale = std::clamp(1.0, leastShare / share, largestShare / share);
    const QPointF centre = farthestCentre(room, box.size() * scale, middle);
    for (QPointF &place : places)
        place = centre + (place - box.center()) * scale;
    for (const Lattice step : {unitsPerPixel, Lattice(1)}) {
        if (const Corners images = onLattice(places, step); doubledArea(images) != 0)
            return images;
    }
    return sheared(corners);
}

Corners imagesOf(const LayerView &view, std::size_t triangle)
{
    if (view.image && view.image->triangle == triangle)
        return view.image->corners;
    const FrameSpec &frame = view.traced->scene.frame;
    Corners corners;
    std::ranges::transform(
        view.traced->primitives.triangles[triangle].vertices, corners.begin(),
        [&frame](const Vertex &vertex) {
            const Lattice offset = sampleOffset(frame);
            return LatticePoint{vertex.position.x + offset, vertex.position.y + offset};
        });
    return defaultImages(corners, frame);
}

QString pointText(const RationalPoint &point)
{
    const ShownNumbers numbers({point.x, point.y}, beside);
    return u"%1(%2, %3)"_s.arg(numbers.mark(), numbers[0], numbers[1]);
}

QStringList rowsText(const AffineMap &map)
{
    const ShownNumbers numbers(
        {map.xx, abs(map.xy), abs(map.shift.x), map.yx, abs(map.yy), abs(map.shift.y)}, compared);
    const QString row = "%1 %2 %3·x %4 %5·y %6 %7";
    return {row.arg(u"Affine map: x′"_s, numbers.equals(), numbers[0], signOf(map.xy), numbers[1],
                    signOf(map.shift.x), numbers[2]),
            row.arg(u"and y′"_s, numbers.equals(), numbers[3], signOf(map.yy), numbers[4],
                    signOf(map.shift.y), numbers[5])};
}

QString weightsText(const PointAreas &areas)
{
    const ShownNumbers numbers({areas.weight(0), areas.weight(1), areas.weight(2)}, compared);
    return u"α %1 %2, β %1 %3, γ %1 %4"_s.arg(numbers.equals(), numbers[0], numbers[1], numbers[2]);
}

QString areasText(const PointAreas &areas)
{
    const ShownNumbers numbers({areas.parts[0], areas.parts[1], areas.parts[2], areas.whole},
                               beside);
    return u"Doubled areas: %1%2, %3, %4 of %5"_s.arg(numbers.mark(), numbers[0], numbers[1],
                                                      numbers[2], numbers[3]);
}

QString areasChangeText(const AffineMap &map)
{
    const BigRational factor = map.determinant();
    const ShownNumbers number({factor}, compared);
    const QString same
        = u"The weights stay, all areas are multiplied by %1"_s.arg(number.mark() + number[0]);
    return factor < 0 ? same + u": the map mirrors"_s : same;
}

} // namespace pixelplumb
