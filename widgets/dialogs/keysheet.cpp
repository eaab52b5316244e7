// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/keysheet.h"

#include <QAction>
#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QMenu>
#include <QTextBrowser>

namespace pixelplumb {

namespace {

QString plainText(QString text)
{
    text.remove(QLatin1Char('&'));
    if (text.endsWith(QChar(0x2026))) // …
        text.chop(1);
    return text.toHtmlEscaped();
}

QString rowsOf(const QMenu *menu)
{
    QString rows;
    const QList<QAction *> actions = menu->actions();
    for (const QAction *action : actions) {
        if (action->menu()) {
            rows += rowsOf(action->menu());
            continue;
        }
        QStringList keys;
        const QList<QKeySequence> shortcuts = action->shortcuts();
        for (const QKeySequence &key : shortcuts)
            keys += key.toString(QKeySequence::NativeText).toHtmlEscaped();
        if (keys.isEmpty())
            continue;
        const bool isCanvasKey = action->shortcutContext() != Qt::WindowShortcut
            && action->shortcutContext() != Qt::ApplicationShortcut;
        rows += QStringLiteral("<tr><td width=\"150\"><b>%1</b></td><td>%2</td>"
                               "<td>&nbsp;&nbsp;%3</td></tr>")
                    .arg(keys.join(QLatin1String(", ")), plainText(action->text()),
                         isCanvasKey ? KeySheet::tr("in the canvas") : QString());
    }
    return rows;
}

} // namespace

KeySheet::KeySheet(const QList<QMenu *> &menus, QWidget *parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("keySheet"));
    setWindowTitle(tr("Keys"));
    auto *sheet = new QTextBrowser(this);
    sheet->setObjectName(QStringLiteral("keySheetText"));
    sheet->setAccessibleName(tr("Keys"));
    sheet->setHtml(keySheetHtml(menus));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(8);
    layout->addWidget(sheet);
    layout->addWidget(buttons);
    resize(560, 640);
}

QString keySheetHtml(const QList<QMenu *> &menus)
{
    QString html;
    for (const QMenu *menu : menus) {
        const QString rows = rowsOf(menu);
        if (!rows.isEmpty())
            html += QStringLiteral("<h3>%1</h3><table cellspacing=\"2\">%2</table>")
                        .arg(plainText(menu->title()), rows);
    }
    return html;
}

} // namespace pixelplumb
