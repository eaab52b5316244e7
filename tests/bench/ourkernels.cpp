// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/fastscan.h"
#include "core/frame/framebuffer.h"
#include "core/lab/contenders/straightloop.h"
#include "core/methods/method.h"
#include "lineup.h"

#include <algorithm>
#include <optional>

/// Our fast kernels, and the plain ones, each with the straight loop it is compared with.
namespace pixelplumb::bench {

namespace {

FrameSpec frameSpecOf(FrameSize size)
{
    FrameSpec spec;
    spec.width = size.width;
    spec.height = size.height;
    return spec;
}

class FrameContender : public Contender {
public:
    using Contender::Contender;

    Picture picture() final
    {
        const QImage image = m_frame->image();
        return pictureOfLines({image.width(), image.height()}, image.constBits(),
                              image.bytesPerLine());
    }

protected:
    void setFrame(FrameSize size) { m_frame.emplace(frameSpecOf(size)); }
    FrameView view() { return m_frame->view(); }

private:
    std::optional<FrameBuffer> m_frame;
};

class PlainContender final : public FrameContender {
public:
    explicit PlainContender(const ContenderInfo &info)
        : FrameContender(info)
        , m_method(methodNamed(info.sameAsPlain->method))
    {
    }

    void load(const Scene &scene) override
    {
        setFrame(scene.size);
        m_run.emplace(m_method, Primitives{{scene.triangles.begin(), scene.triangles.end()}, {}},
                      info().sameAsPlain->settings, view(), Kernels::Plain);
    }
    void draw() override { m_run->draw(view()); }

private:
    const Method *m_method;
    std::optional<Run> m_run;
};

class StraightContender final : public FrameContender {
public:
    StraightContender(const ContenderInfo &info, const StraightLoop &loop)
        : FrameContender(info)
        , m_loop(loop)
    {
    }

    void load(const Scene &scene) override
    {
        setFrame(scene.size);
        m_triangles.clear();
        for (const Triangle &triangle : scene.triangles)
            m_triangles.push_back(triangleFor(m_loop, triangle));
    }
    void draw() override
    {
        const RawFrame raw = rawFrameFor(m_loop, view());
        for (const Triangle &triangle : m_triangles)
            m_loop.drawClosed(triangle, raw);
    }

private:
    StraightLoop m_loop;
    std::vector<Triangle> m_triangles;
};

class FastContender final : public FrameContender {
public:
    FastContender(const ContenderInfo &info, const FastOptions &options)
        : FrameContender(info)
        , m_options(options)
    {
    }

    void load(const Scene &scene) override
    {
        setFrame(scene.size);
        m_triangles = scene.triangles;
    }
    void draw() override { drawFast(m_triangles, info().sameAsPlain->settings, view(), m_options); }

private:
    FastOptions m_options;
    std::span<const Triangle> m_triangles;
};

QString textOf(std::string_view text)
{
    return QString::fromLatin1(text.data(), qsizetype(text.size()));
}

/// plain-row-walk-float32, or its straight loop straight-row-walk-float32.
ContenderInfo infoOf(const StraightLoop &loop, Role role)
{
    const bool isPlain = role == Role::Ours;
    const QString what
        = QString::fromLatin1(loop.method) + QLatin1Char('-') + textOf(nameOf(loop.arithmetic));
    ContenderInfo info;
    info.id = (isPlain ? u"plain-"_s : u"straight-"_s) + what;
    info.name
        = (isPlain ? u"ours, plain kernel, %1, %2, closed"_s : u"straight loop, %1, %2, closed"_s)
              .arg(QLatin1String(loop.method), textOf(nameOf(loop.arithmetic)));
    info.role = role;
    if (isPlain)
        info.twinId = u"straight-"_s + what;
    info.sameAsPlain = {QString::fromLatin1(loop.method),
                        {loop.arithmetic, FillRule::Closed, ByteRounding::Nearest}};
    return info;
}

/// One variant of the fast path.
struct Variant {
    InstructionSet instructionSet = InstructionSet::Scalar;
    Shading shading = Shading::Smooth;
    int threads = 1;
    ScanSettings settings = {Arithmetic::Exact, FillRule::HalfOpenColumn, ByteRounding::Nearest};
};

/// fast-avx2, fast-avx2-flat, fast-avx2-2-threads, fast-avx2-closed, fast-avx2-float32-closed
QString idOf(const Variant &variant)
{
    QString id = u"fast-"_s + textOf(nameOf(variant.instructionSet));
    if (variant.shading == Shading::Flat)
        id += u"-flat"_s;
    if (variant.threads != 1)
        id += u"-%1-threads"_s.arg(variant.threads);
    if (variant.settings.arithmetic != Arithmetic::Exact)
        id += QLatin1Char('-') + textOf(nameOf(variant.settings.arithmetic));
    if (variant.settings.fillRule != FillRule::HalfOpenColumn)
        id += QLatin1Char('-') + textOf(nameOf(variant.settings.fillRule));
    return id;
}

void add(Lineup &lineup, const Variant &variant)
{
    ContenderInfo info;
    info.id = idOf(variant);
    QStringList parts = {u"ours, fast"_s, textOf(nameOf(variant.instructionSet)),
                         textOf(nameOf(variant.settings.arithmetic))};
    if (variant.settings.fillRule != FillRule::HalfOpenColumn)
        parts << textOf(nameOf(variant.settings.fillRule));
    if (variant.threads != 1)
        parts << u"%1 threads"_s.arg(variant.threads);
    info.name = parts.join(u", "_s);
    info.role = Role::Ours;
    info.shading = variant.shading;
    info.threads = variant.threads;
    info.sameAsPlain.emplace().settings = variant.settings;
    FastOptions options;
    options.threads = variant.threads;
    options.instructionSet = variant.instructionSet;
    lineup.contenders.push_back(std::make_unique<FastContender>(info, options));
}

} // namespace

Picture plainPicture(const Scene &scene, const PlainKernel &kernel)
{
    ContenderInfo info;
    info.sameAsPlain = kernel;
    PlainContender contender(info);
    contender.load(scene);
    contender.draw();
    return contender.picture();
}

void addPlain(Lineup &lineup)
{
    ContenderInfo halfOpen;
    halfOpen.id = u"plain-half-open"_s;
    halfOpen.name = u"ours, plain kernel, exact"_s;
    halfOpen.role = Role::Ours;
    halfOpen.sameAsPlain.emplace().settings
        = {Arithmetic::Exact, FillRule::HalfOpenColumn, ByteRounding::Nearest};
    lineup.contenders.push_back(std::make_unique<PlainContender>(halfOpen));
    for (const StraightLoop &loop : straightLoops()) {
        lineup.contenders.push_back(std::make_unique<PlainContender>(infoOf(loop, Role::Ours)));
        lineup.contenders.push_back(
            std::make_unique<StraightContender>(infoOf(loop, Role::Straight), loop));
    }
}

void addFast(Lineup &lineup)
{
    std::vector<InstructionSet> sets = supportedInstructionSets();
    const InstructionSet best = sets.back();
    std::ranges::reverse(sets);
    lineup.referenceId = idOf({best});
    for (const Shading shading : {Shading::Smooth, Shading::Flat}) {
        for (const InstructionSet set : sets)
            add(lineup, {set, shading});
        add(lineup, {best, shading, 2});
    }
    const auto closed = [&](Arithmetic arithmetic) {
        add(lineup,
            {best, Shading::Smooth, 1, {arithmetic, FillRule::Closed, ByteRounding::Nearest}});
    };
    closed(Arithmetic::Exact);
    closed(Arithmetic::Float32);
}

} // namespace pixelplumb::bench
