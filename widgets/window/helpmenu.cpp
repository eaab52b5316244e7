// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/helpmenu.h"

#include "widgets/dialogs/keysheet.h"
#include "widgets/look/menuaction.h"

#include <QCoreApplication>
#include <QMenuBar>
#include <QMessageBox>

namespace pixelplumb {

HelpMenu::HelpMenu(QMenuBar *bar)
    : QMenu(tr("&Help"), bar)
{
    setObjectName(QStringLiteral("helpMenu"));
    QAction *keys = addMenuAction(this, "showKeys", tr("&Keys and mouse"), {},
                                  [this, bar] { showKeys(bar); });
    keys->setShortcuts({QKeySequence(Qt::Key_Question), QKeySequence(Qt::Key_F1)});
    addMenuAction(this, "showAbout", tr("&About Pixelplumb"), {}, [this] { showAbout(); });
}

void HelpMenu::showKeys(const QMenuBar *bar)
{
    QList<QMenu *> menus;
    for (const QAction *action : bar->actions()) {
        if (action->menu())
            menus += action->menu();
    }
    auto *sheet = new KeySheet(menus, parentWidget()->window());
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->show();
}

void HelpMenu::showAbout()
{
    QMessageBox::about(parentWidget()->window(), tr("About Pixelplumb"),
                       tr("<h3>Pixelplumb %1</h3><p>See, step through, measure and grade triangle "
                          "scan conversion.</p><p>Licence: GPL-3.0-or-later.</p>")
                           .arg(QCoreApplication::applicationVersion()));
}

} // namespace pixelplumb
