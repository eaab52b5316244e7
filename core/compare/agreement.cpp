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
        = {"All agree.",
           "The sample lies exactly on an edge, and the fill rules give it to different sides.",
           "A primitive of a kind that one of the methods does not draw covers the pixel.",
           "The same coverage; a level close to a rounding limit fell to the other side.",
           "The number type could hold the number that decides, but the increments added up to "
           "another one.",
           "The number type cannot hold the number that decides closely enough.",
           "The method itself departs from the truth, in exact arithmetic too.",
           "The recording ended at its limit before this pixel."};
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
