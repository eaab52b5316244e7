// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/labfamily.h"

#include "core/lab/familyshapes.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The sides are prime: widths that are powers of two make slopes that float32 adds up without any
/// error (resources/numerics.md, 2.2).
FrameSpec primeFrame()
{
    FrameSpec frame;
    frame.width = 1021;
    frame.height = 1009;
    return frame;
}

constexpr LabFamilyInfo infos[] = {
    {"random-integer", "Random, whole pixels",
     "Vertices on samples, as three clicks make them: many ties."},
    {"random-subpixel", "Random, 1/256 px", "Vertices between samples: hardly any ties."},
    {"slivers", "Slivers",
     "As long as the frame and 1 to 3 px thick: colours change by levels "
     "from pixel to pixel across."},
    {"ties", "Ties", "Edges along small whole vectors: each passes exactly through samples."},
    {"far", "Far from the origin",
     "Triangles of 8 to 60 px at (30000, 30000): products of coordinates cancel."},
    {"small", "Small triangles", "Boxes of 3 to 12 px: set-up is most of the work."},
    {"large", "Large triangles", "A quarter of the frame and more: increments add up longest."},
    {"mesh", "Mesh",
     "Triangles that share all edges, at 1/256 px, under a rule that gives every "
     "sample one owner."},
    {"own-scene", "Own scene", "The triangles of the scene in hand under its own rule."},
    {"hard-cases", "Hard cases", "The cases that were collected because methods fail in them."},
};

std::size_t chosen(StudyExtent extent, std::size_t quick, std::size_t full)
{
    return extent == StudyExtent::Quick ? quick : full;
}

void addGenerated(LabFamily &family, const FamilyRequest &request)
{
    using namespace familyshapes;
    // Each family has random numbers of its own: leaving one out changes no other.
    std::uint64_t seed = request.seed;
    for (const QChar letter : family.id)
        seed = seed * 31 + letter.unicode();
    SeededRandom random(seed);
    LabPicture picture{primeFrame(), {}, {}};
    const auto many
        = [&](std::size_t quick, std::size_t full) { return chosen(request.extent, quick, full); };
    family.isOnWholePixels = true;
    family.staysInside = true;
    if (family.id == QLatin1String("random-integer")) {
        picture.triangles = scattered(random, picture.frame, many(60, 200), unitsPerPixel);
    } else if (family.id == QLatin1String("random-subpixel")) {
        picture.triangles = scattered(random, picture.frame, many(60, 200), 1);
        family.isOnWholePixels = false;
    } else if (family.id == QLatin1String("slivers")) {
        picture.triangles = slivers(random, picture.frame, many(200, 600));
        family.motion = slidingSliver(picture.frame, many(24, 64));
    } else if (family.id == QLatin1String("ties")) {
        picture.triangles = tied(random, picture.frame, many(150, 500));
    } else if (family.id == QLatin1String("far")) {
        picture.frame.firstColumn = 30000 - 510;
        picture.frame.firstRow = 30000 - 504;
        picture.triangles = boxed(random, picture.frame, many(1000, 4000), 8, 60, 1);
        family.isOnWholePixels = false;
        family.staysInside = false;
    } else if (family.id == QLatin1String("small")) {
        picture.triangles = boxed(random, picture.frame, many(3000, 10000), 3, 12, unitsPerPixel);
    } else if (family.id == QLatin1String("large")) {
        picture.triangles = large(random, picture.frame, many(12, 40));
    } else if (family.id == QLatin1String("mesh")) {
        const int cells = int(many(40, 70));
        picture.triangles = mesh(random, picture.frame, cells, cells);
        family.isOnWholePixels = false;
        family.staysInside = false; // its rule is not the straight loops'
        family.isMesh = true;
        family.settings.fillRule = FillRule::HalfOpenColumn;
    }
    family.pictures.push_back(std::move(picture));
}

bool addScene(LabFamily &family, const Scene &scene)
{
    Primitives primitives = primitivesOnSamples(scene);
    if (primitives.triangles.empty())
        return false;
    FrameSpec frame = scene.frame;
    // The primitives are on samples now.
    frame.offScreenPoint = offScreenSample(scene.frame);
    frame.pixelCentre = PixelCentre::Integer;
    family.settings = scene.settings;
    family.pictures.push_back({frame, std::move(primitives.triangles), {}});
    return true;
}

bool addHardCases(LabFamily &family, const std::vector<HardCase> &hardCases)
{
    for (const HardCase &hardCase : hardCases) {
        if (!hardCase.triangles.empty())
            family.pictures.push_back({hardCase.canvas, hardCase.triangles, hardCase.id});
    }
    return !family.pictures.empty();
}

} // namespace

QString nameOf(StudyExtent extent)
{
    return extent == StudyExtent::Quick ? QStringLiteral("quick") : QStringLiteral("full");
}

std::size_t LabFamily::triangleCount() const
{
    std::size_t count = 0;
    for (const LabPicture &picture : pictures)
        count += picture.triangles.size();
    return count;
}

std::span<const LabFamilyInfo> labFamilies() { return infos; }

const LabFamilyInfo *labFamilyNamed(const QString &id)
{
    const auto *const found = std::ranges::find_if(
        infos, [&](const LabFamilyInfo &info) { return id == QLatin1String(info.id); });
    return found == std::end(infos) ? nullptr : found;
}

std::optional<LabFamily> makeFamily(const LabFamilyInfo &info, const FamilyRequest &request)
{
    LabFamily family;
    family.id = QString::fromLatin1(info.id);
    family.title = QString::fromUtf8(info.title);
    if (family.id == QLatin1String("own-scene")) {
        if (!request.ownScene || !addScene(family, *request.ownScene))
            return std::nullopt;
    } else if (family.id == QLatin1String("hard-cases")) {
        if (!addHardCases(family, request.hardCases))
            return std::nullopt;
    } else {
        addGenerated(family, request);
    }
    return family;
}

} // namespace pixelplumb
