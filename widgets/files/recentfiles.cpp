// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/recentfiles.h"

#include "core/scene/files/fileaccess.h"
#include "core/scene/scenefile.h"
#include "widgets/look/menuaction.h"
#include "widgets/look/parts.h"
#include "widgets/look/typesetting.h"

namespace pixelplumb {

namespace {

constexpr auto key = "recentFiles";

/// On entering the second span of a second part, whose edges both step; else the middle one of the
/// run.
std::size_t halfDrawn(const ScanTrace &trace)
{
    const std::size_t spans = trace.spanCount();
    for (std::size_t span = 1; span < spans; ++span) {
        if (trace.placeOf(span).part == 1 && trace.placeOf(span - 1).part == 1
            && trace.endSampleOf(span) > trace.firstSampleOf(span))
            return trace.indexOfSpan(span) + 1;
    }
    return spans > 0 ? trace.indexOfSpan(spans / 2) + 1 : trace.stepCount() / 2;
}

std::size_t justEntered(std::int64_t x, const ScanTrace &trace)
{
    for (std::size_t span = 0; span < trace.spanCount(); ++span) {
        const SpanPlace &place = trace.placeOf(span);
        if (place.axis == SpanAxis::Column && place.coordinate == x)
            return trace.indexOfSpan(span) + 1;
    }
    return trace.stepCount();
}

} // namespace

RecentFiles::RecentFiles(QObject *parent)
    : QObject(parent)
    , m_paths(QSettings().value(QLatin1String(key)).toStringList())
{
}

QMenu *RecentFiles::createMenu(QWidget *parent)
{
    auto *menu = named(new QMenu(tr("Open &recent"), parent), "recentMenu");
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fill(menu); });
    fill(menu);
    keepUpdated(this, &RecentFiles::changed, menu,
                [this, menu] { menu->menuAction()->setEnabled(!m_paths.isEmpty()); });
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

void RecentFiles::store()
{
    QSettings().setValue(QLatin1String(key), m_paths);
    emit changed();
}

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
    menu->addAction(tr("&Clear the list"), this, &RecentFiles::clear);
}

std::size_t positionOf(const OpeningPlace &place, const ScanTrace &trace)
{
    if (const auto *position = std::get_if<std::size_t>(&place))
        return std::min(*position, trace.stepCount());
    if (const auto *column = std::get_if<OpeningColumn>(&place))
        return justEntered(column->x, trace);
    return std::get<OpeningMoment>(place) == OpeningMoment::HalfDrawn ? halfDrawn(trace)
                                                                      : trace.stepCount();
}

FileWatch::FileWatch()
{
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &FileWatch::look);
}

void FileWatch::follow(const QString &path)
{
    m_path = path;
    if (const QStringList watched = m_watcher.files(); !watched.isEmpty())
        m_watcher.removePaths(watched);
    const bool isInFolder = !path.isEmpty() && !path.startsWith(u':');
    m_writtenAt = isInFolder ? QFileInfo(path).lastModified() : QDateTime();
    if (m_writtenAt.isValid())
        m_watcher.addPath(path);
}

void FileWatch::look()
{
    const QDateTime writtenAt = QFileInfo(m_path).lastModified();
    if (!writtenAt.isValid() || writtenAt == m_writtenAt)
        return;
    follow(m_path); // a file that replaced it is another file
    emit written();
}

std::optional<InputError> writeDocument(const QString &path, const Scene &scene)
{
    return writeFile(path, writeScene(scene, QFileInfo(path).absolutePath()), WrittenAs::Document);
}

QString documentsFolder()
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

} // namespace pixelplumb
