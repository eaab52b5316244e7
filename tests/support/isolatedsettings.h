// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace pixelplumb {

using namespace Qt::StringLiterals;

/// Private settings for a test: empty at first and deleted afterwards. The user's settings are
/// never touched.
class IsolatedSettings {
public:
    IsolatedSettings()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(u"PixelplumbTest"_s);
        QCoreApplication::setApplicationName(u"pixelplumb-test"_s);
        for (const QSettings::Format format : {QSettings::NativeFormat, QSettings::IniFormat})
            QSettings::setPath(format, QSettings::UserScope, m_folder.path());
    }

    QString folder() const { return m_folder.path(); }
    void clear() { QSettings().clear(); }

private:
    QTemporaryDir m_folder;
};

} // namespace pixelplumb
