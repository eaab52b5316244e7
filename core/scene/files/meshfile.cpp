// SPDX-License-Identifier: GPL-3.0-or-later
#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include "core/scene/files/meshfile.h"

#include "core/geometry/attributes.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/meshtext.h"
#include "core/scene/files/scenelimits.h"

#include <QList>

#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>

namespace pixelplumb {

namespace {

/// A text as a stream that knows how far it has been read.
class TextBuffer : public std::streambuf {
public:
    explicit TextBuffer(QByteArray &text) { setg(text.begin(), text.begin(), text.end()); }
    qsizetype position() const { return gptr() - eback(); }
    void end() { setg(eback(), egptr(), egptr()); }
};

/// Position, texture coordinate and normal of a corner, counted from 0; −1: none.
using CornerIndices = std::array<std::int64_t, 3>;

struct CornerHash {
    std::size_t operator()(const CornerIndices &corner) const
    {
        std::uint64_t hash = 0;
        for (const std::int64_t index : corner)
            hash = (hash ^ std::uint64_t(index)) * 0x9e3779b97f4a7c15U;
        return std::size_t(hash ^ (hash >> 32));
    }
};

/// Builds a mesh from the lines that tinyobjloader reports. The first fault ends the reading.
class MeshBuilder {
public:
    MeshBuilder(const QByteArray &text, TextBuffer &buffer, const ProgressListener &listener)
        : m_text(text)
        , m_buffer(buffer)
        , m_listener(listener)
    {
    }

    void takePosition() { take(m_positions, 3); }
    void takeTexturePoint() { take(m_texturePoints, 2); }
    void takeNormal()
    {
        take(m_normals, 3);
        if (!hasFailed() && !m_wasCancelled && m_normals.back() == Vector3())
            fail("a normal of length 0", "a direction");
    }
    void takeFace(const tinyobj::index_t *corners, int count);

    bool hasFailed() const { return !m_found.isEmpty(); }
    bool wasCancelled() const { return m_wasCancelled; }
    InputError error(const QString &name) const
    {
        const QString place
            = m_line > 0 ? u"%1, line %2"_s.arg(name, QString::number(m_line)) : name;
        return {place, m_found, m_expected};
    }
    Mesh takeMesh() { return std::move(m_mesh); }
    void failWithoutFaces()
    {
        m_found = "no face";
        m_expected = "a Wavefront OBJ file with lines such as “f 1 2 3”";
    }

private:
    bool goesOnReading();
    void take(std::vector<Vector3> &all, std::size_t needed);
    std::int64_t resolved(int index, std::size_t count, const char *what);
    std::uint32_t cornerOf(const CornerIndices &indices);
    QByteArrayView currentLine() const;
    void fail(const QString &found, const QString &expected);

    const QByteArray &m_text;
    TextBuffer &m_buffer;
    const ProgressListener &m_listener;
    std::vector<Vector3> m_positions;
    std::vector<Vector3> m_texturePoints;
    std::vector<Vector3> m_normals;
    std::unordered_map<CornerIndices, std::uint32_t, CornerHash> m_corners;
    Mesh m_mesh;
    QString m_found;
    QString m_expected;
    qsizetype m_line = 0;
    std::int64_t m_lines = 0; ///< used so far
    bool m_wasCancelled = false;
};

/// Called before each line that is used.
bool MeshBuilder::goesOnReading()
{
    if (hasFailed() || m_wasCancelled)
        return false;
    constexpr std::int64_t linesBetweenProgress = 1024;
    if (m_lines++ % linesBetweenProgress == 0
        && !goesOn(m_listener, {JobPhase::Reading, m_buffer.position(), m_text.size()})) {
        m_wasCancelled = true;
        m_buffer.end();
    }
    return !m_wasCancelled;
}

QByteArrayView MeshBuilder::currentLine() const
{
    const QByteArrayView before = QByteArrayView(m_text).first(m_buffer.position());
    const QByteArrayView line = before.trimmed();
    // Not lastIndexOf(): when a character is absent it searches the whole text.
    const auto ends = [](char character) { return character == '\n' || character == '\r'; };
    const auto first = std::find_if(line.rbegin(), line.rend(), ends);
    return line.last(first - line.rbegin()).trimmed();
}

void MeshBuilder::fail(const QString &found, const QString &expected)
{
    m_found = found;
    m_expected = expected;
    const QByteArrayView line = currentLine();
    m_line = m_text.first(line.data() - m_text.data()).count('\n') + 1;
    m_buffer.end();
}

/// Parses numbers itself: tinyobjloader turns non-numbers into 0 and rounds decimals in its own
/// way.
void MeshBuilder::take(std::vector<Vector3> &all, std::size_t needed)
{
    if (!goesOnReading())
        return;
    const QByteArrayView line = currentLine();
    const char *place = line.data();
    const char *end = place + line.size();
    const auto isBlank = [](char character) { return character == ' ' || character == '\t'; };
    while (place != end && !isBlank(*place))
        ++place; // skips "v", "vt" or "vn"
    Vector3 numbers = {};
    for (std::size_t i = 0; i < needed; ++i) {
        while (place != end && isBlank(*place))
            ++place;
        place += place != end && *place == '+' ? 1 : 0;
        const auto [after, error] = std::from_chars(place, end, numbers[i]);
        const bool isNumber = error == std::errc() && (after == end || isBlank(*after));
        if (!isNumber || !(std::abs(numbers[i]) <= double(largestAttributeValue))) {
            fail(u"“%1”"_s.arg(QString::fromUtf8(line.first(qMin(line.size(), 60)))),
                 u"%1 numbers within ±%2"_s.arg(needed).arg(largestAttributeValue));
            return;
        }
        place = after;
    }
    all.push_back(numbers);
}

/// Resolves an index, which counts from 1, or if negative back from the last one read; 0 where
/// there is none.
std::int64_t MeshBuilder::resolved(int index, std::size_t count, const char *what)
{
    const std::int64_t fromZero = index < 0 ? std::int64_t(count) + index : std::int64_t(index) - 1;
    if (fromZero >= 0 && fromZero < std::int64_t(count))
        return fromZero;
    fail(u"a face with %1 %2"_s.arg(QLatin1String(what), QString::number(index)),
         count == 0 ? u"one that stands before the face"_s
                    : u"1 to %1, of those before the face"_s.arg(count));
    return 0;
}

std::uint32_t MeshBuilder::cornerOf(const CornerIndices &indices)
{
    const auto [place, isNew]
        = m_corners.try_emplace(indices, std::uint32_t(m_mesh.corners.size()));
    if (isNew) {
        SolidCorner &corner = m_mesh.corners.emplace_back();
        corner.position = m_positions[std::size_t(indices[0])];
        if (indices[1] >= 0)
            corner.texture = {m_texturePoints[std::size_t(indices[1])][0],
                              m_texturePoints[std::size_t(indices[1])][1]};
        if (indices[2] >= 0)
            corner.normal = m_normals[std::size_t(indices[2])];
    }
    return place->second;
}

void MeshBuilder::takeFace(const tinyobj::index_t *corners, int count)
{
    if (!goesOnReading())
        return;
    const QByteArray line = currentLine().toByteArray();
    const QList<QByteArray> words = line.simplified().split(' ');
    const auto wrong = std::find_if(words.begin() + 1, words.end(),
                                    [](const QByteArray &word) { return !isCorner(word); });
    if (wrong != words.end()) {
        fail(u"a face with a corner “%1”"_s.arg(
                 QString::fromUtf8(wrong->first(qMin<qsizetype>(wrong->size(), 40)))),
             "1, 1/2, 1//3 or 1/2/3");
        return;
    }
    if (count < 3) {
        fail(u"a face of %1"_s.arg(count), "3 corners or more");
        return;
    }
    if (m_mesh.faces.size() + std::size_t(count) - 2 > mostSolidTriangles) {
        fail(tooManyTriangles(m_mesh.faces.size() + std::size_t(count) - 2), fewerTriangles());
        return;
    }
    std::array<std::uint32_t, 3> face = {};
    for (int i = 0; i < count && !hasFailed(); ++i) {
        const tinyobj::index_t &corner = corners[i];
        CornerIndices indices
            = {resolved(corner.vertex_index, m_positions.size(), "vertex"), -1, -1};
        if (corner.texcoord_index != 0)
            indices[1] = resolved(corner.texcoord_index, m_texturePoints.size(), "texture point");
        if (corner.normal_index != 0)
            indices[2] = resolved(corner.normal_index, m_normals.size(), "normal");
        if (hasFailed())
            return;
        face[std::size_t(qMin(i, 2))] = cornerOf(indices);
        if (i < 2)
            continue;
        m_mesh.faces.push_back(face);
        face[1] = face[2];
    }
}

} // namespace

Result<Mesh> parseMesh(QByteArray text, const QString &name, const ProgressListener &listener)
{
    text = withoutRemarks(text);
    TextBuffer buffer(text);
    std::istream stream(&buffer);
    MeshBuilder builder(text, buffer, listener);
    tinyobj::callback_t callback;
    using Real = tinyobj::real_t;
    callback.vertex_cb = [](void *data, Real, Real, Real, Real) {
        static_cast<MeshBuilder *>(data)->takePosition();
    };
    callback.texcoord_cb = [](void *data, Real, Real, Real) {
        static_cast<MeshBuilder *>(data)->takeTexturePoint();
    };
    callback.normal_cb
        = [](void *data, Real, Real, Real) { static_cast<MeshBuilder *>(data)->takeNormal(); };
    callback.index_cb = [](void *data, tinyobj::index_t *corners, int count) {
        static_cast<MeshBuilder *>(data)->takeFace(corners, count);
    };
    tinyobj::LoadObjWithCallback(stream, callback, &builder);
    if (builder.wasCancelled())
        return readingCancelled(name);
    if (builder.hasFailed())
        return builder.error(name);
    Mesh mesh = builder.takeMesh();
    if (mesh.faces.empty()) {
        builder.failWithoutFaces();
        return builder.error(name);
    }
    mesh.name = name.toStdString();
    return mesh;
}

Result<Mesh> readMesh(const QString &path, const ProgressListener &listener)
{
    Result<QByteArray> content = readRegularFile(path);
    if (!content)
        return content.error();
    return parseMesh(std::move(*content), path, listener);
}

} // namespace pixelplumb
