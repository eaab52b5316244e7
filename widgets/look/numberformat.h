// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/scan/scansettings.h"

#include <QString>

#include <cstdint>

namespace pixelplumb {

/// Between the whole part and the fraction of a mixed number.
inline constexpr QChar thinSpace(0x2009);
/// Decimals in which a used number and the exact one are compared: more than a double has.
inline constexpr int comparedPlaces = 20;

/// Numbers have a decimal point in every language, and no signs between thousands: what a panel
/// shows is compared with the course texts, with exports and with the command line, and is typed
/// and copied back from there. It is called before the first widget, which keeps the locale of its
/// moment.
void keepDecimalPoint();

/// A quantity for the eye: mixed numbers with a thin space ("17 3/8") while the denominator has at
/// most six digits, else decimals with six places and an ellipsis; floating point by its shortest
/// decimal; a true minus sign. Canonical text for copying and files is toText().
QString displayText(const Quantity &quantity);

/// The same for a number that a kernel used. Fixed-point numbers are shown in decimals, so that
/// their digits stand below those of the exact number; n/65536 would not.
QString displayText(const Quantity &quantity, Arithmetic arithmetic);

/// The same as decimals with six places, for a tooltip or a second line.
QString displayDecimal(const Quantity &quantity);

/// The decimals of a quantity with a number of places, as cutDecimal() has them: every digit shown
/// is a digit of the number, none is rounded, and an ellipsis says that more follow.
QString displayDecimal(const Quantity &quantity, int places);

/// As displayDecimal(), but for numbers so near to a whole one that this needs more places to part
/// them: "12 + 2e−15".
QString shortDecimal(const Quantity &quantity, int places);

/// What six decimals say beside displayText() of the same: "= 31.875" where they are all,
/// "≈ 5.129629…" where more follow; empty where they would say it once more.
QString decimalBeside(const Quantity &quantity, Arithmetic arithmetic = Arithmetic::Exact);

/// An error for the eye: "+2.3e−07", or "0" when the two are equal.
QString displayError(const Quantity &used, const Quantity &exact);

/// Large numbers that are counted or measured, in groups of thousands, which a narrow space that
/// does not break keeps apart: no language takes it for a decimal sign.
QString groupedText(std::int64_t number);
QString groupedText(double number, int places);

/// Index into displayText(used) of the first character that differs from the exact decimal, −1 if
/// none: panels mark the number from there on. An exact decimal that ends in an ellipsis says
/// nothing of the digits after it; one that does not goes on in zeros.
int firstDifferingDigit(const QString &used, const QString &exactDecimal);

} // namespace pixelplumb
