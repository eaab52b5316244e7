// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/scene/scene.h"
#include "core/trace/differencemap.h"

#include <functional>
#include <memory>
#include <vector>

namespace pixelplumb {

/// The finished picture of a scene and its differences from the truth, without a record of how it
/// came about: by the fastest way that the scene's method has. Its memory serves one drawing after
/// another, because fresh pages for frames cost as much as drawing a scene of 10,000 triangles; of
/// a scene that differs from the last one in a few triangles, as in a drag, only the rows that
/// these touch are drawn anew.
///
/// The truth is not the oracle's, which judges every pixel by itself and takes its time, but the
/// column scan's in exact arithmetic by its fast kernels; that these agree with the oracle, bit for
/// bit, is what tests hold them to (the fast kernels to the plain one, the plain one to the
/// oracle).
class ScenePicture {
public:
    explicit ScenePicture(const FrameSpec &frame);

    const FrameSpec &spec() const { return m_drawn.spec(); }
    const FrameBuffer &drawn() const { return m_drawn; }
    /// Null where only the oracle knows it: under fill rules that the column scan does not keep,
    /// and of shapes that a method draws with no proof that they are true.
    const FrameBuffer *truth() const;
    /// None where the truth is not known.
    const DifferenceMap &differences() const { return m_differences; }

    /// Asked between pieces of a scene whether to go on.
    using GoesOn = std::function<bool()>;
    /// Draws a scene with this frame, whose method must accept its settings (Method::refusal).
    /// False when `goesOn` ended it: the picture is then worth nothing.
    bool draw(const std::shared_ptr<const Scene> &scene, const GoesOn &goesOn);

private:
    /// Rows of the frame, [first, end).
    struct Rows {
        std::int64_t first = 0;
        std::int64_t end = 0;
    };
    enum class Truth {
        Drawn, ///< the picture itself, by proof
        Compared, ///< a second picture
        Unknown,
    };

    static Truth truthOf(const Scene &scene, const Method &method);
    static Rows rowsReachedBy(const Triangle &triangle);
    Rows allRows() const;
    Rows rowsToDraw(const Scene &scene, const Method &method) const;
    bool drawAll(const Scene &scene, const Method &method, const GoesOn &goesOn);
    bool drawRows(Rows rows, const Scene &scene, const Method &method, const GoesOn &goesOn);
    void drawPiece(const Scene &scene, const Method &method);
    std::vector<const FrameBuffer *> frames() const;
    void clear(Rows rows);
    void takePiece(const Scene &scene, std::size_t first, std::size_t count);
    void compareRows(Rows rows);
    void forgetDifferences(std::int64_t y);
    void noteDifferences(std::int64_t y, const QRgb *drawnRow, const QRgb *trueRow);

    FrameBuffer m_drawn;
    std::unique_ptr<FrameBuffer> m_truth; ///< from the first comparison on
    Truth m_truthKind = Truth::Unknown;
    DifferenceMap m_differences;
    std::shared_ptr<const Scene> m_scene; ///< whose picture it is; null where it is nothing whole
    Primitives m_piece; ///< of the scene that is being drawn, in sample coordinates
};

} // namespace pixelplumb
