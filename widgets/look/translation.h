// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QTranslator>

namespace pixelplumb {

/// The window's words in a person's language, and in the same one those of Qt's own dialogs (OK,
/// Cancel), as long as it lives. The texts in the sources are English; what English has a file for
/// is its plural forms.
class Translation {
public:
    /// Of the languages, "de-AT" or "de_AT", in the order in which a person wants them, the first
    /// that there is a file for; English where there is none. It has to stand before the first
    /// widget, and after the application.
    explicit Translation(const QStringList &languages);

    QString language() const { return m_ours.language(); } ///< "de"

private:
    bool load(QString language);

    QTranslator m_ours;
    QTranslator m_ofQt;
};

} // namespace pixelplumb
