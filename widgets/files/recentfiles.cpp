// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/recentfiles.h"

#include "widgets/look/shownname.h"

#include <QFileInfo>
#include <QSettings>

namespace pixelplumb {

namespace {

constexpr auto key = "recentFiles";

} // namespace

RecentFiles::RecentFiles(QObject *parent)
    : QObject(parent)
    , m_paths(QSettings().value(QLatin1String(key)).toStringList())
{
}

QMenu *RecentFiles::createMenu(QWidget *parent)
{
    auto *menu = new QMenu(tr("Open &recent"), parent);
    menu->setObjectName(QStringLiteral("recentMenu"));
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fill(menu); });
    fill(menu);
    return menu;
}

void RecentFiles::add(const QString &path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    m_paths.removeAll(absolute);
    m_paths.prepend(absolute);
    m_paths = m_paths.first(std::min(m_paths.size(), most));
    store();
}

void RecentFiles::clear()
{
    m_paths.clear();
    store();
}

void RecentFiles::store() const { QSettings().setValue(QLatin1String(key), m_paths); }

void RecentFiles::fill(QMenu *menu)
{
    menu->clear();
    for (const QString &path : std::as_const(m_paths)) {
        QString name = shownName(path);
        QAction *action = menu->addAction(name.replace(QLatin1Char('&'), QLatin1String("&&")));
        action->setToolTip(path);
        action->setEnabled(QFileInfo::exists(path));
        connect(action, &QAction::triggered, this, [this, path] { emit chosen(path); });
    }
    menu->addSeparator();
    QAction *forget = menu->addAction(tr("&Clear the list"));
    forget->setEnabled(!m_paths.isEmpty());
    connect(forget, &QAction::triggered, this, &RecentFiles::clear);
}

} // namespace pixelplumb
