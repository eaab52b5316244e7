// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/translation.h"

#include <QCoreApplication>
#include <QLibraryInfo>

#include <algorithm>

namespace pixelplumb {

Translation::Translation(const QStringList &languages)
{
    // English has a file too, so that a person who prefers it to German gets it.
    const auto loads = [this](const QString &language) { return load(language); };
    if (!std::ranges::any_of(languages, loads))
        load(QStringLiteral("en"));
    // Qt's texts use the language of ours, not a less preferred one.
    if (m_ofQt.load(QStringLiteral("qtbase_") + language(),
                    QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_ofQt);
    QCoreApplication::installTranslator(&m_ours);
}

/// Without a file for the country the language's is loaded: QTranslator cuts at underscores.
bool Translation::load(QString language)
{
    return m_ours.load(QStringLiteral("pixelplumb_") + language.replace(u'-', u'_'),
                       QStringLiteral(":/i18n"));
}

} // namespace pixelplumb
