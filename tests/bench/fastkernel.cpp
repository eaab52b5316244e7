// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/fastscan.h"
#include "core/frame/framebuffer.h"
#include "lineup.h"

#include <algorithm>
#include <optional>

namespace pixelplumb::bench {

namespace {

class FastPath final : public Contender {
public:
    FastPath(const ContenderInfo &info, const ScanSettings &settings, const FastOptions &options)
        : Contender(info)
        , m_settings(settings)
        , m_options(options)
    {
    }

    void load(const Scene &scene) override
    {
        FrameSpec spec;
        spec.width = scene.size.width;
        spec.height = scene.size.height;
        m_frame.emplace(spec);
        m_triangles = scene.triangles;
    }
    void draw() override { drawFast(m_triangles, m_settings, m_frame->view(), m_options); }
    Picture picture() override
    {
        const QImage image = m_frame->image();
        return pictureOfLines({image.width(), image.height()}, image.constBits(),
                              image.bytesPerLine());
    }

private:
    ScanSettings m_settings;
    FastOptions m_options;
    std::optional<FrameBuffer> m_frame;
    std::span<const Triangle> m_triangles;
};

/// One variant of the fast path.
struct Variant {
    InstructionSet instructionSet = InstructionSet::Scalar;
    Shading shading = Shading::Smooth;
    int threads = 1;
    ScanSettings settings = {Arithmetic::Exact, FillRule::HalfOpenColumn, ByteRounding::Nearest};
};

QString textOf(std::string_view text)
{
    return QString::fromLatin1(text.data(), qsizetype(text.size()));
}

/// fast-avx2, fast-avx2-flat, fast-avx2-2-threads, fast-avx2-closed, fast-avx2-float32-closed
QString idOf(const Variant &variant)
{
    QString id = QStringLiteral("fast-") + textOf(nameOf(variant.instructionSet));
    if (variant.shading == Shading::Flat)
        id += QStringLiteral("-flat");
    if (variant.threads != 1)
        id += QStringLiteral("-%1-threads").arg(variant.threads);
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
    QStringList parts = {QStringLiteral("ours, fast"), textOf(nameOf(variant.instructionSet)),
                         textOf(nameOf(variant.settings.arithmetic))};
    if (variant.settings.fillRule != FillRule::HalfOpenColumn)
        parts << textOf(nameOf(variant.settings.fillRule));
    if (variant.threads != 1)
        parts << QStringLiteral("%1 threads").arg(variant.threads);
    info.name = parts.join(QStringLiteral(", "));
    info.role = Role::Ours;
    info.shading = variant.shading;
    info.threads = variant.threads;
    info.sameAsPlain.emplace().settings = variant.settings;
    FastOptions options;
    options.threads = variant.threads;
    options.instructionSet = variant.instructionSet;
    lineup.contenders.push_back(std::make_unique<FastPath>(info, variant.settings, options));
}

} // namespace

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
