// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/leveldefect.h"

#include "core/grade/bugs/walkdefect.h"
#include "core/grade/scan/redrawing.h"

#include <algorithm>

namespace pixelplumb {

namespace {

struct LevelDefect {
    const char *id;
    const char *forAssistant;
    LevelOverflow overflow;
    LevelBytes bytes;
};

constexpr const char *byteQuestion
    = "How does a level from 0 to 1 become a byte? And one of exactly 1?";

bool hasFullLevel(const Scene &scene)
{
    return std::ranges::any_of(scene.triangles, [](const Triangle &triangle) {
        return std::ranges::any_of(triangle.vertices, [](const Vertex &vertex) {
            return std::ranges::count(vertex.colour.channels, 255) > 0;
        });
    });
}

} // namespace

std::vector<Defect> levelDefectsFor(const Scene &scene)
{
    if (!canBeRedrawn(scene))
        return {};
    constexpr auto clamps = LevelOverflow::Clamps;
    constexpr auto wraps = LevelOverflow::Wraps;
    constexpr auto cut = LevelRounding::Down;
    static const std::vector<LevelDefect> rows = {
        {"levels-times-254",
         "Levels from 0 to 1 are multiplied by 254 in place of 255.",
         clamps,
         {254}},
        {"levels-times-256",
         "Levels from 0 to 1 are multiplied by 256, or by 255.999, and cut to whole numbers; a "
         "level of exactly 1 becomes 255.",
         clamps,
         {256, cut}},
        {"levels-times-256-wrapping",
         "Levels from 0 to 1 are multiplied by 256 and cut to whole numbers; a level of "
         "exactly 1 wraps to 0.",
         wraps,
         {256, cut}},
        {"levels-rounded-up",
         "Levels are rounded up to whole numbers: ⌈ ⌉.",
         clamps,
         {.rounding = LevelRounding::Up}},
        {"levels-clamped-to-254",
         "Levels are clamped to 254, as by < 255 in place of ≤.",
         clamps,
         {.most = 254}},
        {"levels-halved", "All levels are half of what they should be.", clamps, {.of = 510}},
    };
    const SpanAxis axis = methodNamed(QString::fromStdString(scene.method))->spanAxis;
    std::vector<Defect> defects;
    for (const LevelDefect &row : rows) {
        const bool needsFullLevel = row.overflow == wraps || row.bytes.most < 255;
        if (needsFullLevel && !hasFullLevel(scene))
            continue; // it would draw what another defect does, or the right picture
        const auto unchanged = [](TriangleRuns &) {};
        defects.push_back(
            redrawnDefect(QString::fromLatin1(row.id), QString::fromUtf8(byteQuestion),
                          QString::fromUtf8(row.forAssistant),
                          {unchanged, row.overflow, Repainting::Over, row.bytes}, axis));
        // Truncated levels are not also rounded in another way.
        if (row.bytes.rounding != LevelRounding::OfScene)
            defects.back().choice = QString::fromLatin1(roundingChoice);
    }
    return defects;
}

} // namespace pixelplumb
