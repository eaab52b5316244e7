// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/fields/numberreader.h"
#include "core/scene/fields/referredfiles.h"

namespace pixelplumb {

/// Reads a scene's solids; its materials must be known already. Errors stay with the JsonReader.
class SolidReader {
public:
    SolidReader(JsonReader &json, NumberReader &numbers, ReferredFiles &files,
                const std::vector<Material> &materials)
        : m_json(json)
        , m_numbers(numbers)
        , m_files(files)
        , m_materials(materials)
    {
    }

    Solid read(const JsonNode &primitive, SolidKind kind);

private:
    void readCorners(const JsonNode &primitive, Solid &solid);
    void readPlane(const JsonNode &primitive, Solid &solid);
    void readSphere(const JsonNode &primitive, Solid &solid);
    void readPatch(const JsonNode &primitive, Solid &solid);
    void readMesh(const JsonNode &primitive, Solid &solid);
    void readSegments(const JsonNode &node, const std::array<int, 2> &least, Solid &solid);
    void readCornerColours(const JsonNode &primitive, Solid &solid);
    void checkPolygon(const JsonNode &node, const Solid &solid);
    void checkReach(const JsonNode &node, const Vector3 &centre, double radius);

    JsonReader &m_json;
    NumberReader &m_numbers;
    ReferredFiles &m_files;
    const std::vector<Material> &m_materials;
};

} // namespace pixelplumb
