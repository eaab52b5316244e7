// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"
#include "core/scene/scene.h"
#include "core/scene/text/coordinatetext.h"

#include <vector>

namespace pixelplumb {

/// The format that this program writes, and the newest that it reads.
inline constexpr int sceneFormat = 1;

/// A number in a file that its format cannot represent: a coordinate off the lattice, an attribute
/// finer than 2^-24. Its displacement is an error of the input, never of a method.
struct SnapReport {
    QString place; ///< "primitives[0].triangle[1][0]"
    QString written; ///< as in the file
    SnappedNumber snapped;
    const NumberFormat *format = &coordinateFormat;

    /// "primitives[0].triangle[1][0]: 12.1 is drawn at 1549/128, displaced by 1/640 px"
    QString message() const;
};

/// The first reports and the count of all: a large scene may have millions.
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
    // Only those that are kept.
    auto begin() const { return m_kept.begin(); }
    auto end() const { return m_kept.end(); }

private:
    std::vector<SnapReport> m_kept;
    std::size_t m_count = 0;
};

class JsonNode;
class JsonReader;
struct Method;

/// Which settings a scene file leaves open. Open settings follow the method, and an open method is
/// chosen.
struct OpenSettings {
    bool method = true;
    bool arithmetic = true;
    bool fillRule = true;
};

/// The settings of a scene drawn by a method: open ones are exact and closed, or the method's first
/// where it does not support that.
ScanSettings settledFor(const Method &method, ScanSettings settings, const OpenSettings &open);

/// The method for a scene that names none: the first that draws its first primitive, under the
/// settings that are named, with effects where the scene may need them, and antialiased where that
/// primitive is a line or curve and the scene asks for it. Where no method does all that, the first
/// that draws the primitive under the settings, or at all.
const Method &methodFor(const Scene &scene, const OpenSettings &open);

/// Where methodFor() refuses the settings that are named, so that no method draws the scene's first
/// primitive under them: which these are, and without which one a method does.
QString refusalOfAll(const Scene &scene, const OpenSettings &open);

/// A scene file as it was read.
struct SceneReading {
    Scene scene;
    SnapReports snaps;
    OpenSettings open = {};
};

/// Reads a scene in JSON: "pixelplumb", "frame" with "width" and "height", and "primitives" are
/// required; everything else has a default: the method is methodFor() the scene, arithmetic and
/// fill rule are exact and closed, or the method's first where it supports neither.
/// Unknown and repeated keys are errors. The listener hears how many bytes are read; when it ends
/// the reading, an error says so. Pictures and meshes are looked up in the scene's folder; empty:
/// the current one. Their names in the scene are absolute.
Result<SceneReading> readScene(const QByteArray &text, const ProgressListener &listener = {},
                               const QString &folder = {});
/// Reads a scene that is part of another file; errors stay with the JsonReader.
Scene readScene(JsonReader &json, const JsonNode &node, const QString &folder = {});
Result<SceneReading> readSceneFile(const QString &path, const ProgressListener &listener = {});

/// Texts up to this size are read at once, without a word to the listener.
inline constexpr qsizetype shortText = qsizetype(1) << 20; // bytes

/// Writes a scene: equal scenes give equal bytes in any locale. Pictures and meshes are named
/// relative to the folder; empty: as the scene names them.
QByteArray writeScene(const Scene &scene, const QString &folder = {});
std::optional<InputError> writeSceneFile(const QString &path, const Scene &scene);

} // namespace pixelplumb
