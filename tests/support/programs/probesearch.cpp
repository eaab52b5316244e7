// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seededrandom.h"
#include "core/grade/diagnose/diagnosis.h"
#include "core/methods/method.h"
#include "tests/support/programs/probesheet.h"

#include <algorithm>
#include <map>

namespace pixelplumb {

namespace {

constexpr int frameSide = 48; // px

/// A random point inside the frame, in fractions of a pixel.
LatticePoint randomPlace(SeededRandom &random, int denominator, int width, int height)
{
    const Lattice unit = unitsPerPixel / denominator;
    return {random.between(denominator, std::int64_t(width - 2) * denominator) * unit,
            random.between(denominator, std::int64_t(height - 2) * denominator) * unit};
}

std::vector<Vertex> randomVertices(SeededRandom &random, int count, int denominator)
{
    std::vector<Vertex> vertices;
    for (int i = 0; i < count; ++i)
        vertices.push_back(
            {randomPlace(random, denominator, frameSide, frameSide), random.colour()});
    return vertices;
}

void add(Scene &scene, const Vertex &a, const Vertex &b, const Vertex &c)
{
    scene.triangles.push_back({{{a, b, c}}});
}

/// Adds a rectangle of two triangles: edges along rows, columns and a diagonal.
void addRectangle(Scene &scene, SeededRandom &random)
{
    const std::vector<Vertex> corners = randomVertices(random, 2, 1);
    const Vertex other{{corners[0].position.x, corners[1].position.y}, random.colour()};
    const Vertex last{{corners[1].position.x, corners[0].position.y}, random.colour()};
    add(scene, corners[0], corners[1], other);
    add(scene, corners[1], corners[0], last);
}

/// Adds a long edge whose slope has a small odd denominator, so that samples lie on it.
void addTies(Scene &scene, SeededRandom &random)
{
    scene.frame.width = 2 * frameSide;
    const std::int64_t divisor = 2 * random.between(1, 6) + 1;
    const std::int64_t length = divisor * ((2 * frameSide - 4) / divisor);
    const std::int64_t rise = length / divisor * random.between(1, divisor - 1);
    const LatticePoint from = latticePixel(1, random.between(1, 8));
    const LatticePoint to = {from.x + length * unitsPerPixel,
                             from.y + std::min<std::int64_t>(rise, frameSide - 10) * unitsPerPixel};
    add(scene, {from, random.colour()}, {to, random.colour()},
        {randomPlace(random, 1, 2 * frameSide, frameSide), random.colour()});
}

/// Moves whole coordinates onto samples, whatever the pixel centre.
void placeOnSamples(Scene &scene)
{
    const Lattice offset = sampleOffset(scene.frame);
    const auto move = [offset](Vertex &vertex) {
        vertex.position.x += offset;
        vertex.position.y += offset;
    };
    for (Triangle &triangle : scene.triangles)
        std::ranges::for_each(triangle.vertices, move);
    for (Shape &shape : scene.shapes)
        std::ranges::for_each(shape.vertices, move);
}

void addTriangles(Scene &scene, SeededRandom &random)
{
    constexpr std::array<int, 4> denominators = {1, 2, 16, 256};
    const std::int64_t kind = random.between(0, 6);
    if (kind == 5)
        return addRectangle(scene, random);
    if (kind == 6)
        return addTies(scene, random);
    const int denominator = denominators[std::size_t(random.between(0, 3))];
    const std::vector<Vertex> vertices = randomVertices(random, 4, denominator);
    add(scene, vertices[0], vertices[1], vertices[2]);
    if (kind > 2)
        add(scene, vertices[1], vertices[2], vertices[3]);
}

void addLines(Scene &scene, SeededRandom &random)
{
    Shape ordinary; // as on the slides: to the right, upward, not steep
    const std::int64_t length = random.between(9, frameSide - 12);
    const std::int64_t rise = random.between(2, length - 2);
    ordinary.vertices = {{latticePixel(2, 3), random.colour()},
                         {latticePixel(2 + length, 3 + rise), random.colour()}};
    scene.shapes.push_back(ordinary);
    const std::int64_t count = random.between(1, 4);
    for (std::int64_t i = 0; i < count; ++i) {
        Shape line;
        line.vertices = randomVertices(random, 2, 1);
        scene.shapes.push_back(line);
    }
}

Scene randomScene(const Scene &conventions, SeededRandom &random)
{
    Scene scene;
    scene.frame.width = frameSide;
    scene.frame.height = frameSide;
    scene.frame.origin = conventions.frame.origin;
    scene.frame.pixelCentre = conventions.frame.pixelCentre;
    scene.method = conventions.method;
    scene.settings = conventions.settings;
    if (methodNamed(QString::fromStdString(scene.method))->draws(PrimitiveKind::Triangle))
        addTriangles(scene, random);
    else
        addLines(scene, random);
    placeOnSamples(scene);
    return scene;
}

/// An FNV-1a hash of the colours.
std::uint64_t digestOf(const Picture &picture)
{
    std::uint64_t digest = 14695981039346656037U;
    for (const Colour &colour : picture.colours) {
        for (const std::uint8_t channel : colour.channels)
            digest = (digest ^ channel) * 1099511628211U;
    }
    return digest;
}

using Classes = std::map<QString, std::size_t>; ///< by defect; "" is the right picture

/// Splits the classes by what the scene shows; returns their new number.
std::size_t split(const Classes &before, const std::map<QString, std::uint64_t> &digests,
                  Classes &after)
{
    std::map<std::pair<std::size_t, std::uint64_t>, std::size_t> numbers;
    for (const auto &[id, number] : before) {
        const auto found = digests.find(id);
        const std::uint64_t digest = (found != digests.end() ? found : digests.find({}))->second;
        after[id] = numbers.emplace(std::pair(number, digest), numbers.size()).first->second;
    }
    return numbers.size();
}

using Digests = std::vector<std::map<QString, std::uint64_t>>; ///< by scene

Classes classesBy(const std::vector<std::size_t> &scenes, const Digests &digests, Classes classes)
{
    for (const std::size_t scene : scenes) {
        Classes after;
        split(classes, digests[scene], after);
        classes = std::move(after);
    }
    return classes;
}

/// Replaces two of the scenes by one that tells as many classes apart together with the others, if
/// there is one.
bool exchangeTwo(std::vector<std::size_t> &chosen, const Digests &digests, const Classes &all,
                 std::size_t apart)
{
    for (std::size_t first = 0; first < chosen.size(); ++first) {
        for (std::size_t second = first + 1; second < chosen.size(); ++second) {
            std::vector<std::size_t> others = chosen;
            others.erase(others.begin() + std::ptrdiff_t(second));
            others.erase(others.begin() + std::ptrdiff_t(first));
            const Classes before = classesBy(others, digests, all);
            for (std::size_t scene = 0; scene < digests.size(); ++scene) {
                Classes after;
                if (split(before, digests[scene], after) < apart)
                    continue;
                chosen = std::move(others);
                chosen.push_back(scene);
                return true;
            }
        }
    }
    return false;
}

} // namespace

std::vector<Scene> searchProbes(const Scene &conventions, std::uint64_t seed, int candidates)
{
    SeededRandom random(seed);
    std::vector<Scene> scenes;
    Digests digests;
    Classes classes = {{QString(), 0}};
    while (std::ssize(scenes) < candidates) {
        const Scene scene = randomScene(conventions, random);
        auto &ofScene = digests.emplace_back();
        ofScene[{}] = digestOf(pictureOf(scene));
        for (const Defect &defect : defectsFor(scene)) {
            if (defect.isRightAlone)
                continue;
            ofScene[defect.id] = digestOf(pictureWith(scene, std::span(&defect, 1)));
            classes[defect.id] = 0;
        }
        scenes.push_back(scene);
    }
    const Classes all = classes;
    std::vector<std::size_t> chosen;
    std::size_t apart = 1;
    for (std::optional<std::size_t> best;; best.reset()) {
        Classes bestClasses;
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            Classes after;
            const std::size_t count = split(classes, digests[i], after);
            if (count > apart) {
                best = i;
                apart = count;
                bestClasses = std::move(after);
            }
        }
        if (!best)
            break;
        chosen.push_back(*best);
        classes = std::move(bestClasses);
    }
    constexpr std::size_t few = 4; // scenes, as many as a person draws
    while (chosen.size() > few && exchangeTwo(chosen, digests, all, apart)) { }
    std::vector<Scene> sheet;
    for (const std::size_t scene : chosen)
        sheet.push_back(scenes[scene]);
    return sheet;
}

} // namespace pixelplumb
