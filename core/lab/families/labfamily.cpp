// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/families/labfamily.h"

#include "core/lab/families/familyshapes.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The sides are prime: widths that are powers of two give slopes that float32 adds up without
/// error (resources/numerics.md, 2.2).
FrameSpec primeFrame()
{
    FrameSpec frame;
    frame.width = 1021;
    frame.height = 1009;
    return frame;
}

std::size_t chosen(StudyExtent extent, std::size_t quick, std::size_t full)
{
    return extent == StudyExtent::Quick ? quick : full;
}

/// Each family has its own random numbers: leaving one out changes no other.
SeededRandom randomOf(const LabFamily &family, const FamilyRequest &request)
{
    std::uint64_t seed = request.seed;
    for (const QChar letter : family.id)
        seed = seed * 31 + letter.unicode();
    return SeededRandom(seed);
}

bool take(LabFamily &family, const FrameSpec &frame, std::vector<Triangle> triangles)
{
    family.pictures.push_back({frame, std::move(triangles), {}});
    return true;
}

bool makeRandomInteger(LabFamily &family, const FamilyRequest &request)
{
    SeededRandom random = randomOf(family, request);
    const std::size_t count = chosen(request.extent, 60, 200);
    return take(family, primeFrame(),
                familyshapes::scattered(random, primeFrame(), count, unitsPerPixel));
}

bool makeRandomSubpixel(LabFamily &family, const FamilyRequest &request)
{
    SeededRandom random = randomOf(family, request);
    const std::size_t count = chosen(request.extent, 60, 200);
    take(family, primeFrame(), familyshapes::scattered(random, primeFrame(), count, 1));
    return true;
}

bool makeSlivers(LabFamily &family, const FamilyRequest &request)
{
    SeededRandom random = randomOf(family, request);
    const std::size_t count = chosen(request.extent, 200, 600);
    family.motion = familyshapes::slidingSliver(primeFrame(), chosen(request.extent, 24, 64));
    return take(family, primeFrame(), familyshapes::slivers(random, primeFrame(), count));
}

bool makeTies(LabFamily &family, const FamilyRequest &request)
{
    SeededRandom random = randomOf(family, request);
    const std::size_t count = chosen(request.extent, 150, 500);
    return take(family, primeFrame(), familyshapes::tied(random, primeFrame(), count));
}

bool makeFar(LabFamily &family, const FamilyRequest &request)
{
    SeededRandom random = randomOf(family, request);
    FrameSpec frame = primeFrame();
    frame.firstColumn = 30000 - 510;
    frame.firstRow = 30000 - 504;
    const std::size_t count = chosen(request.extent, 1000, 4000);
    take(family, frame, familyshapes::boxed(random, frame, count, 8, 60, 1));
    return true;
}

bool makeSmall(LabFamily &family, const FamilyRequest &request)
{
    SeededRandom random = randomOf(family, request);
    const std::size_t count = chosen(request.extent, 3000, 10000);
    return take(family, primeFrame(),
                familyshapes::boxed(random, primeFrame(), count, 3, 12, unitsPerPixel));
}

bool makeLarge(LabFamily &family, const FamilyRequest &request)
{
    SeededRandom random = randomOf(family, request);
    const std::size_t count = chosen(request.extent, 12, 40);
    return take(family, primeFrame(), familyshapes::large(random, primeFrame(), count));
}

bool makeMesh(LabFamily &family, const FamilyRequest &request)
{
    SeededRandom random = randomOf(family, request);
    const auto cells = int(chosen(request.extent, 40, 70));
    take(family, primeFrame(), familyshapes::mesh(random, primeFrame(), cells, cells));
    family.isMesh = true;
    family.settings.fillRule = FillRule::HalfOpenColumn;
    return true;
}

bool makeOwnScene(LabFamily &family, const FamilyRequest &request)
{
    if (!request.ownScene)
        return false;
    const Scene &scene = *request.ownScene;
    Primitives primitives = primitivesOnSamples(scene);
    if (primitives.triangles.empty())
        return false;
    FrameSpec frame = scene.frame;
    // The primitives are now in sample coordinates.
    frame.offScreenPoint = offScreenSample(scene.frame);
    frame.pixelCentre = PixelCentre::Integer;
    family.settings = scene.settings;
    family.pictures.push_back({frame, std::move(primitives.triangles), {}});
    return true;
}

bool makeHardCases(LabFamily &family, const FamilyRequest &request)
{
    for (const HardCase &hardCase : request.hardCases) {
        if (!hardCase.triangles.empty())
            family.pictures.push_back({hardCase.canvas, hardCase.triangles, hardCase.id});
    }
    return !family.pictures.empty();
}

constexpr LabFamilyInfo infos[] = {
    {"random-integer", QT_TRANSLATE_NOOP("core", "Random, whole pixels"),
     "Vertices on samples, as three clicks make them: many ties.", makeRandomInteger},
    {"random-subpixel", "Random, 1/256 px", "Vertices between samples: hardly any ties.",
     makeRandomSubpixel},
    {"slivers", QT_TRANSLATE_NOOP("core", "Slivers"),
     "As long as the frame and 1 to 3 px thick: colours change by levels "
     "from pixel to pixel across.",
     makeSlivers},
    {"ties", QT_TRANSLATE_NOOP("core", "Ties"),
     "Edges along small whole vectors: each passes exactly through samples.", makeTies},
    {"far", QT_TRANSLATE_NOOP("core", "Far from the origin"),
     "Triangles of 8 to 60 px at (30000, 30000): products of coordinates cancel.", makeFar},
    {"small", QT_TRANSLATE_NOOP("core", "Small triangles"),
     "Boxes of 3 to 12 px: set-up is most of the work.", makeSmall},
    {"large", QT_TRANSLATE_NOOP("core", "Large triangles"),
     "A quarter of the frame and more: increments add up longest.", makeLarge},
    {"mesh", QT_TRANSLATE_NOOP("core", "Mesh"),
     "Triangles that share all edges, at 1/256 px, under a rule that gives every "
     "sample one owner.",
     makeMesh},
    {"own-scene", QT_TRANSLATE_NOOP("core", "Own scene"),
     "The triangles of the current scene under its own rule.", makeOwnScene},
    {"hard-cases", QT_TRANSLATE_NOOP("core", "Hard cases"),
     "The cases that were collected because methods fail in them.", makeHardCases},
};

} // namespace

QString nameOf(StudyExtent extent) { return extent == StudyExtent::Quick ? u"quick"_s : u"full"_s; }

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
    if (!info.make(family, request))
        return std::nullopt;
    return family;
}

} // namespace pixelplumb
