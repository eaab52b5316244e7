// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/readconvention.h"

#include "core/grade/diagnose/frameconvention.h"
#include "core/grade/diagnose/sampledspans.h"
#include "core/grade/pictures/picturediff.h"
#include "core/runs/scenerun.h"

#include <algorithm>
#include <limits>

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
                      u"Columns and rows are counted from 1, not from 0."_s, countFromOne)};
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

    std::int64_t all() const { return pixels + coverage; }
};

/// The pictures found, or only columns of them.
struct FoundParts {
    std::vector<FoundPicture> pictures;
    std::vector<ChosenSpans> columns; ///< of each; empty: they are whole
};

/// Columns of large pictures at equal distances, which tell nearly what the whole tells; none of
/// small ones.
std::optional<FoundParts> columnsOf(std::span<const FoundPicture> found,
                                    std::span<const Scene> scenes)
{
    constexpr int columns = 32; // of each picture
    std::size_t pixels = 0;
    FoundParts parts;
    for (const FoundPicture &each : found) {
        const FrameSpec &frame = scenes[each.scene].frame;
        pixels += each.picture.size();
        std::vector<std::int64_t> spans;
        const int count = std::min(columns, frame.width);
        for (std::int64_t i = 0; i < count; ++i)
            spans.push_back(frame.firstColumn + (2 * i + 1) * frame.width / (2 * count));
        ChosenSpans chosen(SpanAxis::Column, std::move(spans));
        parts.pictures.push_back({each.scene, partOf(each.picture, frame, chosen)});
        parts.columns.push_back(std::move(chosen));
    }
    return pixels < largePicture ? std::nullopt : std::optional(std::move(parts));
}

/// None where a scene cannot be drawn so. What is drawn is counted.
std::optional<Left> leftBy(std::span<const Scene> scenes, const FoundParts &parts,
                           DefectPictures &pictures)
{
    Left left;
    for (std::size_t i = 0; i < parts.pictures.size(); ++i) {
        const auto &[scene, found] = parts.pictures[i];
        if (!objectionTo(scenes[scene]).isEmpty())
            return std::nullopt;
        const Picture drawn = parts.columns.empty() ? pictureOf(scenes[scene])
                                                    : pictureOf(scenes[scene], parts.columns[i]);
        pictures.countPart(drawn.size());
        for (std::size_t place = 0; place < drawn.size(); ++place) {
            left.pixels += isSameAt(drawn, found, place) ? 0 : 1;
            left.coverage += drawn.covered[place] == found.covered[place] ? 0 : 1;
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

/// Whether some columns leave it open that they are read.
bool mayBeRead(const Left &left, const Left &asAsked)
{
    const bool isMuchCoverage = 40 * (asAsked.coverage - left.coverage) >= asAsked.pixels;
    return 3 * left.pixels <= 2 * asAsked.pixels
        || (isMuchCoverage && 2 * left.coverage < asAsked.coverage);
}

bool isNearer(const Left &one, const Left &other)
{
    return std::pair(one.all(), one.pixels) < std::pair(other.all(), other.pixels);
}

/// All conventions but the scenes' own.
std::vector<ReadConvention> otherConventions(const DefectPictures &pictures)
{
    std::vector<ReadConvention> conventions = {{pictures.scenes(), {}}};
    for (const auto &readings : {framesOf(), firstPixelsOf(), choicesOf(pictures, ruleChoice),
                                 choicesOf(pictures, roundingChoice)}) {
        std::vector<ReadConvention> further;
        for (const ReadConvention &convention : conventions) {
            for (const Reading &reading : readings) {
                further.push_back(convention);
                if (!reading)
                    continue;
                further.back().told.push_back(*reading);
                for (Scene &scene : further.back().scenes)
                    reading->changeScene(scene);
            }
        }
        conventions = std::move(further);
    }
    std::erase_if(conventions,
                  [](const ReadConvention &convention) { return convention.told.empty(); });
    return conventions;
}

/// Leaves those that columns of the pictures do not refuse: that may be read, and leave hardly more
/// than the one that leaves least.
void refuseByColumns(std::vector<ReadConvention> &conventions, const FoundParts &columns,
                     DefectPictures &pictures)
{
    const auto leftAsAsked = leftBy(pictures.scenes(), columns, pictures);
    std::vector<std::pair<Left, ReadConvention>> kept;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (ReadConvention &convention : conventions) {
        const auto left = leftBy(convention.scenes, columns, pictures);
        if (!left || !mayBeRead(*left, *leftAsAsked))
            continue;
        least = std::min(least, left->all());
        kept.emplace_back(*left, std::move(convention));
    }
    conventions.clear();
    for (auto &[left, convention] : kept) {
        if (left.all() <= least + least / 8 + 8)
            conventions.push_back(std::move(convention));
    }
}

} // namespace

std::optional<ReadConvention> readConvention(DefectPictures &pictures,
                                             std::span<const FoundPicture> found)
{
    const bool areOfTriangles = std::ranges::all_of(pictures.scenes(), [](const Scene &scene) {
        return !scene.triangles.empty() && scene.solids.empty() && !scene.motion;
    });
    const FoundParts whole{{found.begin(), found.end()}, {}};
    const auto asAsked = areOfTriangles ? leftBy(pictures.scenes(), whole, pictures) : std::nullopt;
    if (!asAsked)
        return std::nullopt;
    std::vector<ReadConvention> conventions = otherConventions(pictures);
    if (const auto columns = columnsOf(found, pictures.scenes()))
        refuseByColumns(conventions, *columns, pictures);
    Left least = *asAsked;
    std::optional<ReadConvention> read;
    for (ReadConvention &convention : conventions) {
        const auto left = leftBy(convention.scenes, whole, pictures);
        if (left && areRead(*left, *asAsked) && isNearer(*left, least)) {
            least = *left;
            read = std::move(convention);
        }
    }
    return read;
}

} // namespace pixelplumb
