// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/typedpixel.h"

#include <QRegularExpression>

namespace pixelplumb {

std::optional<QPoint> typedPixel(const QString &text)
{
    static const QRegularExpression form(
        QStringLiteral(R"(^\s*\(?\s*(-?\d{1,10})\s*[,; ]\s*(-?\d{1,10})\s*\)?\s*$)"));
    const auto match = form.match(text);
    bool xFits = false;
    bool yFits = false;
    const QPoint pixel(match.captured(1).toInt(&xFits), match.captured(2).toInt(&yFits));
    return match.hasMatch() && xFits && yFits ? std::optional(pixel) : std::nullopt;
}

} // namespace pixelplumb
