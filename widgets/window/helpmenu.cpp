// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/helpmenu.h"

#include "widgets/dialogs/keysheet.h"
#include "widgets/look/menuaction.h"
#include "widgets/window/whatsthis.h"

#include <QCoreApplication>
#include <QMenuBar>
#include <QMessageBox>
#include <QSysInfo>

namespace pixelplumb {

HelpMenu::HelpMenu(QMenuBar *bar)
    : QMenu(tr("&Help"), bar)
    , m_bar(bar)
{
    setObjectName(QStringLiteral("helpMenu"));
    QAction *keys
        = addMenuAction(this, "showKeys", tr("&Keys and mouse"), {}, [this] { showKeys(); });
    keys->setShortcuts({QKeySequence(Qt::Key_Question), QKeySequence(Qt::Key_F1)});
    QAction *whatsThis
        = addMenuAction(this, "whatsThis", tr("&What's This?"), Qt::SHIFT | Qt::Key_F1,
                        [this] { enterWhatsThis(m_bar->window()); });
    whatsThis->setToolTip(tr("The next click explains the part that is clicked (Shift+F1)"));
    addMenuAction(this, "showAbout", tr("&About Pixelplumb"), {}, [this] { showAbout(); });
}

QList<QMenu *> HelpMenu::menus() const
{
    QList<QMenu *> menus;
    for (const QAction *action : m_bar->actions()) {
        if (action->menu())
            menus += action->menu();
    }
    return menus;
}

void HelpMenu::showKeys()
{
    auto *sheet = new KeySheet(menus(), m_bar->window());
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->show();
}

void HelpMenu::showAbout()
{
    QMessageBox about(
        QMessageBox::NoIcon, tr("About Pixelplumb"),
        tr("<h3>Pixelplumb %1</h3><p>See, step through, measure and grade triangle scan "
           "conversion.</p><p>Qt %2, %3, %4</p><p>Licence: GPL-3.0-or-later. It uses no network "
           "and "
           "sends nothing.</p>")
            .arg(QCoreApplication::applicationVersion(), QLatin1String(qVersion()),
                 QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture()),
        QMessageBox::Close, m_bar->window());
    about.setObjectName(QStringLiteral("about"));
    about.setIconPixmap(m_bar->window()->windowIcon().pixmap(64));
    about.setTextInteractionFlags(Qt::TextBrowserInteraction); // to copy it into a report
    about.exec();
}

} // namespace pixelplumb
