// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/variantreason.h"

#include "core/runs/contender.h"
#include "core/scan/choicenames.h"

namespace pixelplumb {

namespace {

constexpr std::int64_t largestRedrawn = std::int64_t(1) << 18; ///< px, in less than a millisecond

QRgb pixelOf(std::size_t primitive, const TracedScene &traced, VariantSet variants, std::int64_t x,
             std::int64_t y)
{
    ScanSettings settings = traced.scene.settings;
    settings.variants = variants;
    const FrameBuffer frame(traced.scene.frame);
    Run(traced.method, aloneOf(traced.primitives, primitive), settings, frame.view())
        .draw(frame.view());
    return *frame.view().at(x, y);
}

/// The variants without which the primitive would treat the pixel differently. All, if only several
/// together make the difference or the frame is too large to test each.
std::vector<Variant> variantsToBlame(const PixelAttempt &attempt, const TracedScene &traced,
                                     std::int64_t x, std::int64_t y)
{
    const VariantSet set = traced.scene.settings.variants;
    const FrameSpec &frame = traced.scene.frame;
    std::vector<Variant> all;
    for (const Variant variant : variantsIn(set))
        all.push_back(variant);
    if (std::int64_t(frame.width) * frame.height > largestRedrawn)
        return all;
    const QRgb drawn = pixelOf(attempt.primitive, traced, set, x, y);
    std::vector<Variant> blamed;
    for (const Variant variant : all) {
        if (pixelOf(attempt.primitive, traced, set.without(variant), x, y) != drawn)
            blamed.push_back(variant);
    }
    return blamed.empty() && all.size() > 1 ? all : blamed;
}

} // namespace

QString variantText(const PixelAttempt &attempt, const TracedScene &traced, std::int64_t x,
                    std::int64_t y)
{
    QString text;
    for (const Variant variant : variantsToBlame(attempt, traced, x, y)) {
        const VariantWords &words = wordsOf(variant, traced.method->spanAxis);
        text += QStringLiteral(" The run has the variant “%1”: %2 in place of %3. %4")
                    .arg(nameText(words.title), nameText(words.printed), nameText(words.right),
                         nameText(words.fault));
    }
    return text;
}

} // namespace pixelplumb
