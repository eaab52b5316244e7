// SPDX-License-Identifier: GPL-3.0-or-later
#include "labstudy.h"

#include "core/lab/judging/pixelwindow.h"
#include "core/lab/study/labfile.h"
#include "core/scan/choicenames.h"
#include "picturecheck.h"

#include <algorithm>

namespace pixelplumb::bench {

namespace {

constexpr std::int64_t beyondBox = 3; ///< px around a triangle's box in which its pixels are
                                      ///< searched
constexpr QRgb opaque = 0xff000000;

/// Draws a mirrored triangle, so that the renderer's ties follow one of our rules, and mirrors the
/// pixels back into the frame, which begins at (0, 0).
void drawMirrored(Contender &peer, const TieRule &rule, const Primitives &primitives,
                  const FrameView &frame)
{
    const FrameSize size = {frame.width, frame.height};
    const std::vector<Triangle> seen = seenBy(primitives.triangles, rule, {}, size);
    peer.load({size, seen});
    peer.draw();
    const Picture picture = peer.picture();
    for (const Triangle &triangle : primitives.triangles) {
        const SampleBox box = windowAround(triangle, beyondBox, frame);
        for (std::int64_t y = box.firstY; y < box.endY; ++y) {
            for (std::int64_t x = box.firstX; x < box.endX; ++x) {
                const auto pixel = picture.at(int(rule.mirrorsColumns ? size.width - 1 - x : x),
                                              int(rule.mirrorsRows ? size.height - 1 - y : y));
                if (pixel != 0)
                    *frame.at(x, y) = opaque | pixel;
            }
        }
    }
}

LabContender labPeer(Contender &peer, const TieRule &rule)
{
    LabContender contender;
    contender.id = u"peer:"_s + peer.info().id;
    contender.label = peer.info().name + u", ties by "_s + QString::fromUtf8(rule.name);
    contender.method = methodNamed(u"column-scan");
    contender.kernel = LabKernel::Peer;
    contender.ownRule = rule.rule;
    contender.draw = [&peer, rule](const Run &run, const FrameView &frame) {
        drawMirrored(peer, rule, run.primitives, frame);
    };
    contender.loaded = {[&peer](const Primitives &primitives, const FrameView &frame) {
                            peer.load({{frame.width, frame.height}, primitives.triangles});
                        },
                        [&peer] { peer.draw(); }};
    return contender;
}

/// Whether a renderer is smooth, on the calling thread, and samples where we do.
bool takesPart(const ContenderInfo &info)
{
    const bool isOther = info.role == Role::Peer || info.role == Role::Student;
    return isOther && info.shading == Shading::Smooth && info.threads == 1
        && info.sampleOffset == LatticePoint();
}

} // namespace

QByteArray studyWithPeers(const Lineup &lineup, Extent extent,
                          const std::function<void(const QString &)> &progress)
{
    StudySettings settings;
    const bool isQuick = extent == Extent::Quick;
    settings.extent = isQuick ? StudyExtent::Quick : StudyExtent::Full;
    if (auto cases = builtInHardCases())
        settings.hardCases = std::move(*cases);
    const std::vector<Workload> workloads = standardWorkloads(Extent::Quick);
    const auto small = std::ranges::find(workloads, u"W3"_s, &Workload::id);
    PictureCheck check(*small, Extent::Quick);
    for (const std::unique_ptr<Contender> &peer : lineup.contenders) {
        if (!takesPart(peer->info()))
            continue;
        progress(u"looking at %1"_s.arg(peer->info().name));
        settings.peers.push_back(labPeer(*peer, check.check(*peer).rule));
    }
    StudyListener listener;
    listener.progress = [&](const JobProgress &told) {
        const double share = told.total == 0 ? 0 : double(told.done) / double(told.total);
        progress(u"%1: %2 %"_s.arg(nameText(nameOf(told.phase))).arg(int(100 * share)));
        return true;
    };
    Study study = runStudy(settings, listener);
    study.command = u"tests/bench/run --lab lab.json"_s;
    if (isQuick)
        study.command += u" --quick"_s;
    return writeStudy(study);
}

} // namespace pixelplumb::bench
