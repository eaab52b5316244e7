// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/facestages.h"

#include "core/space/attributenumber.h"
#include "core/space/stagelight.h"
#include "core/space/stagenumbers.h"
#include "core/space/stagepoints.h"

#include <algorithm>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// Writes the stages of one face from its projections in doubles and without rounding.
class StageWriter {
public:
    StageWriter(const SpaceScene &scene, const Solid &solid, std::size_t face, int wExponent)
        : m_scene(scene)
        , m_material(materialOf(scene.appearance, solid.material))
        , m_usedProjector(scene, solid)
        , m_exactProjector(scene, solid)
        , m_used(m_usedProjector.project(face))
        , m_exact(m_exactProjector.project(face))
        , m_wExponent(wExponent)
    {
    }

    FaceStages written()
    {
        m_stages.face = m_used;
        for (std::size_t i = 0; i < m_used.clipped.size(); ++i) {
            m_stages.corners.push_back(
                snapped(m_used.clipped[i], m_used.places[i], m_used.devices[i].z, m_wExponent));
        }
        writeVertices();
        if (!m_used.lit.empty())
            writeLight();
        writeView();
        writeClipCoordinates();
        writePolygon();
        writeDivision();
        writeFrame();
        writeLattice();
        return std::move(m_stages);
    }

private:
    ProjectionStage &begin(const QString &title, const QString &formula)
    {
        return m_stages.stages.emplace_back(ProjectionStage{title, formula, {}});
    }

    void writeVertices()
    {
        const bool hasNormals = std::ranges::none_of(
            m_used.vertices, [](const auto &vertex) { return vertex.normal.isZero(); });
        ProjectionStage &stage = begin(
            "Vertex",
            u"The face's vertices in the scene's space, their colours times the material's"_s
                + (hasNormals ? QString() : u", N = Σ (V_i − V₀) × (V_i₊₁ − V₀) to length 1"_s));
        for (std::size_t i = 0; i < m_used.vertices.size(); ++i) {
            const SpaceVertex<double> &vertex = m_used.vertices[i];
            StagePoint &point = stage.points.emplace_back(StagePoint{faceVertexName(i), {}, {}});
            StageNumberWriter numbers(point.numbers);
            numbers.add(QString(), vertex.position, &m_exact.vertices[i].position);
            numbers.add("_N", m_used.polygon[i].normal, &m_exact.polygon[i].normal,
                        vertex.normal.isZero() ? Component(faceNormalName) : Component());
            numbers.add("u", vertex.texture[0], m_exact.vertices[i].texture[0]);
            numbers.add("v", vertex.texture[1], m_exact.vertices[i].texture[1]);
            writeTint(point, vertex.colour, m_material.diffuse);
        }
        if (!hasNormals || m_scene.appearance.shading == Shading::Flat)
            writeFace(stage.points.emplace_back(StagePoint{facePointName(), {}, {}}));
    }

    static QString faceNormalName(QChar axis) { return u"face_"_s + axis; }

    /// Writes the face's own normal.
    void writeFace(StagePoint &point)
    {
        StageNumberWriter numbers(point.numbers);
        const auto area = [](QChar axis) { return u"area_"_s + axis; };
        const auto exactArea = fanArea(m_exact.vertices);
        numbers.add(
            area, fanArea(m_used.vertices), &exactArea,
            [count = m_used.vertices.size()](QChar axis) { return fanFormula(count, axis); });
        numbers.add(faceNormalName, m_used.normal, &m_exact.normal, unitOf(m_used.normal, area));
    }

    void writeLight()
    {
        m_stages.stages.push_back(
            lightStageOf({m_scene.appearance, m_material, m_used.vertices.size(),
                          meanOverVertices(m_used.vertices.size()), faceNormalName},
                         m_used.lit, m_exact.lit));
    }

    void writeView()
    {
        ProjectionStage &stage
            = begin("Camera", "x to the right, y up, the eye at 0, looking along −z");
        writeCameraPoint(stage.points.emplace_back(StagePoint{cameraPointName(), {}, {}}), m_scene);
        const auto along = [](const char *axis) {
            return u"%_x·(x − E_x) + %_y·(y − E_y) + %_z·(z − E_z)"_s.replace(u'%',
                                                                              QLatin1String(axis));
        };
        for (std::size_t i = 0; i < m_used.views.size(); ++i) {
            StagePoint &point = stage.points.emplace_back(StagePoint{faceVertexName(i), {}, {}});
            StageNumberWriter numbers(point.numbers);
            const auto &[usedX, usedY, usedZ] = m_used.views[i];
            const auto &[exactX, exactY, exactZ] = m_exact.views[i];
            numbers.add("x_view", usedX, exactX, along("right"));
            numbers.add("y_view", usedY, exactY, along("up"));
            numbers.add("z_view", usedZ, exactZ, along("back"));
        }
    }

    void writeClipCoordinates()
    {
        const bool isPerspective = m_scene.camera.projection == Projection::Perspective;
        ProjectionStage &stage
            = begin("Clip coordinates",
                    isPerspective ? u"w = −z_view, z_clip = (w − near)·far/(far − near), y_clip = "
                                    "y_view·cot(fieldOfView/2), x_clip likewise by the aspect"_s
                                  : u"w = 1, z_clip = (−z_view − near)/(far − near), y_clip = "
                                    "2y_view/height, x_clip likewise by the aspect"_s);
        for (std::size_t i = 0; i < m_used.polygon.size(); ++i) {
            const QString note = m_used.polygon[i].isInside()
                ? u"at or beyond the near plane: z_clip ≥ 0"_s
                : u"before the near plane: z_clip < 0"_s;
            StagePoint &point = stage.points.emplace_back(StagePoint{faceVertexName(i), note, {}});
            writeClipPoint(point, m_used.polygon[i].clip, &m_exact.polygon[i].clip,
                           {"scale_x·x_view", "scale_y·y_view", "scale_z·(−z_view − near)",
                            isPerspective ? u"−z_view"_s : u"1"_s});
        }
    }

    void writePolygon()
    {
        ProjectionStage &stage = begin(
            "Clipped polygon",
            "An edge from inside a to outside b is cut at t = z_a/(z_a − z_b): a + t·(b − a)");
        for (std::size_t i = 0; i < m_used.clipped.size(); ++i) {
            const ClippedCorner<double> &corner = m_used.clipped[i];
            const ClippedCorner<ExactReal> *exact = exactCornerOf(corner);
            const QString note = corner.isCut() ? u"the near plane cuts %1%2"_s.arg(
                                     faceVertexName(corner.inside), faceVertexName(corner.outside))
                                                : u"%1, kept"_s.arg(faceVertexName(corner.inside));
            StagePoint &point
                = stage.points.emplace_back(StagePoint{clippedCornerName(i), note, {}});
            const QString x = u"x_clip"_s;
            const QString y = u"y_clip"_s;
            const QString z = u"z_clip"_s;
            const auto kept = [&](const QString &name) { return clipName(name, corner.inside); };
            const auto between = [&](const QString &name) {
                return u"%1 + t·(%2 − %1)"_s.arg(kept(name), clipName(name, corner.outside));
            };
            if (corner.isCut())
                StageNumberWriter(point.numbers)
                    .add("t", corner.t, exact ? &exact->t : nullptr,
                         u"%1/(%1 − %2)"_s.arg(kept(z), clipName(z, corner.outside)));
            const bool isPerspective = m_scene.camera.projection == Projection::Perspective;
            writeClipPoint(point, corner.vertex.clip, exact ? &exact->vertex.clip : nullptr,
                           corner.isCut() ? ClipFormulas{between(x), between(y), "0",
                                                         isPerspective ? u"near"_s : u"1"_s}
                                          : ClipFormulas{kept(x), kept(y), kept(z), kept(u"w"_s)});
            writeCarried(point, corner, exact);
        }
    }

    using ClipFormulas = std::array<QString, 4>; ///< of x, y, z and w
    static void writeClipPoint(StagePoint &point, const ClipPoint<double> &used,
                               const ClipPoint<ExactReal> *exact, const ClipFormulas &formulas)
    {
        StageNumberWriter numbers(point.numbers);
        numbers.add("x_clip", used.x, exact ? &exact->x : nullptr, formulas[0]);
        numbers.add("y_clip", used.y, exact ? &exact->y : nullptr, formulas[1]);
        numbers.add("z_clip", used.z, exact ? &exact->z : nullptr, formulas[2]);
        numbers.add("w", used.w, exact ? &exact->w : nullptr, formulas[3]);
    }

    void writeDivision()
    {
        ProjectionStage &stage = begin(
            "Division",
            "x_clip/w, y_clip/w, z_clip/w: the frame's sides at ±1, z from 0 (near) to 1 (far)");
        for (std::size_t i = 0; i < m_used.devices.size(); ++i) {
            StagePoint &point = stage.points.emplace_back(StagePoint{clippedCornerName(i), {}, {}});
            const auto at = exactPlaceOf(m_used.clipped[i]);
            const auto *exact = at ? &m_exact.devices[*at] : nullptr;
            StageNumberWriter numbers(point.numbers);
            numbers.add("x_device", m_used.devices[i].x, exact ? &exact->x : nullptr, "x_clip/w");
            numbers.add("y_device", m_used.devices[i].y, exact ? &exact->y : nullptr, "y_clip/w");
            numbers.add("z_device", m_used.devices[i].z, exact ? &exact->z : nullptr, "z_clip/w");
        }
    }

    void writeFrame()
    {
        const bool isUpward = m_scene.frame.origin == FrameOrigin::BottomLeft;
        ProjectionStage &stage
            = begin("Frame",
                    isUpward ? u"x = first column + (x_device + 1)/2·width − ½, y = "
                               "first row + (y_device + 1)/2·height − ½, px"_s
                             : u"x = first column + (x_device + 1)/2·width − ½, y = "
                               "first row + (1 − y_device)/2·height − ½, px"_s);
        for (std::size_t i = 0; i < m_used.places.size(); ++i) {
            StagePoint &point = stage.points.emplace_back(StagePoint{clippedCornerName(i), {}, {}});
            const auto at = exactPlaceOf(m_used.clipped[i]);
            StageNumberWriter numbers(point.numbers);
            numbers.add("x", m_used.places[i][0], at ? &m_exact.places[*at][0] : nullptr,
                        "x_first + (x_device + 1)/2·width − ½");
            numbers.add("y", m_used.places[i][1], at ? &m_exact.places[*at][1] : nullptr,
                        isUpward ? u"y_first + (y_device + 1)/2·height − ½"_s
                                 : u"y_first + (1 − y_device)/2·height − ½"_s);
        }
    }

    /// Here the error is the displacement by snapping.
    void writeLattice()
    {
        const QString depthUnit
            = m_wExponent == 0 ? QString() : u"; w is the view depth times 2^%1"_s.arg(m_wExponent);
        ProjectionStage &stage = begin(
            "Lattice",
            u"x and y to the nearest 1/256 px, z, w, u and v to the nearest 2^−24"_s + depthUnit);
        for (std::size_t i = 0; i < m_stages.corners.size(); ++i) {
            const SnappedCorner &corner = m_stages.corners[i];
            StagePoint &point = stage.points.emplace_back(StagePoint{clippedCornerName(i), {}, {}});
            if (corner.loss) {
                point.note = nameOf(*corner.loss);
                continue;
            }
            const auto at = exactPlaceOf(m_used.clipped[i]);
            writeSnappedPoint(point, corner, at ? exactCorner(*at) : std::nullopt, m_wExponent);
        }
    }

    std::optional<ExactCorner> exactCorner(std::size_t at) const
    {
        return ExactCorner{m_exact.clipped[at].vertex, m_exact.places[at], m_exact.devices[at].z};
    }

    /// The matching unrounded corner; none where a vertex very near the plane changed sides.
    std::optional<std::size_t> exactPlaceOf(const ClippedCorner<double> &corner) const
    {
        for (std::size_t i = 0; i < m_exact.clipped.size(); ++i) {
            const ClippedCorner<ExactReal> &exact = m_exact.clipped[i];
            if (exact.inside == corner.inside && exact.outside == corner.outside)
                return i;
        }
        return std::nullopt;
    }
    const ClippedCorner<ExactReal> *exactCornerOf(const ClippedCorner<double> &corner) const
    {
        const auto at = exactPlaceOf(corner);
        return at ? &m_exact.clipped[*at] : nullptr;
    }

    const SpaceScene &m_scene;
    const Material &m_material;
    FaceProjector<double> m_usedProjector;
    FaceProjector<ExactReal> m_exactProjector;
    const ProjectedFace<double> &m_used;
    const ProjectedFace<ExactReal> &m_exact;
    int m_wExponent;
    FaceStages m_stages;
};

} // namespace

FaceStages stagesOf(const SpaceScene &scene, const TriangleSource &source, int wExponent)
{
    return StageWriter(scene, scene.solids[source.solid], source.face, wExponent).written();
}

} // namespace pixelplumb
