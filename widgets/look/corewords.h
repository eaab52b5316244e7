// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtCore>

#include <string_view>

namespace pixelplumb {

struct Method;

/// The window's translation of a name that core gives to a part of a scene, a run or a verdict:
/// "triangle", "missing", "Column 27, second half"; numbers stay. Core is English, as files and the
/// command line are, and so are its sentences on methods; only names enter the window's own
/// sentences. A name without a translation stays as it is. Core marks its words with
/// QT_TRANSLATE_NOOP("core", …).
QString coreWord(const QString &english);
QString coreWord(std::string_view english);
/// Translates several names, line by line and word by word: "When finished: 68 px wrong, truth 1320
/// px · plain kernel 3.02 ns a pixel".
QString coreWords(const QString &english, const QString &separator);

/// Core's sentences, each translated like a name, where all of them have a translation; else, so
/// that no text is half translated, inEnglish().
QString coreSentences(const QString &english);
/// A text of core that stays in English, and says so in another language.
QString inEnglish(const QString &english);

/// A method's name, and its sentence about itself, in the window's language; in English, as in
/// files, exports and on the command line, where there is no translation.
QString methodTitle(const Method &method);
QString methodSummary(const Method &method);

/// The translations of the window's texts and of Qt's own dialogs (OK, Cancel) into one language,
/// while the object lives. The texts in the sources are English; the English file holds only plural
/// forms.
class Translation {
public:
    /// Loads the first of the languages ("de-AT" or "de_AT", the preferred one first) that has a
    /// file; English where none has. Must be constructed after the application and before the first
    /// widget.
    explicit Translation(const QStringList &languages);

    QString language() const { return m_ours.language(); } ///< "de"

private:
    bool load(QString language);

    QTranslator m_ours;
    QTranslator m_ofQt;
};

} // namespace pixelplumb
