// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QTranslator>

namespace pixelplumb {

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
