// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/readconvention.h"

#include "core/grade/diagnose/frameconvention.h"
#include "core/grade/pictures/picturediff.h"
#include "core/runs/scenerun.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// One of the ways to read a scene: otherwise than it says, or as it says.
using Reading = std::optional<Defect>;

Defect readingOf(const char *id, const char *forStudent, const QString &forAssistant,
                 const std::function<void(Scene &scene)> &change)
{
    return {.id = QString::fromLatin1(id),
            .forStudent = QString::fromUtf8(forStudent),
            .forAssistant = forAssistant,
            .changeScene = [change](Scene &scene) {
                change(scene);
                return true;
            }};
}

std::vector<Reading> framesOf()
{
    constexpr std::array ids = {"", "other-origin", "other-centre", "other-origin-and-centre"};
    std::vector<Reading> readings;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const FrameConvention convention = allFrameConventions[i];
        if (convention == FrameConvention::AsAsked) {
            readings.push_back(std::nullopt);
            continue;
        }
        QString sentence = sentenceOf(convention);
        sentence[0] = sentence[0].toUpper();
        readings.push_back(readingOf(
            ids[i], "From which side are rows counted, and where in a pixel is its sample?",
            sentence + u'.', [convention](Scene &scene) { scene = sceneIn(scene, convention); }));
    }
    return readings;
}

std::vector<Reading> firstPixelsOf()
{
    const auto countFromOne = [](Scene &scene) {
        for (Triangle &triangle : scene.triangles) {
            for (Vertex &vertex : triangle.vertices)
                vertex.position
                    = {vertex.position.x - unitsPerPixel, vertex.position.y - unitsPerPixel};
        }
    };
    return {std::nullopt,
            readingOf("counted-from-1",
                      "Which number has the first pixel of a row, and the first row?",
                      QStringLiteral("Columns and rows are counted from 1, not from 0; judged by "
                                     "that convention."),
                      countFromOne)};
}

/// The scene's own rule, or rounding, and the others, as the catalogue tells them.
std::vector<Reading> choicesOf(const DefectPictures &pictures, const char *choice)
{
    std::vector<Reading> readings = {std::nullopt};
    for (const Defect &defect : pictures.defects()) {
        if (defect.choice == QLatin1String(choice) && defect.changeScene)
            readings.push_back(defect);
    }
    return readings;
}

/// What pictures under some conventions leave.
struct Left {
    std::int64_t pixels = 0; ///< wrong ones
    std::int64_t coverage = 0; ///< pixels that are drawn and should not be, or the reverse
};

std::optional<Left> leftBy(std::span<const Scene> scenes, std::span<const FoundPicture> found)
{
    Left left;
    for (const FoundPicture &each : found) {
        if (!objectionTo(scenes[each.scene]).isEmpty())
            return std::nullopt;
        const Picture drawn = pictureOf(scenes[each.scene]);
        for (std::size_t place = 0; place < drawn.size(); ++place) {
            left.pixels += isSameAt(drawn, each.picture, place) ? 0 : 1;
            left.coverage += drawn.covered[place] == each.picture.covered[place] ? 0 : 1;
        }
    }
    return left;
}

/// Whether conventions explain much that the scenes' own do not: half of what is wrong, or nearly
/// all of the coverage that is, if that is more than a few pixels beside wrong colours.
bool areRead(const Left &left, const Left &asAsked)
{
    const bool isMuchCoverage = 20 * (asAsked.coverage - left.coverage) >= asAsked.pixels;
    return 2 * left.pixels <= asAsked.pixels
        || (isMuchCoverage && 4 * left.coverage < asAsked.coverage);
}

bool isNearer(const Left &one, const Left &other)
{
    return std::pair(one.pixels + one.coverage, one.pixels)
        < std::pair(other.pixels + other.coverage, other.pixels);
}

} // namespace

std::optional<ReadConvention> readConvention(DefectPictures &pictures,
                                             std::span<const FoundPicture> found)
{
    const bool areOfTriangles = std::ranges::all_of(pictures.scenes(), [](const Scene &scene) {
        return !scene.triangles.empty() && scene.solids.empty() && !scene.motion;
    });
    const auto asAsked = areOfTriangles ? leftBy(pictures.scenes(), found) : std::nullopt;
    if (!asAsked)
        return std::nullopt;
    Left least = *asAsked;
    std::optional<ReadConvention> read;
    for (const Reading &frame : framesOf()) {
        for (const Reading &first : firstPixelsOf()) {
            for (const Reading &rule : choicesOf(pictures, ruleChoice)) {
                for (const Reading &rounding : choicesOf(pictures, roundingChoice)) {
                    ReadConvention tried{pictures.scenes(), {}};
                    for (const Reading *each : {&frame, &first, &rule, &rounding}) {
                        if (!*each)
                            continue;
                        tried.told.push_back(**each);
                        for (Scene &scene : tried.scenes)
                            (*each)->changeScene(scene);
                    }
                    if (tried.told.empty())
                        continue; // as asked
                    const auto left = leftBy(tried.scenes, found);
                    if (left && areRead(*left, *asAsked) && isNearer(*left, least)) {
                        least = *left;
                        read = std::move(tried);
                    }
                }
            }
        }
    }
    return read;
}

} // namespace pixelplumb
