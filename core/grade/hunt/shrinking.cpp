// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/hunt/counterexample.h"

#include <algorithm>
#include <array>

namespace pixelplumb {

namespace {

void forEachVertex(Scene &scene, const std::function<void(Vertex &vertex)> &change)
{
    for (Triangle &triangle : scene.triangles)
        std::ranges::for_each(triangle.vertices, change);
    for (Shape &shape : scene.shapes)
        std::ranges::for_each(shape.vertices, change);
}

/// How complicated a scene is; earlier entries count more.
using Burden = std::array<std::int64_t, 5>;

Burden burdenOf(const Scene &scene)
{
    Burden burden{std::ssize(scene.triangles) + std::ssize(scene.shapes),
                  std::int64_t(scene.frame.width) * scene.frame.height, 0, 0, 0};
    Scene counted = scene;
    forEachVertex(counted, [&burden](const Vertex &vertex) {
        for (const Lattice coordinate : {vertex.position.x, vertex.position.y}) {
            for (Lattice unit = unitsPerPixel; coordinate % unit != 0; unit /= 2)
                ++burden[2];
            burden[3] += coordinate;
        }
        for (const std::uint8_t channel : vertex.colour.channels)
            burden[4] += channel == 255 ? 0 : channel == 0 ? 1 : 2;
    });
    return burden;
}

/// Scenes one step away that may be simpler.
std::vector<Scene> simplerOnes(const Scene &scene)
{
    std::vector<Scene> simpler;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        Scene &fewer = simpler.emplace_back(scene);
        fewer.triangles.erase(fewer.triangles.begin() + std::ptrdiff_t(i));
    }
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        Scene &fewer = simpler.emplace_back(scene);
        fewer.shapes.erase(fewer.shapes.begin() + std::ptrdiff_t(i));
    }
    const auto change = [&](const std::function<void(Vertex & vertex)> &ofAll) {
        forEachVertex(simpler.emplace_back(scene), ofAll);
    };
    change([](Vertex &vertex) { vertex.position.x -= unitsPerPixel; });
    change([](Vertex &vertex) { vertex.position.y -= unitsPerPixel; });
    change([](Vertex &vertex) { vertex.colour = {{255, 255, 255}}; });
    // Vertices at one position move together, so that shared edges stay shared.
    std::vector<Vertex> places;
    Scene read = scene;
    forEachVertex(read, [&places](const Vertex &vertex) { places.push_back(vertex); });
    const auto changeAt = [&](const LatticePoint &place, const LatticePoint &to) {
        change([=](Vertex &vertex) {
            if (vertex.position == place)
                vertex.position = to;
        });
    };
    for (const Vertex &vertex : places) {
        const LatticePoint &at = vertex.position;
        for (const Lattice unit : {unitsPerPixel, unitsPerPixel / 2, unitsPerPixel / 16}) {
            for (const Lattice more : {Lattice(0), unit}) {
                changeAt(at, {floorDivide(at.x, unit) * unit + more, at.y});
                changeAt(at, {at.x, floorDivide(at.y, unit) * unit + more});
            }
            changeAt(at, {at.x - unit, at.y});
            changeAt(at, {at.x, at.y - unit});
        }
        for (std::size_t channel = 0; channel < 3; ++channel) {
            for (const int level : {255, 0}) {
                change([=](Vertex &changed) {
                    if (changed == vertex)
                        changed.colour.channels[channel] = std::uint8_t(level);
                });
            }
        }
    }
    return simpler;
}

bool isInFrame(const Scene &scene)
{
    bool isInside = true;
    Scene read = scene;
    forEachVertex(read, [&isInside](const Vertex &vertex) {
        isInside = isInside && vertex.position.x >= 0 && vertex.position.y >= 0;
    });
    return isInside;
}

} // namespace

CounterExample shrunk(CounterExample example, const PictureSource &one, const PictureSource &other,
                      const ProgressListener &listener)
{
    std::int64_t tried = 0;
    for (bool isSimpler = true; isSimpler;) {
        isSimpler = false;
        const Burden burden = burdenOf(example.scene);
        for (const Scene &scene : simplerOnes(example.scene)) {
            if (!isInFrame(scene))
                continue;
            if (!goesOn(listener, {JobPhase::Shrinking, ++tried, 0}))
                return example;
            SceneTrial trial = tryScene(one, other, scene);
            if (trial.example && burdenOf(trial.example->scene) < burden) {
                example = std::move(*trial.example);
                isSimpler = true;
                break;
            }
        }
    }
    return example;
}

} // namespace pixelplumb
