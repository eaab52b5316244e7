// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"
#include "core/scene/coordinatetext.h"
#include "core/scene/scene.h"

#include <vector>

namespace pixelplumb {

/// The format that this program writes, and the newest that it reads.
inline constexpr int sceneFormat = 1;

/// A number of a file that its format does not have: a coordinate off the lattice, an attribute
/// finer than 2^-24. Its displacement is an error of the input, never of a method.
struct SnapReport {
    QString place; ///< "primitives[0].triangle[1][0]"
    QString written; ///< as the file says it
    SnappedNumber snapped;
    const NumberFormat *format = &coordinateFormat;

    /// "primitives[0].triangle[1][0]: 12.1 is drawn at 1549/128, displaced by 1/640 px"
    QString message() const;
};

/// The first of them, and how many there are: a large scene may have millions.
class SnapReports {
public:
    static constexpr std::size_t mostKept = 1000;

    bool keepsNext() const { return m_kept.size() < mostKept; }
    void add(SnapReport report)
    {
        if (keepsNext())
            m_kept.push_back(std::move(report));
        ++m_count;
    }
    bool empty() const { return m_count == 0; }
    std::size_t size() const { return m_count; }
    const SnapReport &front() const { return m_kept.front(); }
    const SnapReport &operator[](std::size_t index) const { return m_kept[index]; } ///< < mostKept
    // Those that are kept.
    auto begin() const { return m_kept.begin(); }
    auto end() const { return m_kept.end(); }

private:
    std::vector<SnapReport> m_kept;
    std::size_t m_count = 0;
};

class JsonNode;
class JsonReader;
struct Method;

/// What a scene file does not name: settings are as the method has them, the method is chosen.
struct OpenSettings {
    bool method = true;
    bool arithmetic = true;
    bool fillRule = true;
};

/// The settings of a scene drawn by a method: of those that are left open exact and closed, or the
/// method's first where it keeps neither.
ScanSettings settledFor(const Method &method, ScanSettings settings, const OpenSettings &open);

/// The method of a scene that names none: the first that draws its first primitive, antialiased
/// where that is a line or curve and the scene asks for it, under the settings that are named, and
/// with effects where the scene carries what may call for them. Where no method can all of it, the
/// first that draws the primitive under the settings, or at all.
const Method &methodFor(const Scene &scene, const OpenSettings &open);

/// A scene file as it was read.
struct SceneReading {
    Scene scene;
    SnapReports snaps;
    OpenSettings open = {};
};

/// Reads a scene in JSON: "pixelplumb", "frame" with "width" and "height", and "primitives" must be
/// there; everything else has a default: the method is methodFor() the scene, arithmetic and fill
/// rule are exact and closed, or the method's first where it keeps neither.
/// Unknown and repeated keys are errors. The listener hears how many bytes are read; when it ends
/// the reading, an error says so. Pictures and meshes are found in the folder of the scene; empty:
/// the current one. Their names in the scene are absolute.
Result<SceneReading> readScene(const QByteArray &text, const ProgressListener &listener = {},
                               const QString &folder = {});
/// The same of a scene that is part of another file; errors stay with the JsonReader.
Scene readScene(JsonReader &json, const JsonNode &node, const QString &folder = {});
Result<SceneReading> readSceneFile(const QString &path, const ProgressListener &listener = {});

/// Of texts up to this size the listener hears nothing: they are read at once.
inline constexpr qsizetype shortText = qsizetype(1) << 20; // bytes

/// The same scene gives the same bytes, whatever the locale. Pictures and meshes are named as seen
/// from the folder; empty: as the scene has them.
QByteArray writeScene(const Scene &scene, const QString &folder = {});
std::optional<InputError> writeSceneFile(const QString &path, const Scene &scene);

} // namespace pixelplumb
