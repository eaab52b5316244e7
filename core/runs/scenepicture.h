// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/number/jobprogress.h"
#include "core/runs/differencemap.h"
#include "core/runs/redrawnrows.h"
#include "core/scene/scene.h"

#include <memory>
#include <vector>

namespace pixelplumb {

/// The finished picture of a scene and its differences from its exact twin, without a recording,
/// drawn the fastest way that the scene's method has. Its memory serves one drawing after another,
/// because fresh pages for frames cost as much as drawing a scene of 10,000 triangles. If a scene
/// differs from the last one in a few triangles, as in a drag, only the rows that these touch are
/// redrawn.
///
/// It is not compared with the oracle, which judges every pixel by itself and takes its time, but
/// with its exact twin: the column scan in exact arithmetic by its fast kernels. Tests show that
/// this is the truth (the fast kernels draw the plain one's pictures, the plain one the oracle's).
class ScenePicture {
public:
    explicit ScenePicture(const FrameSpec &frame);

    const FrameSpec &spec() const { return m_drawn.spec(); }
    const FrameBuffer &drawn() const { return m_drawn; }
    /// Null where only the oracle knows the truth: under fill rules that the column scan does not
    /// support, and for shapes whose method has no proof that its pictures are true.
    const FrameBuffer *exactTwin() const;
    /// None where there is no exact twin.
    const DifferenceMap &differences() const { return m_differences; }

    /// Draws a scene with this frame, whose method must be able to (objectionTo). False if the
    /// listener, called now and then, ended it: the picture is then invalid.
    bool draw(const std::shared_ptr<const Scene> &scene, const ProgressListener &listener);

private:
    enum class Twin {
        Itself, ///< the picture is true by proof
        Drawn, ///< a second picture
        None,
    };

    static Twin twinOf(const Scene &scene, const Method &method);
    FrameRows rowsToDraw(const Scene &scene) const;
    bool drawAll(const Scene &scene, const ProgressListener &listener);
    bool drawRows(FrameRows rows, const Scene &scene, const ProgressListener &listener);
    bool drawBoth(Primitives primitives, const ScanSettings &settings,
                  const ProgressListener &listener);
    std::vector<const FrameBuffer *> frames() const;
    void clear(FrameRows rows);
    void compareRows(FrameRows rows);
    void forgetDifferences(std::int64_t y);
    void noteDifferences(std::int64_t y, const QRgb *drawnRow, const QRgb *twinRow);

    FrameBuffer m_drawn;
    std::unique_ptr<FrameBuffer> m_twin; ///< allocated at the first comparison
    Twin m_twinKind = Twin::None;
    DifferenceMap m_differences;
    std::shared_ptr<const Scene> m_scene; ///< whose picture it is; null if it is incomplete
    const Method *m_method = nullptr; ///< of the scene that is being drawn
};

} // namespace pixelplumb
