// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace pixelplumb {

using namespace Qt::StringLiterals;

/// A text of a .ts file: where the program uses it, and its translation.
struct TranslatedText {
    QString context;
    QString source;
    QStringList forms; ///< several if the text depends on a number
    QString state; ///< "unfinished", "vanished", "obsolete", or empty
    bool counts = false;

    /// "pixelplumb::ViewMenu: T&ruth"
    QString name() const { return context + u": "_s + source; }
};

/// Empty if the file cannot be read.
QList<TranslatedText> textsOf(const QString &path);

/// The paths of the project's translations, "pixelplumb_de.ts" and so on.
QStringList translationFiles();

} // namespace pixelplumb
