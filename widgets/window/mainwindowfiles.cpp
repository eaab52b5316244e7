// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenefile.h"
#include "widgets/canvas/canvas.h"
#include "widgets/files/autosave.h"
#include "widgets/files/scenefiles.h"
#include "widgets/files/studentpicturefiles.h"
#include "widgets/look/messagebar.h"
#include "widgets/look/parts.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenetracer.h"
#include "widgets/studies/grade/gradebook.h"
#include "widgets/studies/grade/gradingpanel.h"
#include "widgets/window/mainwindow.h"
#include "widgets/window/windowdocks.h"
#include "widgets/window/windowsettings.h"

#include <QtWidgets>

/// How scenes and grades come into the window, and what happens to them when it closes.
namespace pixelplumb {

namespace {

QString textOf(const UnsavedScene &left)
{
    const QString time = QLocale::system().toString(left.time, QLocale::ShortFormat);
    return left.sceneFile.isEmpty()
        ? MainWindow::tr("The program ended without saving a scene, last changed %1.").arg(time)
        : MainWindow::tr("The program ended without saving “%1”, last changed %2.")
              .arg(shownName(left.sceneFile), time);
}

} // namespace

void MainWindow::openDefaultScene()
{
    m_openingPlace = OpeningMoment::HalfDrawn;
    m_parts.files->loadDefault();
}

bool MainWindow::openScene(const QString &path) { return m_parts.files->load(path); }

void MainWindow::openResults(const QString &folder)
{
    // A window not shown yet has no tabs to bring to the front.
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_docks->raise<GradingPanel>()->setFocus(); // for the keys of its table
        },
        Qt::QueuedConnection);
    m_docks->panel<GradingPanel>()->book()->open(folder);
}

void MainWindow::setOpeningPlace(const OpeningPlace &place)
{
    m_openingPlace = place;
    if (!m_parts.tracer->isRunning() && m_parts.playhead->traced())
        goToOpeningPlace();
}

void MainWindow::goToOpeningPlace()
{
    if (!m_openingPlace)
        return;
    m_parts.playhead->seek(positionOf(*m_openingPlace, *m_parts.playhead->traced()->trace));
    m_openingPlace.reset();
}

/// Gives the canvas the focus when a scene arrives, whichever panel had it, except the grading
/// panel, whose keys move between submissions, each of which opens its scene.
void MainWindow::giveKeysToTheScene()
{
    const QWidget *current = focusWidget();
    if (!current || !m_docks->dockOf<GradingPanel>()->isAncestorOf(current))
        m_parts.canvas->setFocus();
}

void MainWindow::offerRecovery()
{
    const std::optional<UnsavedScene> left = m_autosave->leftBehind();
    if (!left)
        return;
    auto *box = named(new QMessageBox(QMessageBox::Question, tr("Unsaved Scene"), textOf(*left),
                                      QMessageBox::NoButton, this),
                      "recoveryDialog");
    box->setTextFormat(Qt::PlainText); // a name may look like HTML
    box->setInformativeText(tr("The recovered scene has no file yet: save it to keep it."));
    const QPushButton *yes = box->addButton(tr("&Recover"), QMessageBox::AcceptRole);
    const QPushButton *no = box->addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    box->setEscapeButton(box->addButton(tr("&Later"), QMessageBox::RejectRole));
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(box, &QMessageBox::finished, this, [this, box, yes, no, left = *left] {
        if (box->clickedButton() == yes) {
            recover(left);
        } else if (box->clickedButton() == no) {
            Autosave::discard(left);
            offerRecovery(); // there may be more
        }
    });
    box->open();
}

void MainWindow::greet()
{
    QSettings settings;
    const QLatin1String key("window/greeted");
    if (settings.value(key).toBool())
        return;
    settings.setValue(key, true);
    const auto picture = [canvas = m_parts.canvas] {
        const ViewMapping &mapping = canvas->mapping();
        const QRect frame = mapping.devicePicture();
        return QRectF(mapping.positionOfDevice(frame.topLeft()),
                      mapping.positionOfDevice(frame.bottomRight()))
            .toRect();
    };
    m_parts.messageBar->tellBeside(
        picture,
        QStringList{tr("F10: the next column"), tr("F11: the next pixel"),
                    tr("P: draw; a click places a vertex"), tr("V: inspect; a click picks a pixel")}
            .join(u'\n'));
}

void MainWindow::recover(const UnsavedScene &left)
{
    m_parts.files->recover(left.path, [this, left] { m_autosave->adopt(left); });
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!m_parts.files->mayReplace()) {
        event->ignore();
        return;
    }
    m_settings->store();
    event->accept();
}

/// The desktop session ends. Where questions are not allowed, the autosave remains, as after a
/// crash.
void MainWindow::commitData(QSessionManager &session)
{
    if (session.allowsInteraction()) {
        const bool mayEnd = m_parts.files->mayReplace();
        session.release();
        if (!mayEnd)
            return session.cancel();
    }
    m_settings->store();
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event)
{
    if (!sceneFileOf(*event->mimeData()).isEmpty() || !folderOf(*event->mimeData()).isEmpty()
        || StudentPictureFiles::accepts(*event->mimeData()))
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent *event)
{
    const QString path = sceneFileOf(*event->mimeData());
    const QString folder = folderOf(*event->mimeData());
    if (!path.isEmpty())
        m_parts.files->openFile(path);
    else if (!folder.isEmpty())
        openResults(folder);
    else
        m_parts.pictures->take(*event->mimeData());
}

} // namespace pixelplumb
