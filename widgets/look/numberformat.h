// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/scan/scansettings.h"

#include <QString>

#include <cstdint>

namespace pixelplumb {

/// Separates the whole part and the fraction of a mixed number.
inline constexpr QChar thinSpace(0x2009);
/// Decimals in which a used number and the exact one are compared: more than a double has.
inline constexpr int comparedPlaces = 20;

/// Sets a locale with a decimal point and without thousands separators, whatever the language: what
/// a panel shows is compared with the course texts, exports and the command line, and is typed and
/// copied from there. Call it before the first widget is created, since widgets keep the locale of
/// that moment.
void keepDecimalPoint();

/// A quantity for display: mixed numbers with a thin space ("17 3/8") while the denominator has at
/// most six digits, else decimals with six places and an ellipsis; floating point by its shortest
/// decimal; a true minus sign. Canonical text for copying and files is toText().
QString displayText(const Quantity &quantity);

/// displayText() for a number that a kernel used. Fixed-point numbers are shown as decimals, so
/// that their digits align with those of the exact number; n/65536 would not.
QString displayText(const Quantity &quantity, Arithmetic arithmetic);

/// The quantity as decimals with six places, for a tool tip or a second line.
QString displayDecimal(const Quantity &quantity);

/// The quantity as decimals with a number of places, as cutDecimal() cuts them: every digit shown
/// is a digit of the number, none is rounded, and an ellipsis says that more follow.
QString displayDecimal(const Quantity &quantity, int places);

/// Like displayDecimal(), except for numbers so near to a whole one that more places would be
/// needed to tell them apart: "12 + 2e−15".
QString shortDecimal(const Quantity &quantity, int places);

/// The decimals to show beside a fraction from displayText(): "= 31.875" where they are complete,
/// "≈ 5.129629…" where more follow; empty where they would repeat it.
QString decimalBeside(const Quantity &quantity, Arithmetic arithmetic = Arithmetic::Exact);

/// An error for display: "+2.3e−07", or "0" when the two are equal.
QString displayError(const Quantity &used, const Quantity &exact);

/// A large count or measurement in groups of thousands, separated by a narrow no-break space, which
/// no language reads as a decimal sign.
QString groupedText(std::int64_t number);
QString groupedText(double number, int places);

/// Index into displayText(used) of the first character that differs from the exact decimal, −1 if
/// none: panels mark the number from there on. An exact decimal that ends in an ellipsis says
/// nothing about later digits; any other continues in zeros.
int firstDifferingDigit(const QString &used, const QString &exactDecimal);

} // namespace pixelplumb
