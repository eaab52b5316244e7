// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scenefile.h"

#include <QFutureWatcher>
#include <QObject>

#include <memory>
#include <optional>

namespace pixelplumb {

/// Writes large scenes beside the GUI thread, one at a time.
class SceneSaver : public QObject {
    Q_OBJECT

public:
    /// More take longer to write than a person should wait (some 5 µs each).
    static constexpr std::size_t mostWrittenAtOnce = 5'000;

    explicit SceneSaver(QObject *parent = nullptr);
    ~SceneSaver() override; ///< waits: a file that was promised is written

    static bool isLarge(const Scene &scene)
    {
        return scene.triangles.size() + scene.shapes.size() > mostWrittenAtOnce;
    }
    bool isRunning() const { return m_scene != nullptr; }

public slots:
    /// Nothing may be under way.
    void save(const QString &path, const std::shared_ptr<const pixelplumb::Scene> &scene);

signals:
    void started(const QString &path);
    void finished(const QString &path, const std::shared_ptr<const pixelplumb::Scene> &scene,
                  const std::optional<pixelplumb::InputError> &error);

private:
    void finish();

    QFutureWatcher<std::optional<InputError>> m_watcher;
    QString m_path;
    std::shared_ptr<const Scene> m_scene; ///< that is being written
};

} // namespace pixelplumb
