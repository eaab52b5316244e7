// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/scene/scene.h"
#include "core/trace/differencemap.h"

#include <functional>
#include <memory>

namespace pixelplumb {

/// The finished picture of a scene and its differences from the truth, without a record of how it
/// came about: by the fastest way that the scene's method has. Its memory serves one drawing after
/// another, because fresh pages for frames cost as much as drawing a scene of 10,000 triangles.
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
    bool draw(const Scene &scene, const GoesOn &goesOn);

private:
    enum class Truth {
        Drawn, ///< the picture itself, by proof
        Compared, ///< a second picture
        Unknown,
    };

    static Truth truthOf(const Scene &scene, const Method &method);
    bool drawPieces(const Scene &scene, const Method &method, const GoesOn &goesOn);
    void drawPiece(const Scene &scene, const Method &method);
    void takePiece(const Scene &scene, std::size_t first, std::size_t count);
    void compareRows();
    void noteDifferences(std::int64_t y, const QRgb *drawnRow, const QRgb *trueRow);

    FrameBuffer m_drawn;
    std::unique_ptr<FrameBuffer> m_truth; ///< from the first comparison on
    Truth m_truthKind = Truth::Unknown;
    DifferenceMap m_differences;
    Primitives m_piece; ///< of the scene that is being drawn, in sample coordinates
};

} // namespace pixelplumb
