// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/rounding/linechoice.h"

#include "core/frame/framebuffer.h"
#include "core/methods/method.h"
#include "core/scan/errorlimit.h"
#include "core/scan/lines/linebresenham.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr double largestProved = 65536; // px
constexpr double levelsOfAByte = 256;

double pixels(Lattice coordinate) { return double(coordinate) / double(unitsPerPixel); }

/// A coordinate of a point of the line, px.
struct ExactPlace {
    Int128 numerator = 0;
    Int128 denominator = 1;

    /// The coordinate at `step` of `steps` on the way from one to the other.
    static ExactPlace between(Lattice from, Lattice to, const Int128 &step, const Int128 &steps)
    {
        return {from * steps + step * (to - from), steps * unitsPerPixel};
    }
    /// The nearest pixel, of two the upper one, then those to which it is as near up to the error.
    std::vector<std::int64_t> nearest(double error) const
    {
        const Int128 doubled = 2 * numerator + denominator;
        const auto above = std::int64_t(floorDivide<Int128>(doubled, 2 * denominator));
        const Int128 rest = doubled - 2 * denominator * above;
        std::vector<std::int64_t> found = {above};
        const double down = double(rest) / double(2 * denominator); // from the lower half
        for (std::int64_t i = 1; down + double(i - 1) <= error; ++i)
            found.push_back(above - i);
        for (std::int64_t i = 1; 1 - down + double(i - 1) <= error; ++i)
            found.push_back(above + i);
        return found;
    }
};

/// The largest errors of a right program on one line.
struct LineErrors {
    double across = 0; ///< px
    double level = 0;
};

/// `steps`: from end to end.
LineErrors errorsOf(const Vertex &from, const Vertex &to, double steps, Arithmetic arithmetic)
{
    if (arithmetic == Arithmetic::Exact)
        return {};
    const double unit = std::ldexp(1.0, arithmetic == Arithmetic::Float32 ? -24 : -53);
    const auto larger = [](Lattice one, Lattice other) {
        return std::max(std::abs(pixels(one)), std::abs(pixels(other)));
    };
    const double along = larger(from.position.x, to.position.x);
    const double across = larger(from.position.y, to.position.y);
    if (std::max(along, across) > largestProved)
        return {};
    const double rise = std::abs(pixels(to.position.y - from.position.y));
    const double run = std::max(std::abs(pixels(to.position.x - from.position.x)), 1.0);
    const double byAdding = errorLimit(arithmetic, steps + 1, across, rise);
    const double byEquation = unit * (3 * rise + 3 * along * rise / run + 2 * across);
    const double byParameter = unit * (rise * (steps + 3) + 3 * across);
    constexpr double ofProducts = 1.001;
    const double ofHalf = unit * (across + 1);
    return {ofProducts * (std::max({byAdding, byEquation, byParameter}) + ofHalf),
            ofProducts
                * (errorLimit(arithmetic, steps + 1, levelsOfAByte, levelsOfAByte)
                   + unit * levelsOfAByte * (steps + 6))};
}

std::array<LevelRange, 3> levelsAt(const Vertex &from, const Vertex &to, double share, double error)
{
    constexpr double ownError = 1e-9; // of these doubles
    std::array<LevelRange, 3> found;
    const std::array<double, 3> level = levelsBetween(from, to, share);
    for (std::size_t i = 0; i < 3; ++i)
        found[i] = {level[i] - error - ownError, level[i] + error + ownError};
    return found;
}

bool isMethod(const Scene &scene, std::string_view id) { return scene.method == id; }

const Method &methodOf(const Scene &scene)
{
    return *methodNamed(QString::fromStdString(scene.method));
}

/// Steps by whole columns, or rows of a steep line.
std::vector<LineChoice> stepsByPixel(Vertex from, Vertex to, const Scene &scene,
                                     Arithmetic arithmetic)
{
    if (methodOf(scene).roundsPoints) {
        from = onPixel(from);
        to = onPixel(to);
    }
    const bool isEquation = isMethod(scene, "line-slope-intercept");
    const LineAxis axis = isEquation ? LineAxis::X : lineAxisOf(from.position, to.position);
    from = exchanged(from, axis);
    to = exchanged(to, axis);
    if (to.position.x < from.position.x)
        std::swap(from, to);
    const Lattice run = to.position.x - from.position.x;
    if (isEquation && run == 0)
        return {};
    const LineErrors errors = errorsOf(from, to, pixels(run), arithmetic);
    const StepRange steps
        = StepRange{ceilPixel(from.position.x), floorPixel(to.position.x) + 1}.clippedTo(
            StepRange::along(windowOf(scene.frame), axis));
    std::vector<LineChoice> choices;
    for (std::int64_t along = steps.first; along < steps.end; ++along) {
        const Lattice step = along * unitsPerPixel - from.position.x;
        const Lattice whole = std::max<Lattice>(run, 1);
        const auto place
            = ExactPlace::between(from.position.y, to.position.y, run > 0 ? step : 0, whole);
        std::vector<std::int64_t> across = place.nearest(errors.across);
        if (isEquation && across.front() < 0) // where (int) rounds towards 0
            across.push_back(across.front() + 1);
        LineChoice choice;
        for (const std::int64_t each : across)
            choice.pixels.push_back(axis == LineAxis::X ? LatticePoint{along, each}
                                                        : LatticePoint{each, along});
        choice.levels
            = levelsAt(from, to, run > 0 ? double(step) / double(whole) : 0, errors.level);
        choices.push_back(std::move(choice));
    }
    return choices;
}

/// Steps by a parameter, along both coordinates.
std::vector<LineChoice> stepsByParameter(const Vertex &from, const Vertex &to, const Scene &scene,
                                         Arithmetic arithmetic)
{
    const LineAxis axis = lineAxisOf(from.position, to.position);
    const Vertex a = exchanged(from, axis);
    const Vertex b = exchanged(to, axis);
    const Lattice run = b.position.x - a.position.x;
    const std::int64_t steps = std::max<std::int64_t>(1, ceilPixel(absolute(run)));
    StepRange shown = {0, steps + 1};
    if (run != 0) {
        const StepRange frame = StepRange::along(windowOf(scene.frame), axis);
        const auto stepAt = [&](std::int64_t pixel) {
            return std::int64_t(floorDivide<Int128>((Int128(pixel) * unitsPerPixel - a.position.x)
                                                        * (run > 0 ? steps : -steps),
                                                    absolute(run)));
        };
        const auto [first, last] = std::minmax({stepAt(frame.first - 2), stepAt(frame.end + 2)});
        shown = StepRange{first - 1, last + 2}.clippedTo(shown);
    }
    const LineErrors errors = errorsOf(a, b, double(steps), arithmetic);
    std::vector<LineChoice> choices;
    for (std::int64_t step = shown.first; step < shown.end; ++step) {
        const auto placeOf = [&](Lattice start, Lattice end) {
            return ExactPlace::between(start, end, step, steps).nearest(errors.across);
        };
        const auto columns = placeOf(from.position.x, to.position.x);
        const auto rows = placeOf(from.position.y, to.position.y);
        LineChoice choice;
        for (const std::int64_t y : rows) {
            for (const std::int64_t x : columns)
                choice.pixels.push_back({x, y});
        }
        choice.levels = levelsAt(from, to, double(step) / double(steps), errors.level);
        choices.push_back(std::move(choice));
    }
    return choices;
}

} // namespace

std::array<double, 3> levelsBetween(const Vertex &from, const Vertex &to, double share)
{
    std::array<double, 3> between = {};
    for (std::size_t i = 0; i < 3; ++i)
        between[i] = from.colour.channels[i]
            + share * (double(to.colour.channels[i]) - from.colour.channels[i]);
    return between;
}

bool LineChoice::mayHave(const Colour &colour, ByteRounding rounding) const
{
    for (std::size_t i = 0; i < 3; ++i) {
        if (!levels[i].hasByte(colour.channels[i], rounding))
            return false;
    }
    return true;
}

bool isOfLines(const Scene &scene)
{
    return !scene.shapes.empty() && !scene.hasTriangles() && !mayCallForEffects(scene)
        && std::ranges::all_of(
            scene.shapes, [](const Shape &shape) { return shape.kind == PrimitiveKind::Line; });
}

bool drawsNearestPixels(const Scene &scene)
{
    return isOfLines(scene) && scene.settings.variants.without(Variant::StayAtZero).isEmpty()
        && methodOf(scene).family == MethodFamily::Lines;
}

std::vector<LineChoice> lineChoices(const Shape &line, const Scene &scene, Arithmetic arithmetic)
{
    const Vertex &from = line.vertices[0];
    const Vertex &to = line.vertices[1];
    return isMethod(scene, "line-parametric") ? stepsByParameter(from, to, scene, arithmetic)
                                              : stepsByPixel(from, to, scene, arithmetic);
}

} // namespace pixelplumb
