// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/manual.h"

#include "widgets/look/parts.h"

#include <algorithm>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

QString textOf(const QString &document)
{
    QFile file(u":/manual/"_s + document);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
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

} // namespace pixelplumb
