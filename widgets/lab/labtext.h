// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/pareto.h"

#include <QtGui>

namespace pixelplumb {

/// Breaks a text into lines of at most `width` logical pixels, between words, and within words that
/// are longer.
QStringList wrappedLines(const QString &text, const QFont &font, double width);

/// A time or a share in few digits: "1.65", "16.5", "165".
QString figureText(double value);
/// "1.65 (1.60 … 1.71)": the median and the middle half.
QString spreadText(const Spread &spread);

/// Everything that is known about a dot of the Pareto chart, timed or not.
QString pointHtml(const Study &study, const ParetoPoint &point, const QString &family);
QString untimedHtml(const Study &study, const ParetoPoint &point, const QString &family);
/// What a row of the error axis means; empty for errors above 0.
QString errorClassText(ErrorClass errorClass);
/// What a straight loop is, and what it is for.
QString straightLoopText();
enum class LabelLength { Whole, Short };
/// "wrong pixels per million"; "per million".
QString errorLabel(const ErrorAxis &axis, LabelLength length);
/// The HTML without its tags, a line each.
QString plainText(const QString &html);
/// The label of a dot: "Column scan, float32 ×1", "… ! ×1.8".
QString pointLabel(const ParetoPoint &point);

/// "48 of 10213 pixels wrong: 20 missing, 28 extra, …"
QString wrongText(const AccuracyFigures &figures);
/// Why a row shows nothing: "took too long", and any remark.
QString outcomeText(const LabRow &row);

/// Machine, compiler and flags; the command that repeats the study.
QStringList originOf(const Study &study);
/// originOf(), then each warning: for the foot of a chart on paper.
QStringList figureOrigin(const Study &study);

/// What accuracy costs on a family, in words: the column scan's plain kernel in each arithmetic
/// compared with its float32, by time and by wrong pixels; empty until both are known.
QString priceText(const Study &study, const QString &family);

/// The lab's text before its first run: what the button does and how many seconds that takes.
QString invitationText(StudyExtent extent, double seconds);

} // namespace pixelplumb
