// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/translation.h"

#include <QCoreApplication>
#include <QLibraryInfo>

#include <algorithm>

namespace pixelplumb {

Translation::Translation(const QStringList &languages)
{
    // English has a file, so that whoever wants it before German gets it.
    const auto loads = [this](const QString &language) { return load(language); };
    if (!std::ranges::any_of(languages, loads))
        load(QStringLiteral("en"));
    // Qt's words are in the language of ours, not in one that a person wants less.
    if (m_ofQt.load(QStringLiteral("qtbase_") + language(),
                    QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_ofQt);
    QCoreApplication::installTranslator(&m_ours);
}

/// Without a file for the country the language's is taken: QTranslator cuts at underscores.
bool Translation::load(QString language)
{
    return m_ours.load(QStringLiteral("pixelplumb_") + language.replace(u'-', u'_'),
                       QStringLiteral(":/i18n"));
}

} // namespace pixelplumb
