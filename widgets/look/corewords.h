// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string_view>

namespace pixelplumb {

/// A name that core has for a part of a scene, of a run or of a verdict, in the window's language:
/// "triangle", "missing", "Column 27, second half", whose number stays. Core is English, as files
/// and the command line are, and so are its sentences on methods; names alone stand in the
/// window's own sentences. One without a translation stays as it is.
QString coreWord(const QString &english);
QString coreWord(std::string_view english);
/// Several of them, line by line and word by word: "When finished: 68 px wrong, truth 1320 px ·
/// plain kernel 3.02 ns a pixel".
QString coreWords(const QString &english, const QString &separator);

} // namespace pixelplumb
