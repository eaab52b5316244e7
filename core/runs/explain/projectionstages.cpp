// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/projectionstages.h"

#include "core/runs/explain/formulanames.h"
#include "core/runs/tracedscene.h"
#include "core/scene/sceneprojection.h"
#include "core/shade/triangleneeds.h"
#include "core/space/stagelight.h"

#include <cmath>
#include <map>
#include <set>

namespace pixelplumb {

namespace {

/// The decimal of a number without rounding, as far as 128 bits hold it; none for an empty text.
Quantity exactQuantity(const QString &text)
{
    if (text.isEmpty())
        return {};
    constexpr int mostDigits = 36;
    const qsizetype letter = text.indexOf(u'e');
    const QString mantissa = text.left(letter < 0 ? text.size() : letter);
    const qsizetype point = mantissa.indexOf(u'.');
    const auto places = int(point < 0 ? 0 : mantissa.size() - point - 1);
    const int exponent = (letter < 0 ? 0 : text.sliced(letter + 1).toInt()) - places;
    Int128 numerator = 0;
    for (const QChar digit : mantissa) {
        if (digit.isDigit())
            numerator = numerator * 10 + digit.digitValue();
    }
    if (std::abs(exponent) > mostDigits
        || (exponent > 0 && mantissa.size() + exponent > mostDigits))
        return Quantity::of(text.toDouble());
    Int128 power = 1;
    for (int i = 0; i < std::abs(exponent); ++i)
        power *= 10;
    if (text.startsWith(u'-'))
        numerator = -numerator;
    return exponent < 0 ? Quantity::rational(numerator, power)
                        : Quantity::integer(numerator * power);
}

/// The names of a point's numbers so far, with their values.
class PointNames {
public:
    void add(const QString &title, const Quantity &value)
    {
        const auto before = m_latest.find(title);
        m_names.add(title, value,
                    before == m_latest.end() ? std::nullopt : std::optional(before->second));
        m_latest[title] = value;
    }
    void add(const StagePoint &point)
    {
        for (const StageNumber &number : point.numbers)
            add(number.name, Quantity::of(number.used));
    }
    QString substituted(const StageNumber &number) const
    {
        // Enough digits to check a rounding to 2⁻²⁴.
        constexpr int placesOfRounding = 14;
        return m_names.substituted(number.formula, number.name,
                                   number.formula.contains(u'⌊') ? placesOfRounding : usualPlaces);
    }

private:
    FormulaNames m_names;
    std::map<QString, Quantity> m_latest;
};

/// The stages of one triangle's corners, as formulas.
class StageReader {
public:
    StageReader(const FaceStages &stages, std::size_t piece)
        : m_stages(stages)
    {
        for (const std::size_t corner : {std::size_t(0), piece + 1, piece + 2}) {
            const ClippedCorner<double> &clipped = stages.face.clipped[corner];
            m_corners[clippedCornerName(corner)] = &clipped;
            m_vertices.insert(faceVertexName(clipped.inside));
            m_vertices.insert(faceVertexName(clipped.outside));
        }
    }

    /// For a plain triangle, whose only stages are its light.
    explicit StageReader(const FaceStages &stages)
        : m_stages(stages)
        , m_vertices{faceVertexName(0), faceVertexName(1), faceVertexName(2)}
    {
    }

    std::vector<StageFormulas> formulas()
    {
        for (const ProjectionStage &stage : m_stages.stages) {
            for (const StagePoint &point : stage.points) {
                if (belongs(point))
                    read(stage, point);
            }
        }
        return std::move(m_formulas);
    }

private:
    /// A face's centre and the camera belong to every triangle.
    bool belongs(const StagePoint &point) const
    {
        const bool isVertex = point.name.startsWith(u'V');
        const bool isCorner = point.name.startsWith(u'C');
        return isVertex ? m_vertices.contains(point.name)
                        : !isCorner || m_corners.contains(point.name);
    }

    void read(const ProjectionStage &stage, const StagePoint &point)
    {
        PointNames &names = namesOf(point.name);
        names.add(point);
        StageFormulas &read
            = m_formulas.emplace_back(StageFormulas{stage.title, point.name, point.note, {}});
        for (const StageNumber &number : point.numbers)
            read.lines.push_back(lineOf(number, names));
    }

    static FormulaLine lineOf(const StageNumber &number, const PointNames &names)
    {
        FormulaLine line;
        line.symbols = number.name;
        if (!number.formula.isEmpty()) {
            line.symbols += u" = "_s + number.formula;
            line.substituted = names.substituted(number);
        }
        line.used = Quantity::of(number.used);
        line.exact = exactQuantity(number.exact);
        return line;
    }

    /// Every point may name the numbers of the vertices in space, of the camera and of the lights;
    /// a corner also those of the vertices that it is made of.
    PointNames &namesOf(const QString &point)
    {
        const auto [entry, isNew] = m_names.try_emplace(point);
        PointNames &names = entry->second;
        if (!isNew)
            return names;
        addVerticesInSpace(names);
        if (isShared(point))
            return names;
        for (const ProjectionStage &stage : m_stages.stages) {
            for (const StagePoint &each : stage.points) {
                if (isShared(each.name))
                    names.add(each);
            }
        }
        if (const auto corner = m_corners.find(point); corner != m_corners.end()) {
            addVertex(names, corner->second->inside);
            addVertex(names, corner->second->outside);
        }
        return names;
    }

    void addVerticesInSpace(PointNames &names) const
    {
        for (const StagePoint &vertex : m_stages.stages.front().points) {
            for (const StageNumber &number : vertex.numbers)
                names.add(vertex.name + u'_' + number.name, Quantity::of(number.used));
        }
    }

    void addVertex(PointNames &names, std::size_t vertex) const
    {
        const ClipVertex<double> &from = m_stages.face.polygon[vertex];
        const auto add = [&](const QString &name, double value) {
            names.add(clipName(name, vertex), Quantity::of(value));
        };
        add(u"x_clip"_s, from.clip.x);
        add(u"y_clip"_s, from.clip.y);
        add(u"z_clip"_s, from.clip.z);
        add(u"w"_s, from.clip.w);
        add(u"u"_s, from.texture[0]);
        add(u"v"_s, from.texture[1]);
        for (std::size_t channel = 0; channel < 3; ++channel)
            add(QString(channelLetters[channel]), from.levels[channel]);
        add(u"α"_s, from.levels[3]);
    }

    const FaceStages &m_stages;
    std::map<QString, const ClippedCorner<double> *> m_corners;
    std::set<QString> m_vertices;
    std::map<QString, PointNames> m_names;
    std::vector<StageFormulas> m_formulas;
};

/// How a triangle of the scene was lit before scan conversion; empty if it was not.
std::vector<StageFormulas> lightFormulas(const TracedScene &traced, std::size_t primitive)
{
    const Primitives &primitives = traced.primitives;
    const std::optional<std::size_t> index = traced.indexInScene(primitive);
    if (!primitives.isTriangle(primitive) || !index || !lightsVertices(primitives.appearance))
        return {};
    const TriangleAttributes *attributes = primitives.attributesOf(primitive);
    if (!attributes || !hasNormals(*attributes))
        return {};
    const FaceStages stages{
        lightStagesOf(traced.scene.triangles[*index], *attributes, primitives.appearance), {}, {}};
    return StageReader(stages).formulas();
}

} // namespace

std::vector<StageFormulas> stageFormulas(const TracedScene &traced, std::size_t primitive)
{
    const Primitives &primitives = traced.primitives;
    const TriangleSource *source = primitives.sourceOf(primitive);
    if (!source)
        return lightFormulas(traced, primitive);
    const FaceStages stages = stagesOf(traced.scene, *source, primitives.wExponent);
    return StageReader(stages, source->piece).formulas();
}

} // namespace pixelplumb
