// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/grade/diagnose/diagnosis.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/tracedscene.h"
#include "core/scene/text/colourtext.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The scene's first primitives.
Scene beginningOf(Scene scene, std::size_t primitives)
{
    const std::size_t triangles = std::min(primitives, scene.triangles.size());
    scene.triangles.resize(triangles);
    scene.shapes.resize(primitives - triangles);
    return scene;
}

/// Two pictures of one frame, pixel by pixel.
class PicturePair {
public:
    PicturePair(const FrameSpec &frame, Picture right, Picture redrawn)
        : m_frame(frame)
        , m_right(std::move(right))
        , m_redrawn(std::move(redrawn))
    {
    }

    /// "(12, 5) is left out"; empty where the pictures agree.
    QString differenceAt(std::int64_t x, std::int64_t y) const
    {
        const std::size_t place = placeOf(x, y);
        const bool isSame = m_right.covered[place] == m_redrawn.covered[place]
            && m_right.colours[place] == m_redrawn.colours[place];
        if (isSame)
            return {};
        const QString where = u"(%1, %2) "_s.arg(x).arg(y);
        if (isExtra(place))
            return where + u"is drawn but should not be"_s;
        if (m_redrawn.covered[place] == 0)
            return where + u"is left out"_s;
        return where
            + u"is %1, should be %2"_s.arg(colourText(m_redrawn.colours[place]),
                                           colourText(m_right.colours[place]));
    }
    QString firstInFrame() const { return firstIn(firstCorner(), lastCorner(), Which::All); }
    /// The first sample in the span's column or row that is drawn but should not be.
    QString firstExtraOn(const SpanPlace &span) const
    {
        LatticePoint first = firstCorner();
        LatticePoint last = lastCorner();
        if (span.axis == SpanAxis::Free)
            return {};
        (span.axis == SpanAxis::Column ? first.x : first.y) = span.coordinate;
        (span.axis == SpanAxis::Column ? last.x : last.y) = span.coordinate;
        return firstIn(first, last, Which::Extra);
    }

private:
    enum class Which { All, Extra };

    std::size_t placeOf(std::int64_t x, std::int64_t y) const
    {
        return m_right.placeOf(int(x - m_frame.firstColumn), int(pictureLine(m_frame, y)));
    }
    bool isExtra(std::size_t place) const
    {
        return m_right.covered[place] == 0 && m_redrawn.covered[place] != 0;
    }
    /// The first difference from one corner to the other, px.
    QString firstIn(LatticePoint first, LatticePoint last, Which which) const
    {
        for (std::int64_t x = first.x; x <= last.x; ++x) {
            for (std::int64_t y = first.y; y <= last.y; ++y) {
                if (which == Which::Extra && !isExtra(placeOf(x, y)))
                    continue;
                if (QString difference = differenceAt(x, y); !difference.isEmpty())
                    return difference;
            }
        }
        return {};
    }
    LatticePoint firstCorner() const { return {m_frame.firstColumn, m_frame.firstRow}; }
    LatticePoint lastCorner() const
    {
        return {m_frame.firstColumn + m_frame.width - 1, m_frame.firstRow + m_frame.height - 1};
    }

    FrameSpec m_frame;
    Picture m_right, m_redrawn;
};

/// The first differing step of one primitive of the run.
PartingStep partingIn(const TracedScene &run, std::size_t primitive, const PicturePair &pictures)
{
    const ScanTrace &trace = *run.trace;
    const bool isLast = primitive + 1 == trace.primitiveCount();
    const std::size_t end = isLast ? trace.stepCount() : trace.indexOfSetUp(primitive + 1);
    const auto parting = [&](std::size_t step, const QString &text) {
        return PartingStep{step, explainStep(run, step).heading, text};
    };
    for (std::size_t index = trace.indexOfSetUp(primitive); index < end; ++index) {
        const TraceStep step = trace.stepAt(index);
        QString text;
        if (step.kind == StepKind::Span)
            text = pictures.firstExtraOn(trace.placeOf(step.span));
        if (step.kind == StepKind::Sample) {
            const PixelChange &pixel = trace.changes()[step.sample];
            text = pictures.differenceAt(pixel.x, pixel.y);
        }
        if (!text.isEmpty())
            return parting(index, text);
    }
    // The difference lies where the right run never comes.
    return parting(end - 1, pictures.firstInFrame());
}

std::optional<PartingStep> partingOfRedrawing(const Scene &scene, const Defect &redrawing)
{
    const auto run = traceScene(scene);
    if (!run)
        return std::nullopt;
    for (std::size_t i = 0; i < run->trace->primitiveCount(); ++i) {
        const Scene beginning = beginningOf(scene, i + 1);
        const PicturePair pictures(scene.frame, pictureOf(beginning), redrawing.redraw(beginning));
        if (!pictures.firstInFrame().isEmpty())
            return partingIn(*run, i, pictures);
    }
    return std::nullopt;
}

} // namespace

std::optional<PartingStep> partingStepOf(const Scene &scene, std::span<const Defect> defects)
{
    const Scene defective = steppedWithDefects(scene, defects);
    const bool isStepped
        = !defective.settings.bugs.isRight() || !defective.settings.testBugs.isRight();
    const auto redrawing = isStepped ? std::nullopt : redrawingAmong(defects);
    Scene right = scene;
    right.settings.arithmetic = defective.settings.arithmetic;
    const bool isArithmeticAlone = right == defective && !redrawing;
    if (isArithmeticAlone)
        right = scene;
    if (defective != right) {
        if (auto step = partingStepOf(right, defective))
            return step;
    }
    if (!redrawing)
        return std::nullopt;
    return partingOfRedrawing(defective, *redrawing);
}

} // namespace pixelplumb
