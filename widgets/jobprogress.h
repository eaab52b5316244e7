// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;

namespace pixelplumb {

class SceneLoader;
class SceneSaver;
class SceneTracer;

/// How far some work beside the window is, and a button that ends it; hidden when there is none.
class JobProgress : public QWidget {
    Q_OBJECT

public:
    /// Object names of the bar and the button, and what a screen reader says of them. No button
    /// where it has no name.
    struct Names {
        QString bar;
        QString barInWords;
        QString cancel;
        QString cancelInWords;
    };

    explicit JobProgress(const Names &names, QWidget *parent = nullptr);

public slots:
    void begin(const QString &title);
    void setPercent(int percent);
    void setBusy(); ///< under way, but nobody knows how far
    void end();

signals:
    void cancelRequested();

private:
    QLabel *m_title;
    QProgressBar *m_bar;
};

/// Of the tracing of the scene: `traceProgress`, `cancelTrace`.
JobProgress *progressOf(SceneTracer *tracer, QWidget *parent = nullptr);
/// Of the reading of a file: `loadProgress`, `cancelLoad`.
JobProgress *progressOf(SceneLoader *loader, QWidget *parent = nullptr);
/// Of the writing of a file: `saveProgress`; how far it is, nobody knows.
JobProgress *progressOf(SceneSaver *saver, QWidget *parent = nullptr);

} // namespace pixelplumb
