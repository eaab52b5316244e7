// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/agreement.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

QString nameOf(Disagreement reason)
{
    switch (reason) {
    case Disagreement::None:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "agreed"));
    case Disagreement::TieRule:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "tie rule"));
    case Disagreement::Undrawn:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "kind not drawn"));
    case Disagreement::Rounding:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "rounding"));
    case Disagreement::Drift:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "drift"));
    case Disagreement::Precision:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "precision"));
    case Disagreement::Method:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "method"));
    case Disagreement::NotRecorded:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "not recorded"));
    }
    return {};
}

QString textOf(Disagreement reason)
{
    switch (reason) {
    case Disagreement::None:
        return u"All agree."_s;
    case Disagreement::TieRule:
        return u"The sample lies exactly on an edge, and the fill rules give it to "
               "different sides."_s;
    case Disagreement::Undrawn:
        return u"A primitive of a kind that one of the methods does not draw covers "
               "the pixel."_s;
    case Disagreement::Rounding:
        return u"The same coverage; a level close to a rounding limit fell to the "
               "other side."_s;
    case Disagreement::Drift:
        return u"The number type could hold the number that decides, but the "
               "increments added up to another one."_s;
    case Disagreement::Precision:
        return u"The number type cannot hold the number that decides closely "
               "enough."_s;
    case Disagreement::Method:
        return u"The method itself departs from the truth, in exact arithmetic too."_s;
    case Disagreement::NotRecorded:
        return u"The recording ended at its limit before this pixel."_s;
    }
    return {};
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
