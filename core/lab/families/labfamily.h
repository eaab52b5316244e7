// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/hardcase.h"
#include "core/scene/scene.h"

#include <memory>
#include <optional>
#include <vector>

namespace pixelplumb {

/// How much a study covers: 20 seconds or five minutes on two idle processors.
enum class StudyExtent : std::uint8_t { Quick, Full };
QString nameOf(StudyExtent extent); ///< "quick", "full"

/// Triangles drawn one by one on one frame. In sample coordinates.
struct LabPicture {
    FrameSpec frame;
    std::vector<Triangle> triangles;
    QString name; ///< of a hard case; else empty
};

/// Triangles of one kind. Kinds are never averaged: they rank the methods differently.
struct LabFamily {
    QString id; ///< "ties"
    QString title; ///< "Ties"
    std::vector<LabPicture> pictures; ///< one, except in hard cases
    ScanSettings settings; ///< the requested rule and rounding
    bool isMesh = false; ///< drawn under a rule that gives every sample one owner
    std::vector<Triangle> motion = {}; ///< the same triangle from frame to frame; for flicker

    std::size_t triangleCount() const;
};

/// What families are made of. The same request makes the same triangles on every machine.
struct FamilyRequest {
    std::uint64_t seed = 1;
    StudyExtent extent = StudyExtent::Quick;
    std::shared_ptr<const Scene> ownScene; ///< for the family own-scene; may be null
    std::vector<HardCase> hardCases = {}; ///< for the family hard-cases
};

/// A row of the table of families.
struct LabFamilyInfo {
    const char *id;
    const char *title;
    const char *stresses; ///< one sentence: what is hard about it
    /// Adds the pictures and the family's special members. False if the request has nothing for it.
    bool (*make)(LabFamily &family, const FamilyRequest &request);
};
std::span<const LabFamilyInfo> labFamilies();
const LabFamilyInfo *labFamilyNamed(const QString &id);

/// None if the request has nothing for it: no own scene, no hard cases.
std::optional<LabFamily> makeFamily(const LabFamilyInfo &info, const FamilyRequest &request);

} // namespace pixelplumb
