// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

#include <cmath>

namespace pixelplumb::bench {

/// A positive value with three significant digits, whole ones in full: 1,234,567 1,230 12.3 0.0123
/// 7.
inline QString numberText(double value)
{
    const int magnitude = value > 0 ? int(std::floor(std::log10(value))) : 0;
    if (magnitude >= 3 || value == std::floor(value)) {
        const QLocale grouped(QLocale::English, QLocale::UnitedStates);
        return grouped.toString(qlonglong(std::llround(value)));
    }
    return QLocale::c().toString(value, 'f', std::max(0, 2 - magnitude));
}

} // namespace pixelplumb::bench
