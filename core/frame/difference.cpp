// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/difference.h"

#include <QStringList>

namespace pixelplumb {

using namespace Qt::StringLiterals;

QString nameOf(Difference difference)
{
    switch (difference) {
    case Difference::None:
        break;
    case Difference::Missing:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "missing"));
    case Difference::Extra:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "extra"));
    case Difference::Colour:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "colour"));
    case Difference::Undecidable:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "undecidable"));
    }
    return u"none"_s;
}

QString DifferenceCounts::message() const
{
    QStringList parts;
    const auto add = [&](Difference difference, const char *what) {
        const std::int64_t number = count(difference);
        if (number > 0)
            parts.append(u"%1 %2 %3"_s.arg(number).arg(
                QLatin1String(number == 1 ? "pixel" : "pixels"), QLatin1String(what)));
    };
    add(Difference::Missing, "missing");
    add(Difference::Extra, "extra");
    add(Difference::Colour, "in another colour");
    return parts.join(u", "_s);
}

} // namespace pixelplumb
