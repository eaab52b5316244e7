// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scenefile.h"

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <memory>

namespace pixelplumb {

/// Reads large scene files beside the GUI thread, one at a time: a newer request cancels an older
/// one, whose scene is dropped.
class SceneLoader : public QObject {
    Q_OBJECT

public:
    using Reading = std::shared_ptr<Result<SceneReading>>;

    explicit SceneLoader(QObject *parent = nullptr);
    ~SceneLoader() override; ///< cancels and waits

    /// Larger files take longer to read than a person should wait (some 16 µs a triangle).
    static constexpr qint64 largestReadAtOnce = qint64(1) << 18; // bytes

    static bool isLarge(const QString &path);
    bool isRunning() const { return !m_path.isEmpty(); }

public slots:
    void load(const QString &path);
    void cancel();

signals:
    void started(const QString &path);
    void progressChanged(int percent);
    /// The scene, or what is wrong with the file. The receiver may take the scene out.
    void finished(const QString &path, const pixelplumb::SceneLoader::Reading &reading);
    void cancelled();

private:
    void start(const QString &path);
    void finish();

    QFutureWatcher<Reading> m_watcher;
    QString m_path; ///< of the file that is being read; empty when none is
    QString m_next; ///< waits for the cancelled reading to end
    QTimer m_progressTimer;
    // Shared with the worker.
    std::atomic<bool> m_cancelled = false;
    std::atomic<int> m_percent = 0;
};

} // namespace pixelplumb
