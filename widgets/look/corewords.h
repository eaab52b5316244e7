// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string_view>

namespace pixelplumb {

/// The window's translation of a name that core gives to a part of a scene, a run or a verdict:
/// "triangle", "missing", "Column 27, second half"; numbers stay. Core is English, as files and the
/// command line are, and so are its sentences on methods; only names enter the window's own
/// sentences. A name without a translation stays as it is.
QString coreWord(const QString &english);
QString coreWord(std::string_view english);
/// Translates several names, line by line and word by word: "When finished: 68 px wrong, truth 1320
/// px · plain kernel 3.02 ns a pixel".
QString coreWords(const QString &english, const QString &separator);

} // namespace pixelplumb
