// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/labcontender.h"

#include "core/frame/framebuffer.h"
#include "core/scan/choicenames.h"

#include <algorithm>

namespace pixelplumb {

namespace {

const QString fastWord = "fast";
const QString peerWord = "peer";

/// What core/fast has kernels for; for the rest it uses the plain one.
bool isFastIn(const Method &method, Arithmetic arithmetic)
{
    return method.hasFastKernels
        && (arithmetic == Arithmetic::Exact || arithmetic == Arithmetic::Float32);
}

} // namespace

QString nameOf(LabKernel kernel)
{
    switch (kernel) {
    case LabKernel::Plain:
        return u"plain"_s;
    case LabKernel::Fast:
        return u"SIMD"_s;
    case LabKernel::Peer:
        return u"peer"_s;
    }
    return {};
}

LabKernel kernelOf(const QString &contender)
{
    if (contender.startsWith(peerWord + u':'))
        return LabKernel::Peer;
    return contender.endsWith(u':' + fastWord) ? LabKernel::Fast : LabKernel::Plain;
}

QString LabContender::domain() const
{
    if (!isProved())
        return {};
    if (kernel == LabKernel::Fast)
        return u"every triangle with vertices at 1/256 px, with the plain kernel; tests check "
               "that this kernel draws the same bytes"_s;
    if (arithmetic == Arithmetic::Exact)
        return u"every triangle with vertices at 1/256 px"_s;
    return u"triangles in boxes of up to 2^24 px², such as 4096 × 4096; larger ones are drawn in "
           "integers"_s;
}

ScanSettings LabContender::settingsUnder(FillRule rule) const
{
    if (ownRule)
        return {arithmetic, *ownRule, ByteRounding::Nearest};
    return method->adapted({arithmetic, rule, ByteRounding::Nearest});
}

Run LabContender::runOf(Primitives triangles, const ScanSettings &settings,
                        const FrameView &frame) const
{
    return {method, std::move(triangles), settings, frame,
            kernel == LabKernel::Fast ? Kernels::FastestOnOneThread : Kernels::Plain};
}

SpanAxis LabContender::spanAxis() const
{
    const FrameBuffer frame{FrameSpec()};
    Primitives primitives;
    primitives.triangles
        = {{{{{latticePixel(2, 2), {}}, {latticePixel(9, 3), {}}, {latticePixel(4, 8), {}}}}}};
    const auto trace = runOf(primitives, settingsUnder(FillRule::Closed), frame.view())
                           .trace(frame.view(), {.progress = {}, .detail = TraceDetail::Spans});
    return trace && trace->spanCount() > 0 ? trace->placeOf(0).axis : SpanAxis::Free;
}

std::optional<FillRule> LabContender::watertightRule() const
{
    for (const FillRule rule :
         {FillRule::HalfOpenColumn, FillRule::TopLeft, FillRule::OffScreenPoint}) {
        if (method->supports(rule))
            return rule;
    }
    return std::nullopt;
}

LabContender contenderOf(const Method &method, Arithmetic arithmetic, LabKernel kernel)
{
    const bool isFast = kernel == LabKernel::Fast;
    LabContender contender;
    contender.id = method.id + u':' + nameText(nameOf(arithmetic));
    contender.label = method.title + u", "_s + nameText(nameOf(arithmetic));
    if (isFast) {
        contender.id += u':' + fastWord;
        contender.label += u", "_s + nameOf(kernel);
    }
    contender.method = &method;
    contender.arithmetic = arithmetic;
    contender.kernel = kernel;
    contender.draw = [](const Run &run, FrameView frame) { run.draw(frame); };
    if (!isFast)
        contender.straight = straightLoopOf(method.id.toStdString(), arithmetic);
    return contender;
}

std::optional<LabContender> labContenderNamed(const QString &id)
{
    const QStringList words = id.split(u':');
    const Method *method = methodNamed(words.front());
    if (!method || !method->draws(PrimitiveKind::Triangle) || words.size() < 2 || words.size() > 3)
        return std::nullopt;
    const auto arithmetic = arithmeticNamed(words[1].toStdString());
    if (!arithmetic || !method->supports(*arithmetic))
        return std::nullopt;
    if (words.size() == 2)
        return contenderOf(*method, *arithmetic);
    if (words[2] != fastWord || !isFastIn(*method, *arithmetic))
        return std::nullopt;
    return contenderOf(*method, *arithmetic, LabKernel::Fast);
}

std::vector<LabContender> quickContenders()
{
    static constexpr const char *ids[] = {
        "column-scan:exact",
        "column-scan:float32",
        "column-scan:float64",
        "column-scan:fixed16.16",
        "column-scan:fixed32.32",
        "column-scan-bias:float64",
        "column-scan:exact:fast",
        "column-scan:float32:fast",
        "row-walk:exact",
        "row-walk:float32",
        "edge-equations-incremental:exact",
        "edge-equations-incremental:float32",
        "barycentric-incremental:exact",
        "barycentric-incremental:float32",
        "barycentric-relative:float32",
    };
    std::vector<LabContender> contenders;
    for (const char *id : ids)
        contenders.push_back(*labContenderNamed(QString::fromLatin1(id)));
    return contenders;
}

std::vector<LabContender> fullContenders()
{
    std::vector<LabContender> contenders;
    for (const Method &method : methods()) {
        if (!method.draws(PrimitiveKind::Triangle))
            continue;
        for (const Arithmetic arithmetic : method.arithmetics) {
            contenders.push_back(contenderOf(method, arithmetic));
            if (isFastIn(method, arithmetic))
                contenders.push_back(contenderOf(method, arithmetic, LabKernel::Fast));
        }
    }
    return contenders;
}

} // namespace pixelplumb
