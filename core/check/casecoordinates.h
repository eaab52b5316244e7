// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/hardcase.h"
#include "core/scene/text/jsonreader.h"

#include <array>

namespace pixelplumb {

/// The member of an object; a missing node where there is none.
JsonNode member(const JsonNode &node, const char *key);

/// [x, y] in whole px.
using CasePixel = std::array<std::int64_t, 2>;
CasePixel pixel(JsonReader &json, const JsonNode &node);

/// The value paired with a word in a list; the first value, and an error, if the word is not in it.
template <class Words>
auto choice(JsonReader &json, const JsonNode &node, const Words &words)
{
    QStringList names;
    for (const auto &word : words) {
        names.append(QString::fromLatin1(word.first));
        if (node.toString() == names.back())
            return word.second;
    }
    json.fail(node, describe(node), u"one of "_s + names.join(u", "_s));
    return words.front().second;
}

/// Reads a case's canvas and its coordinates, which are integers in units of 1/scale px; the
/// JsonReader keeps errors. Coordinates off the lattice are listed in the case's displacements.
class CaseCoordinates {
public:
    CaseCoordinates(JsonReader &json, HardCase &hardCase)
        : m_json(json)
        , m_case(hardCase)
    {
    }

    /// Reads "scale"; the optional one is 1 where the case has none.
    void readScale(const JsonNode &node);
    void readOptionalScale(const JsonNode &node);
    /// "canvas" and "origin", px.
    void readCanvas(const JsonNode &node);

    /// An integer of any size in units of 1/scale px, exactly.
    Lattice coordinate(const JsonNode &node);
    LatticePoint position(const JsonNode &node);

private:
    JsonReader &m_json;
    HardCase &m_case;
    QString m_scale = "1";
};

} // namespace pixelplumb
