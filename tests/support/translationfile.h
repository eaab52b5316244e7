// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace pixelplumb {

/// A text of a .ts file: where the program asks for it, and what stands there for it.
struct TranslatedText {
    QString context;
    QString source;
    QStringList forms; ///< several where the text counts something
    QString state; ///< "unfinished", "vanished", "obsolete", or empty
    bool counts = false;

    /// "pixelplumb::ViewMenu: T&ruth"
    QString name() const { return context + QStringLiteral(": ") + source; }
};

/// Empty where the file cannot be read.
QList<TranslatedText> textsOf(const QString &path);

/// The translations of the project, "pixelplumb_de.ts" and so on, with their paths.
QStringList translationFiles();

} // namespace pixelplumb
