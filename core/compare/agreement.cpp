// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/agreement.h"

namespace pixelplumb {

QString nameOf(Disagreement reason)
{
    static constexpr std::array names
        = {QT_TRANSLATE_NOOP("core", "agreed"),         QT_TRANSLATE_NOOP("core", "tie rule"),
           QT_TRANSLATE_NOOP("core", "kind not drawn"), QT_TRANSLATE_NOOP("core", "rounding"),
           QT_TRANSLATE_NOOP("core", "drift"),          QT_TRANSLATE_NOOP("core", "precision"),
           QT_TRANSLATE_NOOP("core", "method"),         QT_TRANSLATE_NOOP("core", "not recorded")};
    static_assert(names.size() == std::size_t(Disagreement::NotRecorded) + 1);
    return QString::fromUtf8(names[std::size_t(reason)]);
}

QString textOf(Disagreement reason)
{
    static constexpr std::array texts
        = {QT_TRANSLATE_NOOP("core", "All agree."),
           QT_TRANSLATE_NOOP("core",
                             "The sample lies exactly on an edge, where the fill rules disagree."),
           QT_TRANSLATE_NOOP(
               "core",
               "One of the methods does not draw the kind of primitive that covers this pixel."),
           QT_TRANSLATE_NOOP(
               "core",
               "The coverage is the same, but a level close to a rounding limit was rounded the "
               "other way."),
           QT_TRANSLATE_NOOP(
               "core",
               "The number type can represent the exact value, but the accumulated increments "
               "missed it."),
           QT_TRANSLATE_NOOP("core",
                             "The number type cannot represent the deciding value closely enough."),
           QT_TRANSLATE_NOOP("core",
                             "The method itself differs from the truth, even in exact arithmetic."),
           QT_TRANSLATE_NOOP("core", "The recording reached its limit before this pixel.")};
    static_assert(texts.size() == std::size_t(Disagreement::NotRecorded) + 1);
    return QString::fromUtf8(texts[std::size_t(reason)]);
}

void AgreementMap::set(std::int64_t x, std::int64_t y, int agreeing, Disagreement reason)
{
    Pixel &pixel = m_pixels.at(x, y);
    const auto count = [this](const Pixel &of, std::int64_t change) {
        m_byAgreeing[of.agreeing] += change;
        m_byReason[std::size_t(of.reason)] += change;
    };
    count(pixel, -1);
    pixel = {std::uint8_t(agreeing), reason};
    count(pixel, 1);
}

} // namespace pixelplumb
