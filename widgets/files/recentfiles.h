// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QStringList>

namespace pixelplumb {

/// The scenes opened or saved last, newest first, kept in QSettings; as a menu.
class RecentFiles : public QObject {
    Q_OBJECT

public:
    static constexpr qsizetype most = 10;

    explicit RecentFiles(QObject *parent = nullptr);

    QStringList paths() const { return m_paths; }
    /// The menu refills whenever it is opened; files that are gone are grey.
    QMenu *createMenu(QWidget *parent);

public slots:
    void add(const QString &path);
    void clear();

signals:
    void chosen(const QString &path);

private:
    void store() const;
    void fill(QMenu *menu);

    QStringList m_paths;
};

} // namespace pixelplumb
