// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/manual.h"

#include "widgets/look/displayoptions.h"
#include "widgets/look/menuaction.h"
#include "widgets/look/parts.h"

#include <algorithm>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// A document's Markdown without the lines that name tests of the source tree.
QString textOf(const QString &document)
{
    QFile file(u":/manual/"_s + document);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    static const QRegularExpression tests(u"^(- )?\\*\\*Tests?:\\*\\*.*\\n(  \\S.*\\n)*"_s,
                                          QRegularExpression::MultilineOption);
    return QString::fromUtf8(file.readAll()).remove(tests);
}

QString plainText(const QString &text) { return withoutMnemonic(text).toHtmlEscaped(); }

QString row(const QString &keys, const QString &meaning, const QString &where = {})
{
    return u"<tr><td width=\"190\"><b>%1</b></td><td>%2</td>"
           "<td>&nbsp;&nbsp;%3</td></tr>"_s.arg(keys, meaning, where);
}

QString section(const QString &title, const QString &rows)
{
    return u"<h3>%1</h3><table cellspacing=\"2\">%2</table>"_s.arg(title, rows);
}

QString rowsOf(const QMenu *menu)
{
    QString rows;
    for (const QAction *action : actionsIn(*menu)) {
        QStringList keys;
        const QList<QKeySequence> shortcuts = action->shortcuts();
        for (const QKeySequence &key : shortcuts)
            keys += key.toString(QKeySequence::NativeText).toHtmlEscaped();
        if (keys.isEmpty())
            continue;
        const bool isCanvasKey = action->shortcutContext() != Qt::WindowShortcut
            && action->shortcutContext() != Qt::ApplicationShortcut;
        rows += row(keys.join(QLatin1String(", ")), listedText(*action).toHtmlEscaped(),
                    isCanvasKey ? KeySheet::tr("in the canvas") : QString());
    }
    return rows;
}

/// The mouse actions on the canvas, which no menu shows.
QString mouseRows()
{
    return row(KeySheet::tr("Point"),
               KeySheet::tr("Read the pixel, its painter and the nearest edge"))
        + row(KeySheet::tr("Click"), KeySheet::tr("Place a vertex"), KeySheet::tr("Draw"))
        + row(KeySheet::tr("Click on a vertex"),
              KeySheet::tr(
                  "Select it; once more, or while a figure is drawn, place the next vertex "
                  "on it"),
              KeySheet::tr("Draw"))
        + row(KeySheet::tr("Drag a vertex"), KeySheet::tr("Move it"), KeySheet::tr("Draw"))
        + row(KeySheet::tr("Double click on a vertex"), KeySheet::tr("Choose its colour"),
              KeySheet::tr("Draw"))
        + row(KeySheet::tr("Click, drag"), KeySheet::tr("Pick the pixel"), KeySheet::tr("Inspect"))
        + row(KeySheet::tr("Right click"), KeySheet::tr("Pick the pixel; on a vertex, its menu"))
        + row(KeySheet::tr("Wheel"), KeySheet::tr("Zoom"))
        + row(KeySheet::tr("Middle drag, Ctrl+drag"), KeySheet::tr("Move the view"))
        + row(KeySheet::tr("Click, drag on the ruler"), KeySheet::tr("Go to the column"))
        + row(KeySheet::tr("Right or double click on the ruler"),
              KeySheet::tr("Breakpoint on the column"))
        + row(KeySheet::tr("Hold Shift alone"),
              KeySheet::tr("See the truth, or what a student should have drawn, after %1 s")
                  .arg(double(peekDelay.count()) / 1000))
        + row(KeySheet::tr("Esc"), KeySheet::tr("Cancel the drag, or discard unfinished vertices"));
}

/// The canvas keys that no menu shows: they draw without a mouse.
QString canvasKeyRows()
{
    return row(KeySheet::tr("Arrows"), KeySheet::tr("Move the picked pixel"))
        + row(KeySheet::tr("Enter, Ins"),
              KeySheet::tr(
                  "Place a vertex at the picked pixel (Ctrl+G goes to one by its numbers)"))
        + row(KeySheet::tr("[, ]"), KeySheet::tr("Select the previous, the next vertex"))
        + row(KeySheet::tr("Ctrl+arrows"), KeySheet::tr("Move the selected vertex"))
        + row(KeySheet::tr("Enter, C"), KeySheet::tr("Colour of the selected vertex"))
        + row(KeySheet::tr("Esc"),
              KeySheet::tr("Discard the unfinished vertices; no vertex is selected then"))
        + row(KeySheet::tr("+, −, 0"), KeySheet::tr("Zoom in, out, see the whole frame"))
        + row(KeySheet::tr("Shift+arrows"), KeySheet::tr("Move the view"));
}

} // namespace

Manual::Manual(const QList<ManualPage> &pages, QWidget *parent)
    : QDialog(parent)
    , m_pages(pages)
    , m_list(new QListWidget(this))
    , m_text(new QTextBrowser(this))
{
    setObjectName(u"manual"_s);
    setWindowTitle(tr("Manual"));
    named(m_list, "manualPages", tr("Pages"));
    named(m_text, "manualText", tr("Page"));
    for (const ManualPage &page : m_pages)
        m_list->addItem(page.title);
    m_list->setFixedWidth(m_list->sizeHintForColumn(0) + 2 * m_list->frameWidth() + 16);
    m_text->setOpenLinks(false);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(m_list, &QListWidget::currentRowChanged, this, &Manual::showPage);
    connect(m_text, &QTextBrowser::anchorClicked, this, &Manual::follow);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *row = withParts(new QHBoxLayout, {m_list, {m_text, 1}}, 8);
    withParts(new QVBoxLayout(this), {{row, 1}, buttons}, 8, 16);
    resize(820, 560); // fits the lowest screen
    m_list->setCurrentRow(0);
}

void Manual::showPage(int page)
{
    const ManualPage &shown = m_pages[page];
    if (shown.document.isEmpty())
        m_text->setHtml(shown.html);
    else
        m_text->setMarkdown(textOf(shown.document));
}

/// Links lead to pages; whatever else the documents cite is not part of the program.
void Manual::follow(const QUrl &link)
{
    const auto page = std::ranges::find(m_pages, link.fileName(), &ManualPage::document);
    if (!link.fileName().isEmpty() && page != m_pages.end())
        m_list->setCurrentRow(int(page - m_pages.begin()));
}

QList<ManualPage> manualPages(const QList<ManualPage> &first)
{
    QList<ManualPage> pages = {{Manual::tr("First steps"), Manual::tr("manual.md"), {}}};
    pages += first;
    pages += {{Manual::tr("Terms"), u"glossary.md"_s, {}},
              {Manual::tr("Scene files"), u"scene-file.md"_s, {}},
              {Manual::tr("Assignments"), u"assignment-file.md"_s, {}},
              {Manual::tr("Students' programs"), u"student-program.md"_s, {}},
              {Manual::tr("Misprints of the course texts"), u"misprints.md"_s, {}},
              {Manual::tr("Sources"), u"sources.md"_s, {}},
              {Manual::tr("Proofs"), u"numerics.md"_s, {}}};
    return pages;
}

KeySheet::KeySheet(const QList<QMenu *> &menus, QWidget *parent)
    : QDialog(parent)
{
    setObjectName(u"keySheet"_s);
    setWindowTitle(tr("Keys and mouse"));
    auto *sheet = named(new QTextBrowser(this), "keySheetText", tr("Keys and mouse"));
    sheet->setHtml(keySheetHtml(menus));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    withParts(new QVBoxLayout(this), {sheet, buttons}, 8, 16);
    resize(640, 560); // fits the lowest screen
}

QString keySheetHtml(const QList<QMenu *> &menus)
{
    QString html = section(KeySheet::tr("Mouse, in the canvas"), mouseRows())
        + section(KeySheet::tr("Keys, in the canvas"), canvasKeyRows());
    for (const QMenu *menu : menus) {
        const QString rows = rowsOf(menu);
        if (!rows.isEmpty())
            html += section(plainText(menu->title()), rows);
    }
    return html;
}

} // namespace pixelplumb
