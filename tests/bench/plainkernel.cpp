// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/methods/columnscan.h"
#include "lineup.h"

#include <optional>

namespace pixelplumb::bench {

namespace {

FrameSpec frameSpecOf(FrameSize size)
{
    FrameSpec spec;
    spec.width = size.width;
    spec.height = size.height;
    return spec;
}

/// The plain kernel: what the window steps through, with nothing listening.
class PlainKernel final : public Contender {
public:
    PlainKernel(const ContenderInfo &info, const ScanSettings &settings)
        : Contender(info)
        , m_settings(settings)
    {
    }

    void load(const Scene &scene) override
    {
        m_frame.emplace(frameSpecOf(scene.size));
        m_triangles = scene.triangles;
    }
    void draw() override { drawColumns(m_triangles, m_settings, m_frame->view()); }
    Picture picture() override
    {
        const QImage image = m_frame->image();
        return pictureOfLines({image.width(), image.height()}, image.constBits(),
                              image.bytesPerLine());
    }

private:
    ScanSettings m_settings;
    std::optional<FrameBuffer> m_frame;
    std::span<const Triangle> m_triangles;
};

} // namespace

Picture plainPicture(const Scene &scene, const ScanSettings &settings)
{
    PlainKernel kernel({}, settings);
    kernel.load(scene);
    kernel.draw();
    return kernel.picture();
}

void addPlain(Lineup &lineup)
{
    const auto add = [&](const char *id, const char *name, Arithmetic arithmetic, FillRule rule) {
        ContenderInfo info;
        info.id = QString::fromLatin1(id);
        info.name = QString::fromLatin1(name);
        info.role = Role::Ours;
        const ScanSettings settings = {arithmetic, rule, ByteRounding::Nearest};
        info.sameAsPlain = settings;
        lineup.contenders.push_back(std::make_unique<PlainKernel>(info, settings));
    };
    add("plain-half-open", "ours, plain kernel, exact", Arithmetic::Exact,
        FillRule::HalfOpenColumn);
    add("plain-closed", "ours, plain kernel, exact, closed", Arithmetic::Exact, FillRule::Closed);
    add("plain-float32", "ours, plain kernel, float32, closed", Arithmetic::Float32,
        FillRule::Closed);
}

} // namespace pixelplumb::bench
