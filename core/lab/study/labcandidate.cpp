// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/labcandidate.h"

#include "core/frame/framebuffer.h"
#include "core/frame/writtenframe.h"
#include "core/lab/judging/invariance.h"
#include "core/measure/stopwatch.h"
#include "core/number/failure.h"
#include "core/runs/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

bool isBlank(const FrameView &frame)
{
    for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
        const QRgb *const row = frame.at(frame.firstColumn, y);
        if (!std::all_of(row, row + frame.width, [](QRgb pixel) { return pixel == 0; }))
            return false;
    }
    return true;
}

void wipe(const FrameView &frame, const SampleBox &box)
{
    for (std::int64_t y = box.firstY; y < box.endY && box.firstX < box.endX; ++y)
        std::fill_n(frame.at(box.firstX, y), box.endX - box.firstX, QRgb(0));
}

std::int64_t samplesIn(const SampleBox &box)
{
    return std::max<std::int64_t>(0, box.endX - box.firstX)
        * std::max<std::int64_t>(0, box.endY - box.firstY);
}

/// Whether a method does more work for the same triangle if the frame around it is larger, by its
/// counted operations.
bool visitsWholeFrame(const Method &method, const ScanSettings &settings)
{
    Primitives corner;
    corner.triangles
        = {{{{{latticePixel(2, 2), {}}, {latticePixel(9, 3), {}}, {latticePixel(4, 8), {}}}}}};
    const auto workIn = [&](std::int32_t side) {
        FrameSpec spec;
        spec.width = side;
        spec.height = side;
        const FrameBuffer frame(spec);
        const auto counts = countOperations(method, settings, corner, frame.view());
        return counts ? counts->pixels + counts->refused : 0;
    };
    return workIn(37) > workIn(17);
}

} // namespace

LabCandidate::LabCandidate(const LabContender &contender, const LabFamily &family,
                           const AccuracyOptions &options)
    : m_contender(contender)
    , m_family(family)
    , m_options(options)
{
    if (const auto settings = settingsFor(contender, family)) {
        m_verdict.settings = *settings;
        m_visitsFrame = contender.kernel == LabKernel::Plain
            && visitsWholeFrame(*contender.method, *settings);
        if (family.isMesh)
            m_cover.emplace(family.pictures.front().frame);
    } else {
        m_verdict.outcome = LabOutcome::Refused;
        m_verdict.remark = contender.kernel == LabKernel::Peer
            ? u"is given whole pixels inside the frame alone"_s
            : u"keeps no rule under which every sample has one owner"_s;
    }
}

void LabCandidate::fail(const QString &why)
{
    m_verdict.outcome = LabOutcome::Failed;
    m_verdict.remark = why;
}

void LabCandidate::giveUp(const QString &why)
{
    m_verdict.outcome = LabOutcome::TookTooLong;
    m_verdict.remark = why
        + u" for %1 of %2 triangles"_s.arg(m_judge.figures().triangles)
              .arg(m_family.triangleCount());
}

void LabCandidate::takeChunk(const LabChunk &chunk, const FrameView &frame)
{
    const auto why = failureOf([&] {
        const PictureJudge judgeBefore = m_judge;
        const std::optional<MeshCover> coverBefore = m_cover;
        drawAll(chunk, frame, Look::Near);
        if (isRunning() && !isBlank(frame)) {
            // It painted far from a triangle: draw again and look at the whole frame.
            wipe(frame, samplesOf(frame));
            m_judge = judgeBefore;
            m_cover = coverBefore;
            drawAll(chunk, frame, Look::Everywhere);
        }
        if (!m_frameOfMiss && m_judge.firstMiss())
            m_frameOfMiss = chunk.picture->frame;
        if (isRunning())
            lookClosely(chunk, frame);
    });
    if (why)
        fail(*why);
    if (!isRunning())
        wipe(frame, samplesOf(frame));
}

void LabCandidate::drawAll(const LabChunk &chunk, const FrameView &frame, Look look)
{
    for (const auto &byRule : chunk.truths) {
        const TruePicture &truth = byRule.at(settings().fillRule);
        const Run run = m_contender.runOf({{*truth.triangle}, {}}, settings(), frame);
        const Stopwatch stopwatch;
        m_contender.draw(run, frame);
        m_verdict.nanoseconds += stopwatch.elapsed().thread;
        const SampleBox box
            = look == Look::Near ? samplesOf(truth.window.view()) : samplesOf(frame);
        m_judge.judge(truth, frame, box);
        if (m_cover)
            m_cover->add(frame, box);
        wipe(frame, box);
        m_samples
            += look == Look::Near && m_visitsFrame ? samplesIn(samplesOf(frame)) : samplesIn(box);
        if (m_samples > m_options.mostSamples)
            giveUp(u"looked at more than %1 samples"_s.arg(m_options.mostSamples));
        else if (m_verdict.nanoseconds > m_options.hangSeconds * 1e9)
            giveUp(u"took more than %1 s"_s.arg(m_options.hangSeconds));
        if (!isRunning())
            return;
    }
}

void LabCandidate::lookClosely(const LabChunk &chunk, const FrameView &frame)
{
    for (const auto &byRule : chunk.truths) {
        const TruePicture &truth = byRule.at(settings().fillRule);
        if (truth.window.isEmpty() || doubledArea(*truth.triangle) == 0)
            continue;
        if (m_contender.kernel == LabKernel::Plain && m_probedPixels < m_options.probedPixels) {
            PixelWindow window(samplesOf(truth.window.view()), frame);
            if (probeLevels(*m_contender.method, settings(), *truth.triangle, window.view(),
                            truth.window.view(), m_levels))
                m_probedPixels += std::max<std::int64_t>(truth.pixels, 1);
        }
        // What a peer does on a frame elsewhere depends on its caller.
        if (m_contender.kernel != LabKernel::Peer && m_movedPixels < m_options.movedPixels) {
            m_movedPixels += std::int64_t(truth.window.pixels().size());
            addInvariance(m_contender, settings(), *truth.triangle, frame, m_judge.figures());
        }
    }
}

void LabCandidate::addFlicker()
{
    if (m_family.motion.empty() || m_contender.kernel == LabKernel::Peer)
        return;
    const WrittenFrame frame(m_family.pictures.front().frame);
    const Toggles toggles = togglesOf(m_contender, settings(), m_family.motion, frame.view());
    m_judge.figures().flicker = toggles.drawn - toggles.ofTruth;
    m_judge.figures().trueToggles = toggles.ofTruth;
}

void LabCandidate::countOperationsOfFirst()
{
    if (m_contender.kernel != LabKernel::Plain)
        return;
    const LabPicture &picture = m_family.pictures.front();
    const WrittenFrame frame(picture.frame);
    Primitives first;
    std::int64_t pixels = 0;
    for (const Triangle &triangle : picture.triangles) {
        if (pixels > m_options.countedPixels)
            break;
        first.triangles.push_back(triangle);
        const SampleBox box = windowAround(triangle, 0, frame.view());
        if (!box.isEmpty())
            pixels += (box.endX - box.firstX) * (box.endY - box.firstY) / 2;
    }
    m_verdict.operations = countOperations(*m_contender.method, settings(), first, frame.view());
}

/// Finds the first pixel that a drawing of the first wrong triangle gets wrong.
void LabCandidate::findFirstMiss()
{
    const auto &miss = m_judge.firstMiss();
    if (!miss)
        return;
    Scene scene;
    scene.frame = *m_frameOfMiss;
    scene.settings = settings();
    scene.method = m_contender.method->id.toStdString();
    scene.triangles = {miss->triangle};
    m_verdict.firstMiss = LabMiss{scene, miss->x, miss->y};
    if (const auto first = traceScene(scene)->firstWrongPixel()) {
        m_verdict.firstMiss->x = first->x;
        m_verdict.firstMiss->y = first->y;
    }
}

void LabCandidate::finish(const MeshCover *trueCover)
{
    if (!isRunning())
        return;
    const auto why = failureOf([&] {
        addFlicker();
        countOperationsOfFirst();
        findFirstMiss();
    });
    if (why) {
        fail(*why);
        return;
    }
    AccuracyFigures &figures = m_judge.figures();
    if (m_probedPixels > 0) {
        figures.levels = m_levels.errors();
        figures.notANumber = m_levels.notANumber;
        figures.infinite = m_levels.infinite;
        figures.clamped = m_levels.clamped;
    }
    if (m_cover && trueCover) {
        figures.gaps = m_cover->gapsBeside(*trueCover);
        figures.doubles = m_cover->doublesBeside(*trueCover);
    }
    m_verdict.accuracy = figures;
    m_verdict.outcome = LabOutcome::Measured;
    m_levels = {};
    m_cover.reset();
}

} // namespace pixelplumb
