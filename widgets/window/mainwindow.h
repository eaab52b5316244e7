// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/files/inputrecord.h"
#include "widgets/files/recentfiles.h"
#include "widgets/window/windowparts.h"

#include <QtWidgets>

#include <memory>
#include <optional>

namespace pixelplumb {

class Autosave;
class ColourButton;
class EditMenu;
class PaletteSwitch;
class ViewMenu;
class WindowDocks;
class WindowSettings;
struct UnsavedScene;

/// The window: it makes the parts, places and connects them, and does nothing else.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget *parent = nullptr);
    ~MainWindow() override;

    const WindowParts &parts() const { return m_parts; }
    PaletteSwitch *palettes() const { return m_palettes; }

    /// Opens the scene of a first start, half drawn.
    void openDefaultScene();
    /// Opens a file; false, after a complaint in the message bar, when it cannot be read.
    bool openScene(const QString &path);
    /// Opens a folder of grading results in the panel Grading. If it holds none, a complaint
    /// appears later in the message bar.
    void openResults(const QString &folder);
    /// Offers to recover what an earlier run, which did not end cleanly, left unsaved.
    void offerRecovery();
    /// The first time that the program is started: tells the keys that a student needs.
    void greet();
    /// Sets the playhead's place for when the scene being opened has been traced.
    void setOpeningPlace(const OpeningPlace &place);

    /// The menu of panels and tool bars, over their titles; a panel chosen there is shown in the
    /// current workspace.
    QMenu *createPopupMenu() override;

protected:
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void commitData(QSessionManager &session);
    void makeParts();
    void makeCentre();
    void makeToolBars();
    void makeMenus();
    void connectParts();
    void traceDocument();
    void takeTrace(const std::shared_ptr<const TracedScene> &traced);
    void goToOpeningPlace();
    void giveKeysToTheScene();
    void recover(const UnsavedScene &left);
    void updateTitle();

    InputRecord m_inputs; ///< outlives all reading and writing here
    WindowParts m_parts;
    PaletteSwitch *m_palettes = nullptr;
    WindowDocks *m_docks = nullptr;
    EditMenu *m_editMenu = nullptr;
    ViewMenu *m_viewMenu = nullptr;
    ColourButton *m_nextColour = nullptr;
    std::unique_ptr<WindowSettings> m_settings;
    Autosave *m_autosave = nullptr;
    std::optional<OpeningPlace> m_openingPlace;
};

} // namespace pixelplumb
