// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/hardcase.h"
#include "core/methods/method.h"

#include <QStringList>

#include <map>

/// What the rounding arithmetics get wrong in each hard case: every method × arithmetic × fill rule
/// that the case has facts for and that is not claimed stable. A combination that is right has no
/// entry.
namespace pixelplumb::search {

/// The contenders that fall short in one case, grouped by what they get wrong: "2 missing, 3 extra"
/// → "column-scan float32 closed".
using CaseRecord = std::map<QString, QStringList>;
/// Keyed by the case's id.
using FileRecord = std::map<QString, CaseRecord>;
/// Keyed by the name of the case file.
using ShortfallRecord = std::map<QString, FileRecord>;

/// Measures every contender on the case, or only those of the method with this id.
CaseRecord shortfallsOf(const HardCase &hardCase, QStringView methodId = {});

/// The record as JSON, one line per case and shortfall.
QByteArray textOf(const ShortfallRecord &record);
/// Empty if the text is no record.
ShortfallRecord readRecord(const QByteArray &text);

/// "sliver_fibonacci: column-scan float32 closed: 2 missing, 3 extra", sorted.
QStringList linesOf(const FileRecord &file);

} // namespace pixelplumb::search
