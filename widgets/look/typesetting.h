// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// Text with true minus signs, and no-break thin spaces in mixed numbers: "12 5/54".
QString typeset(QString text);

/// typeset() as rich text, with symbols (SymbolText) and smaller fractions, so that 7 11/54 is not
/// read as 711/54.
QString typesetHtml(const QString &text);

} // namespace pixelplumb
