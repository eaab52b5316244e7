// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/manual.h"

#include "widgets/look/parts.h"

#include <QtWidgets>

#include <algorithm>

namespace pixelplumb {

namespace {

QString textOf(const QString &document)
{
    QFile file(QStringLiteral(":/manual/") + document);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

Manual::Manual(const QList<ManualPage> &pages, QWidget *parent)
    : QDialog(parent)
    , m_pages(pages)
    , m_list(new QListWidget(this))
    , m_text(new QTextBrowser(this))
{
    setObjectName(QStringLiteral("manual"));
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
    pages += {{Manual::tr("Terms"), QStringLiteral("glossary.md"), {}},
              {Manual::tr("Scene files"), QStringLiteral("scene-file.md"), {}},
              {Manual::tr("Assignments"), QStringLiteral("assignment-file.md"), {}},
              {Manual::tr("Students' programs"), QStringLiteral("student-program.md"), {}},
              {Manual::tr("Misprints of the course texts"), QStringLiteral("misprints.md"), {}},
              {Manual::tr("Sources"), QStringLiteral("sources.md"), {}},
              {Manual::tr("Proofs"), QStringLiteral("numerics.md"), {}}};
    return pages;
}

} // namespace pixelplumb
